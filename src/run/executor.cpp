#include "executor.hpp"

#include <fmt/format.h>

#ifndef __EMSCRIPTEN__
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>
#endif

#include "carom/base/error.hpp"

namespace carom {
namespace {

class Serial final : public Executor {
 public:
  [[nodiscard]] std::size_t workers() const noexcept override { return 1; }
  void for_each(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work) override {
    for (std::size_t item = 0; item < count; ++item) work(item, 0);
  }
};

#ifndef __EMSCRIPTEN__  // its C++ library has no std::jthread

/// The caller's thread and helpers that wait between calls; each takes the next item when it has done with one.
/// Plain threads and locks: the thread sanitizer cannot see into libraries that are not compiled with it.
class Threads final : public Executor {
 public:
  explicit Threads(unsigned threads) {
    for (unsigned worker = 1; worker < threads; ++worker) {
      helpers_.emplace_back([this, worker](const std::stop_token& stop) { help(worker, stop); });
    }
  }

  [[nodiscard]] std::size_t workers() const noexcept override { return helpers_.size() + 1; }

  void for_each(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work) override {
    {
      const std::lock_guard lock(mutex_);
      work_ = &work;
      count_ = count;
      next_ = 0;
      helping_ = helpers_.size();
      failure_ = nullptr;
      ++round_;
    }
    begun_.notify_all();
    take_items(0);
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [this] { return helping_ == 0; });
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void help(std::size_t worker, const std::stop_token& stop) {
    for (std::uint64_t round = 1;; ++round) {
      {
        std::unique_lock lock(mutex_);
        if (!begun_.wait(lock, stop, [&] { return round_ == round; })) return;
      }
      take_items(worker);
      const std::lock_guard lock(mutex_);
      if (--helping_ == 0) ended_.notify_one();
    }
  }

  void take_items(std::size_t worker) noexcept {
    try {
      for (std::size_t item; (item = next_.fetch_add(1)) < count_;) (*work_)(item, worker);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
      next_ = count_;
    }
  }

  std::mutex mutex_;
  std::condition_variable_any begun_;
  std::condition_variable ended_;
  // Of the call that goes on; written while nobody works on it.
  const std::function<void(std::size_t, std::size_t)>* work_ = nullptr;
  std::size_t count_ = 0;
  std::atomic<std::size_t> next_ = 0;
  std::size_t helping_ = 0;
  std::exception_ptr failure_;
  std::uint64_t round_ = 0;            // number of calls
  std::vector<std::jthread> helpers_;  // last: they end before what they use
};

#endif

}  // namespace

std::unique_ptr<Executor> make_executor(unsigned threads) {
  if (threads <= 1) return std::make_unique<Serial>();
#ifdef __EMSCRIPTEN__
  throw Error(fmt::format("cannot start {} threads: this build has none", threads));
#else
  try {
    return std::make_unique<Threads>(threads);
  } catch (const std::system_error& error) {
    throw Error(fmt::format("cannot start {} threads: {}", threads, error.code().message()));
  }
#endif
}

}  // namespace carom
