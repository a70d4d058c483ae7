// Workspace: what a patch needs beyond a whole plane.
#include <algorithm>
#include <cmath>

#include "workspace.hpp"

namespace carom::fast {

void Workspace::open_patch(const State& start, const Books& from, const PatchTask& task, double until, Books& to,
                           std::vector<Collision>* rows) {
  begin_window(start, to, rows);
  patched = true;
  part_ = Extent{task.loaded.low, task.loaded.high, task.cut};
  clear_ = task.clear;
  roles.assign(task.roles.begin(), task.roles.end());
  histories.assign(task.disks.size(), 0);
  last_events.resize(task.disks.size());
  for (std::size_t k = 0; k < task.disks.size(); ++k) last_events[k] = task.shares[k] * until;
  contacts = 0;
  met_far = false;
  paths_.clear();
  load(start, task.disks);
  starts_.resize(records.size());
  for (std::size_t k = 0; k < records.size(); ++k) starts_[k] = {records[k].x, records[k].y};
  load_sums(from);
  if (!records.empty()) find_neighbours();
}

/// How far the disk's stored position has come since the window's start, folds undone.
Vec2 Workspace::unfolded(Index k, Vec2 place) const {
  const auto found = turns_.find(k);
  if (found == turns_.end()) return place;
  return {place.x + static_cast<double>(found->second.first) * system.box.size.x,
          place.y + static_cast<double>(found->second.second) * system.box.size.y};
}

void Workspace::note_excursion(Index k, double time) {
  const Vec2 place = unfolded(k, predict::position_at(records[k].flight(), time));
  const Vec2 start = starts_[k];
  const Vec2 roam = roaming();
  if (std::abs(place.x - start.x) + roam.x <= clear_ && std::abs(place.y - start.y) + roam.y <= clear_) return;
  const Vec2 clear{std::max(clear_, roam.x), std::max(clear_, roam.y)};
  Rectangle& path = paths_.try_emplace(k, Rectangle{start - clear, start + clear}).first->second;
  path.low = {std::min(path.low.x, place.x - roam.x), std::min(path.low.y, place.y - roam.y)};
  path.high = {std::max(path.high.x, place.x + roam.x), std::max(path.high.y, place.y + roam.y)};
}

/// How far a disk can go along either axis before its next grid event.
Vec2 Workspace::roaming() const noexcept { return cells ? cells->width() : Vec2{lists->leash(), lists->leash()}; }

void Workspace::store_owned(Index k, double time, const PatchOutput& output) const {
  const Record& own = records[k];
  const DiskId id = ids[k];
  Frame& disks = *output.disks;
  disks.x[id] = own.x;
  disks.y[id] = own.y;
  disks.vx[id] = own.vx;
  disks.vy[id] = own.vy;
  disks.winding_x[id] = start_->disks.winding_x[id];
  disks.winding_y[id] = start_->disks.winding_y[id];
  if (const auto turns = turns_.find(k); turns != turns_.end()) {
    disks.winding_x[id] += turns->second.first;
    disks.winding_y[id] += turns->second.second;
  }
  (*output.events)[id] = own.events;
  (*output.history)[id] = histories[k];
  (*output.virial)[id] = virial[k];
  if (!wall_impulse.empty()) (*output.wall_impulse)[id] = wall_impulse[k];
  if (!last_contact.empty()) (*output.last_contact)[id] = last_contact[k] - time;
}

void Workspace::store_patch(double time, const PatchOutput& output, PatchReport& report) {
  carry_all(time);
  const Vec2 roam = roaming();
  const bool always_far = std::max(roam.x, roam.y) > clear_;
  for (Index k = 0; k < static_cast<Index>(records.size()); ++k) {
    const Record& own = records[k];
    if (roles[k] == Role::near) {
      report.near.push_back({ids[k], own.events, histories[k], {own.x, own.y}, {own.vx, own.vy}});
    } else if (roles[k] == Role::owned) {
      store_owned(k, time, output);
      if (always_far) note_excursion(k, time);
    }
  }
  for (const auto& [k, path] : paths_) {
    if (roles[k] == Role::owned) report.excursions.push_back({ids[k], path});
  }
  report.books.collisions += collisions;
  report.contacts += contacts;
  report.met_far = met_far;
  note_least_distance();
}

}  // namespace carom::fast
