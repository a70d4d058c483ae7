// One collision of two disks written out as a derivation with the user's own numbers.
#pragma once

#include <optional>
#include <string>

#include "carom/base/vec2.hpp"

namespace carom {

/// A disk at the moment of contact, before the collision. Any consistent units.
struct ExplainedDisk {
  Vec2 position;                 ///< of the centre (length)
  Vec2 velocity;                 ///< before the collision (length/time)
  double mass = 1;               ///< positive and finite
  std::optional<double> radius;  ///< positive (length); absent: the disks touch where they stand
};

/// A collision to be explained.
struct ExplainedCollision {
  ExplainedDisk first;
  ExplainedDisk second;
  double restitution = 1;      ///< e in [0, 1]
  double time_of_contact = 0;  ///< since the disks were started; above 0 the positions count as computed, not given
};

/// What the derivation is written for: an 80-column terminal, Markdown with $$ mathematics, or a LaTeX document.
enum class ExplainFormat { text, markdown, latex };

/// The whole derivation under the equation numbers of the source text (1–6, and A–D for equal masses and e = 1).
/// Every line can be redone from the numbers printed above it: `=` is exact, `≈` is rounded. The three formats hold
/// the same numbers. Throws Error where a number is out of range or the centres coincide.
std::string explain(const ExplainedCollision& collision, ExplainFormat format);

}  // namespace carom
