#include "patched_solver.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <numeric>

#include "carom/base/simd.hpp"
#include "carom/run/window_length.hpp"
#include "carom/window/patch.hpp"
#include "layout.hpp"

namespace carom {
namespace {

bool same_bits(double a, double b) noexcept {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// How far influence spreads with every contact of a disk, in mean spacings, with something to spare. Some of it runs
/// ahead, as far as with kAhead contacts more, and in dilute gases as far as fast disks fly: kFlight root mean square
/// ways for every spacing.
constexpr double kDepth = 1.5;
constexpr double kAhead = 2;
constexpr double kFlight = 3;
/// Root mean square ways that a disk goes before it counts as one that went far.
constexpr double kFar = 4;

struct Copies {
  double near = 0;
  double halo = 0;
  double contacts = 0;  ///< per disk in the window
};

/// `contacts` per disk in the window, 0 if unknown.
Copies copies_for(const System& system, const State& start, double contacts, double depth) {
  const std::size_t count = system.size();
  double squares = 0;
  Vec2 low = start.disks.position(0);
  Vec2 high = low;
  for (std::size_t k = 0; k < count; ++k) {
    squares += dot(start.disks.velocity(k), start.disks.velocity(k));
    low = {std::min(low.x, start.disks.x[k]), std::min(low.y, start.disks.y[k])};
    high = {std::max(high.x, start.disks.x[k]), std::max(high.y, start.disks.y[k])};
  }
  if (!(contacts > 0)) contacts = expected_contacts(system, start);
  contacts = std::max(contacts, 0.1);
  const double reach = 2 * system.largest_radius();
  const double spacing =
      std::sqrt(std::max(high.x - low.x, reach) * std::max(high.y - low.y, reach) / static_cast<double>(count));
  const double speed = std::sqrt(squares / static_cast<double>(2 * count));  // along either axis
  const double way = speed * start.clock.length * std::min(1.0, std::sqrt(2 / contacts));
  const double near = reach + 2 * (spacing + kFar * way);
  const double spreads = std::max((contacts + kAhead) * spacing, kFlight * speed * start.clock.length);
  return {near, near + depth * spreads, contacts};
}

/// Adds to a sum of seconds until it is stopped or ends.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(&seconds) {}
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;
  ~Stopwatch() { stop(); }
  void stop() {
    if (seconds_ == nullptr) return;
    *seconds_ += std::chrono::duration<double>(Clock::now() - start_).count();
    seconds_ = nullptr;
  }

 private:
  using Clock = std::chrono::steady_clock;
  double* seconds_;
  Clock::time_point start_ = Clock::now();
};

class PatchedSolver final : public DividedSolver {
 public:
  PatchedSolver(const System& system, const SolverOptions& solver, const ParallelOptions& parallel,
                const Checks& checks)
      : system_(system),
        options_(solver),
        parallel_(parallel),
        checks_(checks),
        simd_(usable_simd(solver.simd)),
        executor_(make_executor(parallel.threads)),
        layout_(system, (*parallel.patches)[0], (*parallel.patches)[1]),
        reach_(2 * system.largest_radius()),
        loadings_(executor_->workers()) {
    for (std::size_t worker = 0; worker < executor_->workers(); ++worker) {
      solvers_.push_back(make_patch_solver(system, solver));
    }
    reports_.resize(layout_.patches());
    attempts_.resize(layout_.patches());
    division_.threads = executor_->workers();
    division_.patches = layout_.patches();
  }

  [[nodiscard]] std::string_view name() const noexcept override { return "fast"; }
  [[nodiscard]] std::string_view simd() const noexcept override { return name_of(simd_); }
  [[nodiscard]] bool sums_at_stops_only() const noexcept override { return true; }
  [[nodiscard]] Division division() const noexcept override {
    Division division = division_;
    if (counted_ > 0) division.duplicated = static_cast<double>(computed_) / static_cast<double>(counted_) - 1;
    return division;
  }

  void open(const State& start, Books& books, std::vector<Collision>* log) override {
    start_ = &start;
    books_ = &books;
    log_ = log;
    logged_before_ = log != nullptr ? log->size() : 0;
    advanced_ = 0;
    stops_ = 0;
    undivided_.reset();
    books_at_start_.reset();
    sorted_ = false;
    choose_copies();
  }

  bool advance_to(double time, const std::atomic<bool>& interrupt) override {
    if (undivided_) return undivided_->advance_to(time, interrupt);
    if (time < start_->clock.length) {
      if (!books_at_start_) books_at_start_ = std::make_unique<Books>(*books_);
      if (++stops_ > 1) return go_on_undivided(time, interrupt);
    }
    if (books_at_start_) restore();
    if (!advance_patches(time, interrupt)) return false;
    const std::uint64_t events = commit();
    if (time == start_->clock.length) {
      contacts_ = 2 * static_cast<double>(events) / static_cast<double>(system_.size());
    }
    advanced_ = time;
    return true;
  }

  void read(double time, Frame& frame) const override {
    if (undivided_) return undivided_->read(time, frame);
    if (advanced_ == 0) {
      frame = start_->disks;
    } else {
      frame = end_;
    }
  }

  void close(State& next) override {
    if (undivided_) {
      undivided_->close(next);
      undivided_.reset();
      return;
    }
    std::swap(next.disks, end_);
    std::swap(next.last_contact, last_contact_);
  }

 private:
  const Books& books_at_start() const noexcept { return books_at_start_ ? *books_at_start_ : *books_; }

  /// To what was so at the window's start.
  void restore() {
    *books_ = *books_at_start_;
    if (log_ != nullptr) log_->resize(logged_before_);
  }

  /// Every stop costs the patches the way from the window's start; with many of them a solver that stays open is
  /// better.
  bool go_on_undivided(double time, const std::atomic<bool>& interrupt) {
    restore();
    undivided_ = make_fast_solver(system_, options_);
    undivided_->open(*start_, *books_, log_);
    return undivided_->advance_to(time, interrupt);
  }

  bool advance_patches(double until, const std::atomic<bool>& interrupt) {
    Stopwatch sorting(division_.phases.sort);
    if (!sorted_) layout_.sort(start_->disks);
    sorted_ = true;
    make_room();
    sorting.stop();
    std::vector<std::size_t> patches(layout_.patches());
    std::iota(patches.begin(), patches.end(), std::size_t{0});
    std::fill(attempts_.begin(), attempts_.end(), Attempt{near_, halo_, false});
    whole_plane_ = false;
    std::size_t repaired = 0;
    while (!patches.empty()) {
      if (!run(patches, until, interrupt)) return false;
      patches = failed();
      repaired += patches.size();
      division_.patches_repaired += patches.size();
      for (const std::size_t patch : patches) {
        attempts_[patch].near *= 2;
        attempts_[patch].halo = attempts_[patch].halo * 1.5 + attempts_[patch].near;
      }
      // Patches that need nearly all of the plane would each do the work of one that owns it.
      if (std::count_if(patches.begin(), patches.end(), [&](std::size_t k) { return is_hopeless(k); }) > 1) {
        learn(repaired);
        return advance_whole_plane(until, interrupt);
      }
    }
    division_.windows_repaired += repaired > 0 ? 1 : 0;
    learn(repaired);
    return true;
  }

  bool run(const std::vector<std::size_t>& patches, double until, const std::atomic<bool>& interrupt) {
    const Stopwatch advancing(division_.phases.advance);
    std::atomic<bool> finished{true};
    executor_->for_each(patches.size(), [&](std::size_t item, std::size_t worker) {
      const std::size_t patch = patches[item];
      Attempt& attempt = attempts_[patch];
      Loading& loading = loadings_[worker];
      layout_.load(patch, attempt.near, attempt.halo, loading);
      attempt.whole = loading.whole;
      if (!run(worker, loading, until, reports_[patch], interrupt)) finished = false;
    });
    division_.patch_windows += patches.size();
    return finished;
  }

  struct Attempt {
    double near = 0;
    double halo = 0;
    bool whole = false;  // all disks were loaded
  };

  bool run(std::size_t worker, const Loading& loading, double until, PatchReport& report,
           const std::atomic<bool>& interrupt) {
    const PatchTask task{loading.loaded, loading.cut,    loading.disks,
                         loading.roles,  loading.shares, clear_of({near_, halo_, false})};
    const PatchOutput output{&end_, &last_contact_, &events_, &history_, &virial_, &wall_impulse_};
    return solvers_[worker]->run(*start_, books_at_start(), task, until, log_ != nullptr, output, report, interrupt);
  }

  /// The whole plane as one patch: needs no check.
  bool advance_whole_plane(double until, const std::atomic<bool>& interrupt) {
    const Stopwatch advancing(division_.phases.advance);
    Loading& loading = loadings_[0];
    layout_.load_all(loading);
    whole_plane_ = true;
    ++division_.windows_repaired;
    ++division_.patch_windows;
    return run(0, loading, until, reports_[0], interrupt);
  }

  /// How far an owned disk may go without being looked at one by one: so far that it cannot meet anybody who started
  /// farther away than near ones and went no farther, by more than rounding.
  [[nodiscard]] double clear_of(const Attempt& attempt) const noexcept {
    return (attempt.near - reach_) / 2 - 1e-9 * attempt.near;
  }
  [[nodiscard]] bool is_hopeless(std::size_t patch) const noexcept {
    return attempts_[patch].halo > 0.5 * layout_.longer_side() || attempts_[patch].whole;
  }

  // --- copies ------------------------------------------------------------------------------------------------

  /// How wide the strips of near and of all copies are, from how far disks go in this window and how deep what happens
  /// outside works its way in: it goes from disk to disk with every contact.
  void choose_copies() {
    const Copies copies = copies_for(system_, *start_, contacts_, depth_);
    near_ = parallel_.near > 0 ? parallel_.near : copies.near;
    halo_ = std::max(near_, parallel_.halo > 0 ? parallel_.halo : copies.halo);
  }

  /// From how many patches had to be repaired: too many cost more than deeper halos, and none ever that they could be
  /// shallower.
  void learn(std::size_t repaired) noexcept {
    constexpr double kTooMany = 0.02;
    if (static_cast<double>(repaired) > kTooMany * static_cast<double>(layout_.patches())) {
      depth_ = std::min(depth_ * 1.1, 4 * kDepth);
      without_repair_ = 0;
    } else if (repaired == 0 && ++without_repair_ == 16) {
      depth_ = std::max(depth_ * 0.96, 0.5 * kDepth);
      without_repair_ = 0;
    }
  }

  // --- verify ------------------------------------------------------------------------------------------------

  /// The patches whose result is not certain.
  [[nodiscard]] std::vector<std::size_t> failed() {
    const Stopwatch verifying(division_.phases.verify);
    std::vector<std::uint8_t> fails(layout_.patches(), 0);
    executor_->for_each(layout_.patches(), [&](std::size_t patch, std::size_t) {
      fails[patch] = static_cast<std::uint8_t>(!attempts_[patch].whole && !is_certain(patch));
    });
    std::vector<std::size_t> failed;
    for (std::size_t patch = 0; patch < fails.size(); ++patch) {
      if (fails[patch] != 0) failed.push_back(patch);
    }
    return failed;
  }

  [[nodiscard]] bool is_certain(std::size_t patch) const {
    const PatchReport& report = reports_[patch];
    if (checks_.far_contacts && report.met_far) return false;
    if (checks_.near_copies && !std::all_of(report.near.begin(), report.near.end(),
                                            [&](const NearCopy& copy) { return agrees_with_owner(copy); })) {
      return false;
    }
    return !checks_.excursions || excursions_stay_clear(patch);
  }

  [[nodiscard]] bool agrees_with_owner(const NearCopy& copy) const noexcept {
    const DiskId id = copy.id;
    return copy.events == events_[id] && copy.history == history_[id] && same_bits(copy.position.x, end_.x[id]) &&
           same_bits(copy.position.y, end_.y[id]) && same_bits(copy.velocity.x, end_.vx[id]) &&
           same_bits(copy.velocity.y, end_.vy[id]);
  }

  /// Disks that went far: the patch's own must not have left its surroundings, others must not have come near unless
  /// they were near copies from the start, and did not come from the other side than where their copies are.
  [[nodiscard]] bool excursions_stay_clear(std::size_t patch) const {
    const Attempt& attempt = attempts_[patch];
    const double clear = clear_of(attempt);
    const Rectangle own = layout_.territory(patch);
    for (const Excursion& excursion : reports_[patch].excursions) {
      if (excursion.path.low.x < own.low.x - clear || excursion.path.low.y < own.low.y - clear ||
          excursion.path.high.x > own.high.x + clear || excursion.path.high.y > own.high.y + clear) {
        return false;
      }
    }
    for (std::size_t other = 0; other < reports_.size(); ++other) {
      if (other == patch) continue;
      for (const Excursion& excursion : reports_[other].excursions) {
        if (!layout_.touches(patch, excursion.path, clear + reach_)) continue;
        if (layout_.distance(patch, start_->disks.position(excursion.id)) > attempt.near) return false;
        if (layout_.may_come_round(excursion.path)) return false;
      }
    }
    return true;
  }

  // --- keep --------------------------------------------------------------------------------------------------

  void make_room() {
    const std::size_t count = start_->disks.size();
    end_.resize(count);
    events_.resize(count);
    history_.resize(count);
    virial_.resize(count);
    if (system_.box.has_walls()) wall_impulse_.resize(count);
    if (!system_.physics.elastic()) last_contact_.resize(count);
  }

  /// Enters in books and log what the patches did. Returns the number of events.
  std::uint64_t commit() {
    const Stopwatch collecting(division_.phases.collect);
    Books& books = *books_;
    for (std::size_t id = 0; id < events_.size(); ++id) books.events_of[id] += events_[id];
    std::copy(virial_.begin(), virial_.end(), books.virial_of.begin());
    std::copy(wall_impulse_.begin(), wall_impulse_.end(), books.wall_impulse_of.begin());
    const std::uint64_t events_before = books.events();
    const std::size_t count = whole_plane_ ? 1 : reports_.size();
    for (std::size_t patch = 0; patch < count; ++patch) {
      const PatchReport& report = reports_[patch];
      books.collisions += report.books.collisions;
      books.wall_collisions += report.books.wall_collisions;
      books.ties += report.books.ties;
      books.collapses += report.books.collapses;
      books.largest_overlap = std::max(books.largest_overlap, report.books.largest_overlap);
      computed_ += report.contacts;
      counted_ += report.books.collisions;
      if (log_ != nullptr) log_->insert(log_->end(), report.log.begin(), report.log.end());
    }
    return books.events() - events_before;
  }

  const System& system_;
  SolverOptions options_;
  ParallelOptions parallel_;
  Checks checks_;
  Simd simd_;
  std::unique_ptr<Executor> executor_;
  Layout layout_;
  double reach_;  // the largest contact distance
  double near_ = 0;
  double halo_ = 0;
  double depth_ = kDepth;
  double contacts_ = 0;  // per disk, in the last whole window; 0 before
  int without_repair_ = 0;
  std::vector<std::unique_ptr<PatchSolver>> solvers_;  // one per worker
  std::vector<Loading> loadings_;                      // one per worker

  // The window that is open.
  const State* start_ = nullptr;
  Books* books_ = nullptr;
  std::vector<Collision>* log_ = nullptr;
  std::size_t logged_before_ = 0;
  double advanced_ = 0;
  int stops_ = 0;
  bool sorted_ = false;
  bool whole_plane_ = false;
  std::unique_ptr<Books> books_at_start_;  // where it is stopped in the middle
  std::unique_ptr<Solver> undivided_;      // where it is stopped there again
  std::vector<Attempt> attempts_;          // of each patch
  std::vector<PatchReport> reports_;

  // What patches write, each the entries of its own disks.
  Frame end_;
  std::vector<double> last_contact_;
  std::vector<std::uint32_t> events_;
  std::vector<std::uint64_t> history_;
  std::vector<double> virial_;
  std::vector<double> wall_impulse_;

  Division division_;
  std::uint64_t computed_ = 0;  // contacts, those of halos too
  std::uint64_t counted_ = 0;
};

/// What the choice of patches goes by: the time that a window takes, in units of what its contacts take where all that
/// they need is in the fastest cache.
class Costs {
 public:
  Costs(Vec2 size, const Copies& copies, std::size_t disks) noexcept
      : size_(size), copies_(copies), disks_(static_cast<double>(disks)) {
    copies_.halo += std::sqrt(kDisksPerBin * size.x * size.y / disks_);  // whole bins are loaded
  }

  [[nodiscard]] double undivided() const noexcept { return slowdown(disks_); }

  /// Of columns × rows patches on so many threads.
  [[nodiscard]] double divided(std::uint32_t columns, std::uint32_t rows, unsigned threads) const noexcept {
    constexpr double kLoading = 1.3;  // of a disk into a patch: as much as so many contacts
    const double loaded = share(columns, rows, copies_.halo);
    // Copies are left alone from the outside to the inside; by Simpson's rule.
    const double middle = std::min(copies_.halo, 0.5 * copies_.halo + 1.5 * copies_.near);
    const double end = std::min(copies_.halo, 2 * copies_.near);
    const double advanced =
        loaded < 1 ? (loaded + 4 * share(columns, rows, middle) + share(columns, rows, end)) / 6 : 1;
    const double patch = advanced * slowdown(loaded * disks_) + kLoading / copies_.contacts * loaded;
    return patch * std::ceil(static_cast<double>(columns) * rows / threads);
  }

 private:
  /// Of all disks, those within `width` of a patch.
  [[nodiscard]] double share(std::uint32_t columns, std::uint32_t rows, double width) const noexcept {
    const auto along = [width](double length, std::uint32_t parts) {
      const double part = length / parts + 2 * width;
      return parts == 1 || part > kLargestPart * length ? length : part;
    };
    return along(size_.x, columns) * along(size_.y, rows) / (size_.x * size_.y);
  }

  /// Of contacts, where the disks do not fit into the fast caches.
  [[nodiscard]] static double slowdown(double disks) noexcept {
    constexpr double kFit = 20'000;
    constexpr double kAllFar = 3.6;
    return std::min(1 + 0.6 * std::log2(std::max(1.0, disks / kFit)), kAllFar);
  }

  Vec2 size_;
  Copies copies_;
  double disks_;
};

}  // namespace

ParallelOptions divided(const System& system, const State& start, const SolverOptions& solver,
                        const ParallelOptions& parallel) {
  ParallelOptions chosen = parallel;
  if (solver.kind == SolverKind::reference || system.size() == 0) chosen.patches = {1, 1};
  if (chosen.patches) return chosen;
  chosen.patches = {1, 1};
  const auto [low_x, high_x] = std::minmax_element(start.disks.x.begin(), start.disks.x.end());
  const auto [low_y, high_y] = std::minmax_element(start.disks.y.begin(), start.disks.y.end());
  const double reach = 2 * system.largest_radius();
  const Vec2 size{std::max(*high_x - *low_x, reach), std::max(*high_y - *low_y, reach)};
  const Costs costs(size, copies_for(system, start, 0, kDepth), system.size());
  constexpr double kWorthIt = 0.9;
  constexpr std::uint32_t kMost = 128;
  double least = kWorthIt * costs.undivided();
  for (std::uint32_t columns = 1; columns <= kMost; ++columns) {
    for (std::uint32_t rows = 1; rows <= kMost; ++rows) {
      const double time = costs.divided(columns, rows, parallel.threads);
      if (columns * rows < 2 || !(time < least)) continue;
      least = time;
      chosen.patches = {columns, rows};
    }
  }
  return chosen;
}

std::unique_ptr<DividedSolver> make_patched_solver(const System& system, const SolverOptions& solver,
                                                   const ParallelOptions& parallel, const Checks& checks) {
  return std::make_unique<PatchedSolver>(system, solver, parallel, checks);
}

}  // namespace carom
