#include "executor.hpp"

#include <fmt/format.h>

#include "carom/base/error.hpp"

#ifdef CAROM_HAS_TBB
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#endif

namespace carom {
namespace {

class Serial final : public Executor {
 public:
  [[nodiscard]] std::size_t workers() const noexcept override { return 1; }
  void for_each(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work) override {
    for (std::size_t item = 0; item < count; ++item) work(item, 0);
  }
};

#ifdef CAROM_HAS_TBB
namespace tbb = oneapi::tbb;

class Threads final : public Executor {
 public:
  explicit Threads(unsigned threads)
      : allowed_(tbb::global_control::max_allowed_parallelism, threads),
        arena_(static_cast<int>(threads)),
        threads_(threads) {}

  [[nodiscard]] std::size_t workers() const noexcept override { return threads_; }
  void for_each(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work) override {
    arena_.execute([&] {
      tbb::parallel_for(
          std::size_t{0}, count,
          [&](std::size_t item) { work(item, static_cast<std::size_t>(tbb::this_task_arena::current_thread_index())); },
          tbb::simple_partitioner());
    });
  }

 private:
  tbb::global_control allowed_;  // oneTBB by itself has no more threads than the machine has cores
  tbb::task_arena arena_;
  std::size_t threads_;
};
#endif

}  // namespace

bool has_threads() noexcept {
#ifdef CAROM_HAS_TBB
  return true;
#else
  return false;
#endif
}

std::unique_ptr<Executor> make_executor(unsigned threads) {
  if (threads <= 1) return std::make_unique<Serial>();
#ifdef CAROM_HAS_TBB
  return std::make_unique<Threads>(threads);
#else
  throw Error(fmt::format("{} threads: this build has only one (it was made without oneTBB)", threads));
#endif
}

}  // namespace carom
