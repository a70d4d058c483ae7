#include "patched_solver.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "carom/window/patch.hpp"
#include "layout.hpp"

namespace carom {
namespace {

bool same_bits(double a, double b) noexcept {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

class PatchedSolver final : public DividedSolver {
 public:
  PatchedSolver(const System& system, const SolverOptions& solver, const ParallelOptions& parallel,
                const Checks& checks)
      : system_(system),
        options_(solver),
        parallel_(parallel),
        checks_(checks),
        executor_(make_executor(parallel.threads)),
        layout_(system, (*parallel.patches)[0], (*parallel.patches)[1]),
        reach_(2 * system.largest_radius()),
        loadings_(executor_->workers()) {
    for (std::size_t worker = 0; worker < executor_->workers(); ++worker) {
      solvers_.push_back(make_patch_solver(system, solver));
    }
    name_of_simd_ = make_fast_solver(system, solver)->simd();
    const double spacing = std::sqrt(system.box.size.x * system.box.size.y / static_cast<double>(system.size()));
    const double step = spacing > 0 ? spacing : reach_;
    near_ = parallel.near > 0 ? parallel.near : 2 * reach_ + 3 * step;
    halo_ = parallel.halo > 0 ? parallel.halo : near_ + 12 * step;
    halo_ = std::max(halo_, near_);
    reports_.resize(layout_.patches());
    attempts_.resize(layout_.patches());
    division_.threads = executor_->workers();
    division_.patches = layout_.patches();
  }

  [[nodiscard]] std::string_view name() const noexcept override { return "fast"; }
  [[nodiscard]] std::string_view simd() const noexcept override { return name_of_simd_; }
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
  }

  bool advance_to(double time, const std::atomic<bool>& interrupt) override {
    if (undivided_) return undivided_->advance_to(time, interrupt);
    if (time < start_->clock.length) {
      if (!books_at_start_) books_at_start_ = std::make_unique<Books>(*books_);
      if (++stops_ > 1) return go_on_undivided(time, interrupt);
    }
    if (books_at_start_) restore();
    if (!advance_patches(time, interrupt)) return false;
    commit();
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
    if (!sorted_) layout_.sort(start_->disks);
    sorted_ = true;
    make_room();
    std::vector<std::size_t> patches(layout_.patches());
    std::iota(patches.begin(), patches.end(), std::size_t{0});
    std::fill(attempts_.begin(), attempts_.end(), Attempt{near_, halo_, false});
    whole_plane_ = false;
    bool repaired = false;
    while (!patches.empty()) {
      if (!run(patches, until, interrupt)) return false;
      patches = failed();
      repaired = repaired || !patches.empty();
      division_.patches_repaired += patches.size();
      for (const std::size_t patch : patches) {
        attempts_[patch].near *= 2;
        attempts_[patch].halo = attempts_[patch].halo * 1.5 + attempts_[patch].near;
      }
      // Patches that need nearly all of the plane would each do the work of one that owns it.
      if (std::count_if(patches.begin(), patches.end(), [&](std::size_t k) { return is_hopeless(k); }) > 1) {
        return advance_whole_plane(until, interrupt);
      }
    }
    division_.windows_repaired += repaired ? 1 : 0;
    return true;
  }

  bool run(const std::vector<std::size_t>& patches, double until, const std::atomic<bool>& interrupt) {
    std::atomic<bool> finished{true};
    executor_->for_each(patches.size(), [&](std::size_t item, std::size_t worker) {
      const std::size_t patch = patches[item];
      Attempt& attempt = attempts_[patch];
      Loading& loading = loadings_[worker];
      layout_.load(patch, attempt.near, attempt.halo, loading);
      attempt.whole = loading.whole;
      if (!run(worker, loading, attempt, until, reports_[patch], interrupt)) finished = false;
    });
    division_.patch_windows += patches.size();
    return finished;
  }

  struct Attempt {
    double near = 0;
    double halo = 0;
    bool whole = false;  // all disks were loaded
  };

  bool run(std::size_t worker, const Loading& loading, const Attempt& attempt, double until, PatchReport& report,
           const std::atomic<bool>& interrupt) {
    const PatchTask task{loading.loaded, loading.cut, loading.disks, loading.roles, clear_of(attempt)};
    const PatchOutput output{&end_, &last_contact_, &events_, &history_, &virial_, &wall_impulse_};
    return solvers_[worker]->run(*start_, books_at_start(), task, until, log_ != nullptr, output, report, interrupt);
  }

  /// The whole plane as one patch: needs no check.
  bool advance_whole_plane(double until, const std::atomic<bool>& interrupt) {
    Loading& loading = loadings_[0];
    layout_.load_all(loading);
    whole_plane_ = true;
    ++division_.windows_repaired;
    ++division_.patch_windows;
    return run(0, loading, {near_, halo_, true}, until, reports_[0], interrupt);
  }

  /// How far an owned disk may go without being looked at one by one.
  [[nodiscard]] double clear_of(const Attempt& attempt) const noexcept { return (attempt.near - reach_) / 2; }
  [[nodiscard]] bool is_hopeless(std::size_t patch) const noexcept {
    return attempts_[patch].halo > 0.5 * std::max(system_.box.size.x, system_.box.size.y) || attempts_[patch].whole;
  }

  // --- verify ------------------------------------------------------------------------------------------------

  /// The patches whose result is not certain.
  [[nodiscard]] std::vector<std::size_t> failed() {
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
  /// they were near copies from the start.
  [[nodiscard]] bool excursions_stay_clear(std::size_t patch) const {
    const Attempt& attempt = attempts_[patch];
    const double clear = clear_of(attempt);
    const Rectangle own = layout_.owned(patch);
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

  /// Enters in books and log what the patches did.
  void commit() {
    Books& books = *books_;
    for (std::size_t id = 0; id < events_.size(); ++id) books.events_of[id] += events_[id];
    std::copy(virial_.begin(), virial_.end(), books.virial_of.begin());
    std::copy(wall_impulse_.begin(), wall_impulse_.end(), books.wall_impulse_of.begin());
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
  }

  const System& system_;
  SolverOptions options_;
  ParallelOptions parallel_;
  Checks checks_;
  std::unique_ptr<Executor> executor_;
  Layout layout_;
  double reach_;  // the largest contact distance
  double near_ = 0;
  double halo_ = 0;
  std::vector<std::unique_ptr<PatchSolver>> solvers_;  // one per worker
  std::vector<Loading> loadings_;                      // one per worker
  std::string_view name_of_simd_;

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

}  // namespace

std::unique_ptr<DividedSolver> make_patched_solver(const System& system, const SolverOptions& solver,
                                                   const ParallelOptions& parallel, const Checks& checks) {
  return std::make_unique<PatchedSolver>(system, solver, parallel, checks);
}

}  // namespace carom
