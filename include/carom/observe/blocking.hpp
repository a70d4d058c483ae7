// The error of the mean of correlated samples.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "carom/run/sums.hpp"

namespace carom {

/// Blocking after Flyvbjerg and Petersen (J. Chem. Phys. 91, 461 (1989)): samples are averaged in pairs, the averages
/// again, and so on. The error of the mean, computed from the averages as if they were independent, grows from level to
/// level until blocks are longer than the correlation, and stays from there on. Keeps three numbers per level.
///
/// The plateau: the first level whose block length B fulfils B³ > 2 n (e_B/e_1)⁴, n samples in all, e_B the error seen
/// with blocks of B samples; there the error that correlation still hides is as small as the statistical one
/// (Lee, Conduit, Nemec, López Ríos and Drummond, Phys. Rev. E 83, 066706 (2011)).
class Blocking {
 public:
  void add(double sample);

  struct Result {
    double mean = 0;  ///< NaN without samples
    /// One standard error of the mean. If no plateau was found, the largest one seen: the true one is not smaller.
    /// Absent for fewer than 4 samples.
    std::optional<double> error = {};
    std::uint64_t samples = 0;
    std::uint64_t blocks = 0;  ///< at the plateau; 0 if there is none
    double correlation = 0;    ///< Σ ρ(k) over k ≥ 1: the correlation time in samples; 0 if they are independent
  };
  /// A plateau counts only if it has at least kFewestBlocks blocks.
  [[nodiscard]] Result result() const;

  void exchange(SumsExchange sums);

  static constexpr std::int64_t kFewestBlocks = 16;

 private:
  // By level; blocks of level l hold 2^l samples.
  std::vector<std::int64_t> count_;  // of whole blocks
  std::vector<double> mean_;
  std::vector<double> squares_;  // Σ (block − mean)²
  std::vector<double> waiting_;  // a block without partner yet, where count_ is odd
};

}  // namespace carom
