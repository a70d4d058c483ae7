#include "parallel_jobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "carom/base/error.hpp"

namespace carom {
namespace {

/// What the threads share: which job is next, and how many threads still work.
class Queue {
 public:
  Queue(std::size_t count, std::size_t workers) : count_(count), working_(workers) {}

  void work_off(const std::function<bool(std::size_t)>& work) {
    try {
      for (std::size_t job = take(); job < count_; job = take()) {
        if (!work(job)) stop();
      }
    } catch (...) {
      stop_for(std::current_exception());
    }
    leave(1);
  }

  /// So many workers will not come.
  void leave(std::size_t workers) {
    const std::lock_guard lock(mutex_);
    working_ -= workers;
    all_done_.notify_all();
  }

  /// No other job begins.
  void stop_for(std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    next_ = count_;
    if (!failure_) failure_ = std::move(failure);
  }

  /// To be called when nobody works any more.
  void rethrow_failure() const {
    if (failure_) std::rethrow_exception(failure_);
  }

  /// Whether all are done, after waiting at most a tenth of a second.
  bool wait() {
    std::unique_lock lock(mutex_);
    return all_done_.wait_for(lock, std::chrono::milliseconds(100), [this] { return working_ == 0; });
  }

 private:
  std::size_t take() {
    const std::lock_guard lock(mutex_);
    return next_ < count_ ? next_++ : count_;
  }
  void stop() {
    const std::lock_guard lock(mutex_);
    next_ = count_;
  }

  std::mutex mutex_;
  std::condition_variable all_done_;
  std::size_t count_;
  std::size_t next_ = 0;
  std::size_t working_;
  std::exception_ptr failure_;
};

}  // namespace

void work_in_parallel(unsigned threads, std::size_t count, const std::function<bool(std::size_t)>& work,
                      const std::function<void()>& meanwhile) {
  const std::size_t workers = std::min<std::size_t>(std::max(threads, 1u), count);
  Queue queue(count, workers);
  std::vector<std::thread> pool;
  try {
    pool.reserve(workers);
    while (pool.size() < workers) pool.emplace_back([&] { queue.work_off(work); });
  } catch (const std::system_error& error) {
    queue.stop_for(
        std::make_exception_ptr(Error(fmt::format("cannot start {} threads: {}", workers, error.code().message()))));
  } catch (...) {
    queue.stop_for(std::current_exception());
  }
  queue.leave(workers - pool.size());
  while (!queue.wait()) meanwhile();
  for (std::thread& thread : pool) thread.join();
  queue.rethrow_failure();
  meanwhile();
}

}  // namespace carom
