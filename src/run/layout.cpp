#include "layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace carom {
namespace {

double along(Vec2 v, int axis) noexcept { return axis == 0 ? v.x : v.y; }

}  // namespace

Layout::Layout(const System& system, std::uint32_t columns, std::uint32_t rows) noexcept
    : system_(system), count_{columns, rows} {}

void Layout::sort(const Frame& disks) {
  disks_ = &disks;
  const Box& box = system_.box;
  const auto count = static_cast<double>(disks.size());
  for (int axis = 0; axis < 2; ++axis) {
    const std::vector<double>& x = axis == 0 ? disks.x : disks.y;
    Axis& a = axis_[axis];
    a.periodic = box.periodic(axis);
    if (box.boundary[axis] == Boundary::open) {
      const auto [low, high] = std::minmax_element(x.begin(), x.end());
      a.low = *low;
      a.size = std::max(*high - *low, 2 * system_.largest_radius());
    } else {
      a.low = 0;
      a.size = along(box.size, axis);
    }
  }
  const double width = std::sqrt(kDisksPerBin * axis_[0].size / count * axis_[1].size);
  for (Axis& a : axis_) {
    a.bins = static_cast<std::int64_t>(std::clamp(a.size / width, 1.0, count));
    a.bin = a.size / static_cast<double>(a.bins);
  }
  start_.assign(static_cast<std::size_t>(axis_[0].bins * axis_[1].bins) + 1, 0);
  order_.resize(disks.size());
  const auto bin_of = [&](std::size_t id) {
    return static_cast<std::size_t>(bin_along(axis_[1], disks.y[id]) * axis_[0].bins +
                                    bin_along(axis_[0], disks.x[id]));
  };
  for (std::size_t id = 0; id < disks.size(); ++id) ++start_[bin_of(id)];
  std::inclusive_scan(start_.begin(), start_.end(), start_.begin());
  for (std::size_t id = disks.size(); id-- > 0;) order_[--start_[bin_of(id)]] = static_cast<DiskId>(id);
}

std::int64_t Layout::bin_along(const Axis& axis, double x) noexcept {
  return static_cast<std::int64_t>(std::clamp((x - axis.low) / axis.bin, 0.0, static_cast<double>(axis.bins - 1)));
}

std::uint32_t Layout::owner_along(int axis, double x) const noexcept {
  const Axis& a = axis_[axis];
  const double place = (x - a.low) / a.size * count_[axis];
  return static_cast<std::uint32_t>(std::clamp(place, 0.0, static_cast<double>(count_[axis] - 1)));
}

Rectangle Layout::owned(std::size_t patch) const noexcept {
  const auto edge = [&](int axis, std::size_t number) {
    const Axis& a = axis_[axis];
    return a.low + a.size * static_cast<double>(number) / count_[axis];
  };
  const std::size_t column = patch % count_[0];
  const std::size_t row = patch / count_[0];
  return {{edge(0, column), edge(1, row)}, {edge(0, column + 1), edge(1, row + 1)}};
}

Rectangle Layout::territory(std::size_t patch) const noexcept {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Rectangle all = owned(patch);
  const std::array<std::size_t, 2> place{patch % count_[0], patch / count_[0]};
  for (int axis = 0; axis < 2; ++axis) {
    if (axis_[axis].periodic) continue;
    if (place[axis] == 0) (axis == 0 ? all.low.x : all.low.y) = -kInfinity;
    if (place[axis] + 1 == count_[axis]) (axis == 0 ? all.high.x : all.high.y) = kInfinity;
  }
  return all;
}

/// The bins that [low, high] takes up; those beyond a periodic axis's end count on.
Layout::Bins Layout::bins_within(const Axis& axis, double low, double high) noexcept {
  const double first = std::floor((low - axis.low) / axis.bin);
  const double last = std::floor((high - axis.low) / axis.bin);
  const auto all = static_cast<double>(axis.bins);
  if (axis.periodic) {
    if (last - first + 1 > kLargestPart * all) return {0, axis.bins, false};
    return {static_cast<std::int64_t>(first), static_cast<std::int64_t>(last - first + 1), true};
  }
  const auto from = static_cast<std::int64_t>(std::clamp(first, 0.0, all - 1));
  const auto to = static_cast<std::int64_t>(std::clamp(last, 0.0, all - 1));
  return {from, to - from + 1, from > 0 || to < axis.bins - 1};
}

void Layout::load(std::size_t patch, double near, double halo, Loading& loading) const {
  const Rectangle own = owned(patch);
  const Bins columns = bins_within(axis_[0], own.low.x - halo, own.high.x + halo);
  const Bins rows = bins_within(axis_[1], own.low.y - halo, own.high.y + halo);
  loading.cut = {columns.cut, rows.cut};
  loading.whole = !columns.cut && !rows.cut;
  const auto edge = [](const Axis& axis, std::int64_t bin) {
    // Where there is a wall its place to the last bit: what is loaded reaches it or does not.
    if (!axis.periodic && bin == axis.bins) return axis.low + axis.size;
    return axis.low + static_cast<double>(bin) * axis.bin;
  };
  loading.loaded = {{edge(axis_[0], columns.first), edge(axis_[1], rows.first)},
                    {edge(axis_[0], columns.first + columns.count), edge(axis_[1], rows.first + rows.count)}};
  loading.disks.clear();
  loading.roles.clear();
  loading.shares.clear();
  const auto folded = [](std::int64_t bin, const Axis& axis) { return (bin % axis.bins + axis.bins) % axis.bins; };
  for (std::int64_t b = rows.first; b < rows.first + rows.count; ++b) {
    const std::int64_t row = folded(b, axis_[1]) * axis_[0].bins;
    for (std::int64_t a = columns.first; a < columns.first + columns.count; ++a) {
      const auto bin = static_cast<std::size_t>(row + folded(a, axis_[0]));
      for (std::uint32_t place = start_[bin]; place < start_[bin + 1]; ++place) {
        add(patch, order_[place], near, halo, loading);
      }
    }
  }
}

void Layout::load_all(Loading& loading) const {
  loading.cut = {false, false};
  loading.whole = true;
  loading.loaded = {{axis_[0].low, axis_[1].low}, {axis_[0].low + axis_[0].size, axis_[1].low + axis_[1].size}};
  loading.disks = order_;
  loading.roles.assign(order_.size(), Role::owned);
  loading.shares.assign(order_.size(), 1);
}

void Layout::add(std::size_t patch, DiskId id, double near, double halo, Loading& loading) const {
  const Vec2 position = disks_->position(id);
  const bool owned = owner_along(0, position.x) == patch % count_[0] && owner_along(1, position.y) == patch / count_[0];
  const double away = owned ? 0 : distance(patch, position);
  loading.disks.push_back(id);
  loading.roles.push_back(owned ? Role::owned : away <= near ? Role::near : Role::far);
  // What is left alone stays behind what comes in from beyond the halo by the width of the near strip.
  const bool all_the_time = loading.whole || away <= 2 * near;
  loading.shares.push_back(
      all_the_time ? 1 : static_cast<float>(std::clamp((halo + near - away) / (halo - near), 0.0, 1.0)));
}

double Layout::distance(std::size_t patch, Vec2 position) const noexcept {
  const Rectangle own = owned(patch);
  double farthest = 0;
  for (int axis = 0; axis < 2; ++axis) {
    const Axis& a = axis_[axis];
    const double half = 0.5 * (along(own.high, axis) - along(own.low, axis));
    double from_middle = std::abs(along(position, axis) - (along(own.low, axis) + half));
    if (a.periodic) from_middle = std::min(from_middle, std::abs(a.size - from_middle));
    farthest = std::max(farthest, from_middle - half);
  }
  return farthest;
}

bool Layout::touches(std::size_t patch, const Rectangle& path, double margin) const noexcept {
  const Rectangle own = territory(patch);
  for (int axis = 0; axis < 2; ++axis) {
    const Axis& a = axis_[axis];
    const double low = along(own.low, axis) - margin;
    const double high = along(own.high, axis) + margin;
    double from = along(path.low, axis);
    double to = along(path.high, axis);
    if (a.periodic) {
      const double periods = std::ceil((low - to) / a.size);  // to the first copy that ends beyond `low`
      from += periods * a.size;
      to += periods * a.size;
    }
    if (from > high || to < low) return false;
  }
  return true;
}

bool Layout::may_come_round(const Rectangle& path) const noexcept {
  const auto comes_round = [&](int axis) {
    const double width = along(path.high, axis) - along(path.low, axis);
    return axis_[axis].periodic && width > (1 - kLargestPart) * axis_[axis].size;
  };
  return comes_round(0) || comes_round(1);
}

}  // namespace carom
