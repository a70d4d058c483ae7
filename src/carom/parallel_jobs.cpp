#include "parallel_jobs.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace carom {
namespace {

/// What the threads share: which job is next, and how many threads still work.
class Queue {
 public:
  Queue(std::size_t count, std::size_t workers) : count_(count), working_(workers) {}

  void work_off(const std::function<bool(std::size_t)>& work) {
    for (std::size_t job = take(); job < count_; job = take()) {
      if (!work(job)) stop();
    }
    const std::lock_guard lock(mutex_);
    --working_;
    all_done_.notify_all();
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
};

}  // namespace

void work_in_parallel(unsigned threads, std::size_t count, const std::function<bool(std::size_t)>& work,
                      const std::function<void()>& meanwhile) {
  const std::size_t workers = std::min<std::size_t>(std::max(threads, 1u), count);
  Queue queue(count, workers);
  std::vector<std::thread> pool;
  for (std::size_t k = 0; k < workers; ++k) pool.emplace_back([&] { queue.work_off(work); });
  while (!queue.wait()) meanwhile();
  for (std::thread& thread : pool) thread.join();
  meanwhile();
}

}  // namespace carom
