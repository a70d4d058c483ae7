// The Kolmogorov–Smirnov test for samples whose energy is given.
#pragma once

namespace carom {

struct KolmogorovTest {
  double distance = 0;  ///< largest difference of measured and expected distribution function
  double p_value = 0;   ///< chance of a larger one
};

/// Chance that `samples` values of an exponential distribution, scaled such that their mean is exact, are farther than
/// `distance` from its distribution function: Kolmogorov's test with an estimated mean (Lilliefors, J. Am. Stat. Assoc.
/// 64, 387 (1969)), with Stephens' correction for finite samples (J. Am. Stat. Assoc. 69, 730 (1974)). Energies ½ m v²
/// of disks in two dimensions are exponentially distributed, and their mean is that of the frame.
double p_value_of_exponential(double distance, double samples);

}  // namespace carom
