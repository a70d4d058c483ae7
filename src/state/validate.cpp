#include "carom/state/validate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "overlap_grid.hpp"

namespace carom {
namespace {

using About = Finding::About;

constexpr std::size_t kMostOfAKind = 20;
constexpr std::size_t kMostCounted = 100'000;  // of n disks at one place n²/2 pairs overlap
/// Beyond these, squares and products of lengths leave the range of doubles.
constexpr double kLargest = 1e75;
constexpr double kSmallest = 1e-75;

/// Findings of one kind: the first ones in full, the rest as a number.
class Kind {
 public:
  explicit Kind(std::vector<Finding>& findings, std::string_view rest) : findings_(findings), rest_(rest) {}
  ~Kind() {
    if (found_ <= kMostOfAKind) return;
    const std::string_view how_many = cut_short_ ? "at least " : "";
    findings_.push_back({fmt::format("… and {}{} more {}", how_many, found_ - kMostOfAKind, rest_), {}});
  }
  Kind(const Kind&) = delete;
  Kind& operator=(const Kind&) = delete;

  void add(std::string message, std::optional<std::size_t> disk = {}) {
    if (++found_ <= kMostOfAKind) findings_.push_back({std::move(message), disk});
  }

  [[nodiscard]] std::size_t count() const noexcept { return found_; }
  /// There may be more than were found.
  void cut_short() noexcept { cut_short_ = true; }

 private:
  std::vector<Finding>& findings_;
  std::string_view rest_;
  std::size_t found_ = 0;
  bool cut_short_ = false;
};

bool usable(double value) noexcept { return std::isfinite(value) && std::abs(value) <= kLargest; }
bool usable_positive(double value) noexcept { return usable(value) && value >= kSmallest; }

std::string reason_against_positive(double value) {
  if (std::isnan(value) || std::isinf(value)) return "must be a finite number";
  if (value <= 0) return "must be greater than 0";
  return value > kLargest ? "is too large to compute with (over 1e75)" : "is too small to compute with (under 1e-75)";
}

std::string reason_against(double value) {
  return std::isfinite(value) ? "is too large to compute with (over 1e75)" : "must be a finite number";
}

void check_box(const Box& box, std::vector<Finding>& findings) {
  constexpr std::array<std::string_view, 2> kExtent{"width", "height"};
  for (int axis = 0; axis < 2; ++axis) {
    const double size = axis == 0 ? box.size.x : box.size.y;
    const bool open = box.boundary[axis] == Boundary::open;
    if (usable_positive(size) || (open && size == 0)) continue;
    findings.push_back(
        {fmt::format("the box's {} is {}: it {}", kExtent[axis], size, reason_against_positive(size)), {}, About::box});
  }
}

void check_physics(const Physics& physics, std::vector<Finding>& findings) {
  const auto check_restitution = [&](std::string_view name, double e) {
    if (e >= 0 && e <= 1) return;
    findings.push_back({fmt::format("{} is {}: it must lie in [0, 1]", name, e), {}, About::physics});
  };
  check_restitution("restitution", physics.restitution);
  check_restitution("wall_restitution", physics.wall_restitution);
  if (!(physics.t_c >= 0 && usable(physics.t_c))) {
    findings.push_back(
        {fmt::format("t_c is {}: it must be a finite time, 0 or more", physics.t_c), {}, About::physics});
  }
}

void check_numbers(const System& system, const Frame& frame, std::vector<Finding>& findings) {
  Kind kind(findings, "numbers that cannot be used");
  for (std::size_t k = 0; k < system.size(); ++k) {
    const auto check = [&](std::string_view name, double value, bool positive) {
      if (positive ? usable_positive(value) : usable(value)) return;
      const std::string reason = positive ? reason_against_positive(value) : reason_against(value);
      kind.add(fmt::format("{} of disk {} is {}: it {}", name, k, value, reason), k);
    };
    check("radius", system.radius(k), true);
    check("mass", system.mass(k), true);
    check("x", frame.x[k], false);
    check("y", frame.y[k], false);
    check("vx", frame.vx[k], false);
    check("vy", frame.vy[k], false);
  }
}

/// Returns which disks are outside.
std::vector<bool> check_inside(const System& system, const Frame& frame, std::vector<Finding>& findings) {
  Kind kind(findings, "disks outside the box");
  std::vector<bool> outside(system.size(), false);
  const Box& box = system.box;
  const auto check = [&](std::size_t k, int axis, double coordinate, double size) {
    if (box.boundary[axis] == Boundary::open) return;
    const double radius = system.radius(k);
    const double margin = box.reflecting(axis) ? radius * (1 - kOverlapTolerance) : -radius * kOverlapTolerance;
    const double below = margin - coordinate;
    const double above = coordinate - (size - margin);
    if (below <= 0 && above <= 0) return;
    outside[k] = true;
    constexpr std::array<std::array<std::string_view, 2>, 2> kSide{{{"left", "right"}, {"bottom", "top"}}};
    const std::string_view what = box.reflecting(axis) ? "wall" : "edge";
    kind.add(fmt::format("disk {} is outside the box: it reaches {:.3g} past the {} {}", k, std::max(below, above),
                         kSide[axis][below > 0 ? 0 : 1], what),
             k);
  };
  for (std::size_t k = 0; k < system.size(); ++k) {
    check(k, 0, frame.x[k], box.size.x);
    check(k, 1, frame.y[k], box.size.y);
  }
  return outside;
}

/// Returns whether the box is wide enough.
bool check_periodic_width(const System& system, std::vector<Finding>& findings) {
  bool wide_enough = true;
  const double diameter = 2 * system.largest_radius();
  for (int axis = 0; axis < 2; ++axis) {
    const double size = axis == 0 ? system.box.size.x : system.box.size.y;
    if (!system.box.periodic(axis) || size >= diameter) continue;
    wide_enough = false;
    findings.push_back({fmt::format("the periodic box is {} {}, narrower than the largest disk's diameter {}", size,
                                    axis == 0 ? "wide" : "high", diameter),
                        {},
                        About::box});
  }
  return wide_enough;
}

OverlapGrid::Extent extent_of(const Box& box, const Frame& frame) {
  OverlapGrid::Extent extent{{frame.x[0], frame.y[0]}, {frame.x[0], frame.y[0]}};
  for (std::size_t k = 0; k < frame.size(); ++k) {
    extent.low = {std::min(extent.low.x, frame.x[k]), std::min(extent.low.y, frame.y[k])};
    extent.high = {std::max(extent.high.x, frame.x[k]), std::max(extent.high.y, frame.y[k])};
  }
  if (box.periodic(0)) extent.low.x = 0, extent.high.x = box.size.x;
  if (box.periodic(1)) extent.low.y = 0, extent.high.y = box.size.y;
  return extent;
}

OverlapGrid::Radii radii_of(const System& system) {
  OverlapGrid::Radii radii{system.largest_radius(), system.largest_radius()};
  for (const Species& kind : system.species) radii.smallest = std::min(radii.smallest, kind.radius);
  return radii;
}

/// The copy of an earlier disk that overlaps deepest with disk k.
struct Overlap {
  std::size_t other;
  double depth;
  bool coincident;
};

std::string describe(const Overlap& overlap, std::size_t k, double sigma) {
  if (overlap.coincident) return fmt::format("disk {} and disk {} have the same centre", overlap.other, k);
  return fmt::format("disk {} and disk {} overlap by {:.3g} (contact distance {})", overlap.other, k, overlap.depth,
                     sigma);
}

void check_overlaps(const System& system, const Frame& frame, const std::vector<bool>& outside,
                    std::vector<Finding>& findings) {
  Kind kind(findings, "overlaps");
  OverlapGrid grid(system.box, extent_of(system.box, frame), radii_of(system), system.size());
  std::vector<Overlap> overlaps;
  for (std::size_t k = 0; k < system.size(); ++k) {
    if (kind.count() >= kMostCounted) return kind.cut_short();
    if (outside[k]) continue;
    overlaps.clear();
    grid.visit_near(frame.position(k), system.radius(k), [&](std::size_t other, Vec2 r) {
      const double sigma = system.radius(k) + system.radius(other);
      const double depth = sigma - length(r);
      if (!(depth > kOverlapTolerance * sigma)) return;
      const auto known =
          std::find_if(overlaps.begin(), overlaps.end(), [&](const Overlap& o) { return o.other == other; });
      const Overlap found{other, depth, r == Vec2{}};
      if (known == overlaps.end()) {
        overlaps.push_back(found);
      } else if (known->depth < depth) {
        *known = found;
      }
    });
    std::sort(overlaps.begin(), overlaps.end(), [](const Overlap& a, const Overlap& b) { return a.other < b.other; });
    for (const Overlap& overlap : overlaps) {
      kind.add(describe(overlap, k, system.radius(k) + system.radius(overlap.other)), k);
    }
    grid.insert(k, frame.position(k), system.radius(k));
  }
}

bool have_one_size(const System& system, const Frame& frame) {
  const std::size_t count = system.size();
  const bool same = frame.x.size() == count && frame.y.size() == count && frame.vx.size() == count &&
                    frame.vy.size() == count && frame.winding_x.size() == count && frame.winding_y.size() == count;
  return same && std::all_of(system.species_of.begin(), system.species_of.end(),
                             [&](std::uint32_t kind) { return kind < system.species.size(); });
}

}  // namespace

std::vector<Finding> validate(const System& system, const Frame& frame) {
  std::vector<Finding> findings;
  if (!have_one_size(system, frame)) {
    return {{"the arrays of the system and of the frame do not have one entry for each disk", {}}};
  }
  if (system.size() == 0) findings.push_back({"there are no disks: give [[disk]] or [[gas]] sections", {}});
  check_box(system.box, findings);
  check_physics(system.physics, findings);
  check_numbers(system, frame, findings);
  if (!findings.empty()) return findings;  // what follows computes with these numbers
  const bool wide_enough = check_periodic_width(system, findings);
  const std::vector<bool> outside = check_inside(system, frame, findings);
  if (wide_enough) check_overlaps(system, frame, outside, findings);
  return findings;
}

}  // namespace carom
