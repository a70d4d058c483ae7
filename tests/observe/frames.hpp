// Observables fed with frames by hand, for the tests of structure.
#pragma once

#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "carom/observe/registry.hpp"
#include "order/arrangements.hpp"

namespace carom::test {

/// The observable of this name for frames like `arrangement`, one time unit apart.
inline std::unique_ptr<Observable> make(const std::string& name, const Arrangement& arrangement,
                                        std::map<std::string, double> options = {}) {
  return make_observable({.name = name, .options = std::move(options)}, {arrangement.system, arrangement.frame, 1.0});
}

/// What it finds in this one frame.
inline Measurement measured(const std::string& name, const Arrangement& arrangement,
                            std::map<std::string, double> options = {}) {
  const auto observable = make(name, arrangement, std::move(options));
  observable->on_frame(arrangement.system, arrangement.frame);
  return observable->result();
}

inline const std::vector<double>& column(const Measurement& measurement, std::string_view table,
                                         std::string_view name) {
  for (const Table& candidate : measurement.tables) {
    if (candidate.name != table) continue;
    for (const Column& found : candidate.columns) {
      if (found.name == name) return found.values;
    }
  }
  throw std::out_of_range("no column " + std::string(name));
}

inline const Estimate& estimate(const Measurement& measurement, std::string_view name) {
  for (const Estimate& found : measurement.estimates) {
    if (found.name == name) return found;
  }
  throw std::out_of_range("no estimate " + std::string(name));
}

/// r from i to the nearest image of j.
inline Vec2 nearest_image(const Arrangement& points, std::size_t i, std::size_t j) {
  const Box& box = points.system.box;
  Vec2 r = points.frame.position(j) - points.frame.position(i);
  if (box.periodic(0)) r.x -= box.size.x * std::rint(r.x / box.size.x);
  if (box.periodic(1)) r.y -= box.size.y * std::rint(r.y / box.size.y);
  return r;
}

}  // namespace carom::test
