// What the page's play area calls.
#include <algorithm>
#include <memory>

#include "carom/io/scene_file.hpp"
#include "carom/run/simulation.hpp"
#include "exchange.hpp"
#include "playback.hpp"
#include "scenes.hpp"

namespace carom::page {
namespace {

std::unique_ptr<Playback> the_playback;

/// x, y, vx, vy of all disks, one array after the other.
double* answer_frame(const Frame& frame) {
  std::vector<double> numbers;
  numbers.reserve(4 * frame.size());
  for (const auto* column : {&frame.x, &frame.y, &frame.vx, &frame.vy}) {
    numbers.insert(numbers.end(), column->begin(), column->end());
  }
  return answer_numbers(std::move(numbers));
}

double number_of(DiskId id) { return is_wall(id) ? -1.0 - static_cast<double>(id - kFirstWallId) : id; }

std::vector<double> numbers_of(const Contact& c) {
  return {c.time,
          number_of(c.row.i),
          number_of(c.row.j),
          c.position_i.x,
          c.position_i.y,
          c.position_j.x,
          c.position_j.y,
          c.before_i.x,
          c.before_i.y,
          c.before_j.x,
          c.before_j.y,
          c.after_i.x,
          c.after_i.y,
          c.after_j.x,
          c.after_j.y,
          c.row.point.x,
          c.row.point.y,
          c.row.normal.x,
          c.row.normal.y,
          c.row.impulse,
          c.restitution,
          static_cast<double>(c.row.generation)};
}

}  // namespace
}  // namespace carom::page

using namespace carom;
using namespace carom::page;

/// Opens the scene in the input. Returns the number of disks, or −1 with the problems as text.
CAROM_EXPORT int carom_play_open() {
  return guarded(-1, [] {
    Setup setup = realize(read_scene_text(input()).scene);
    the_playback = std::make_unique<Playback>(std::move(setup));
    return static_cast<int>(the_playback->system().size());
  });
}

/// The disks at `time`; see Playback::frame_at. Null with the reason as text.
CAROM_EXPORT double* carom_play_frame(double time) {
  return guarded<double*>(nullptr, [&] { return answer_frame(the_playback->frame_at(time)); });
}

/// The disks just after contact k.
CAROM_EXPORT double* carom_play_frame_after(int k) {
  return guarded<double*>(nullptr,
                          [&] { return answer_frame(the_playback->frame_after(static_cast<std::size_t>(k))); });
}

/// Number of contacts before or at `time`.
CAROM_EXPORT int carom_play_contacts(double time) {
  return guarded(-1, [&] {
    the_playback->know_until(time);
    const auto& all = the_playback->contacts();
    const auto after =
        std::upper_bound(all.begin(), all.end(), time, [](double t, const Contact& c) { return t < c.time; });
    return static_cast<int>(after - all.begin());
  });
}

/// Whether there is a contact number k before `horizon` (time).
CAROM_EXPORT int carom_play_has(int k, double horizon) {
  return guarded(0, [&] {
    the_playback->know_more_than(static_cast<std::size_t>(k), horizon);
    return static_cast<int>(the_playback->contacts().size() > static_cast<std::size_t>(k));
  });
}

/// Contact k: time, i, j (walls: −1 left, −2 right, −3 bottom, −4 top), centres, velocities before and after, point,
/// normal, |J|, restitution, generation.
CAROM_EXPORT double* carom_play_contact(int k) {
  return guarded<double*>(
      nullptr, [&] { return answer_numbers(numbers_of(the_playback->contacts().at(static_cast<std::size_t>(k)))); });
}
