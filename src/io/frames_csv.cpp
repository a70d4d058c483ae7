#include "carom/io/frames_csv.hpp"

#include <fmt/format.h>

#include <iterator>

namespace carom {

std::string frames_csv_head() { return "time,id,x,y,vx,vy,winding_x,winding_y,radius,mass\n"; }

std::string frame_csv(const System& system, const Frame& frame) {
  fmt::memory_buffer rows;
  for (std::size_t k = 0; k < frame.size(); ++k) {
    fmt::format_to(std::back_inserter(rows), "{:.17g},{},{:.17g},{:.17g},{:.17g},{:.17g},{},{},{:.17g},{:.17g}\n",
                   frame.time, k, frame.x[k], frame.y[k], frame.vx[k], frame.vy[k], frame.winding_x[k],
                   frame.winding_y[k], system.radius(k), system.mass(k));
  }
  return fmt::to_string(rows);
}

}  // namespace carom
