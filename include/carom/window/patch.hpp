// The window map on a part of the plane: what a patch is given and what it hands back.
//
// A patch advances the disks that it owns, and around them a halo of copies of other patches' disks, from the window's
// start and without hearing from anybody. Whether that was right is checked afterwards from what is handed back.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "carom/state/state.hpp"
#include "carom/state/system.hpp"
#include "carom/window/books.hpp"
#include "carom/window/collision.hpp"
#include "carom/window/solver.hpp"

namespace carom {

/// A rectangle of the plane (length).
struct Rectangle {
  Vec2 low;
  Vec2 high;
};

/// What a disk is to a patch.
enum class Role : std::uint8_t {
  owned = 1,  ///< its state at the window's end is what the patch is for
  near = 2,   ///< a copy that started near the owned ones: its history is compared with its owner's
  far = 4     ///< a copy that is there so that near ones have somebody to meet
};

struct PatchTask {
  Rectangle loaded;               ///< where the disks are, in the frame of the owned ones; may reach beyond the box
  std::array<bool, 2> cut;        ///< along which axes that is but a part of the plane
  std::span<const DiskId> disks;  ///< in an order that keeps neighbours together
  std::span<const Role> roles;    ///< of these disks
  /// How much of the time each disk is advanced, from 0 to 1; what lies so far out that its fate can matter to near
  /// ones no more is left alone. 1 for owned and near ones.
  std::span<const float> shares;
  double clear = 0;  ///< owned disks that go farther than this from their start are reported (length)
};

/// Where a patch writes what became of the disks that it owns: arrays of N, entries of owned disks only.
struct PatchOutput {
  Frame* disks = nullptr;                  ///< all but the time
  std::vector<double>* last_contact = {};  ///< empty in elastic systems
  std::vector<std::uint32_t>* events = {};
  std::vector<std::uint64_t>* history = {};
  std::vector<double>* virial = {};
  std::vector<double>* wall_impulse = {};  ///< empty where there are no walls
};

/// How a near copy fared.
struct NearCopy {
  DiskId id = 0;
  std::uint32_t events = 0;
  std::uint64_t history = 0;  ///< of all its events: time, partner, image, new velocity
  Vec2 position, velocity;    ///< at the end
};

/// An owned disk that went far, and a rectangle that holds its path, not folded into the box.
struct Excursion {
  DiskId id = 0;
  Rectangle path;
};

struct PatchReport {
  Books books{0};              ///< counts of contacts whose smaller id is owned; no arrays
  std::uint64_t contacts = 0;  ///< of disks, the halo's too: what was computed
  bool met_far = false;        ///< an owned disk met a far copy
  std::vector<NearCopy> near;
  std::vector<Excursion> excursions;
  std::vector<Collision> log;  ///< in the order of processing
};

/// Advances one patch after another. For one thread at a time.
class PatchSolver {
 public:
  virtual ~PatchSolver() = default;
  PatchSolver() = default;
  PatchSolver(const PatchSolver&) = delete;
  PatchSolver& operator=(const PatchSolver&) = delete;

  /// From the window's start to `until` ≤ Δ. `books` hold the sums at the start. Fills `report`, with a log if `logs`,
  /// and writes owned disks into `output`. Returns false if it stopped because `interrupt` became true.
  virtual bool run(const State& start, const Books& books, const PatchTask& task, double until, bool logs,
                   const PatchOutput& output, PatchReport& report, const std::atomic<bool>& interrupt) = 0;
};

/// The fast solver on patches. `system` must outlive it.
std::unique_ptr<PatchSolver> make_patch_solver(const System& system, const SolverOptions& options = {});

}  // namespace carom
