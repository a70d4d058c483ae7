#include "kolmogorov.hpp"
namespace carom {
double p_value_of_exponential(double, double) { return 0; }
}  // namespace carom
