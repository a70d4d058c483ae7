// Who does the work: one thread or several. Something that spans processes can join.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace carom {

class Executor {
 public:
  virtual ~Executor() = default;
  Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  /// How many items can be worked on at once.
  [[nodiscard]] virtual std::size_t workers() const noexcept = 0;
  /// Calls work(item, worker) for every item below `count`, in any order; calls at the same time have different
  /// workers, each below workers(). What one of them throws is thrown here, once all have ended.
  virtual void for_each(std::size_t count, const std::function<void(std::size_t item, std::size_t worker)>& work) = 0;
};

/// Throws Error if so many threads cannot be had.
std::unique_ptr<Executor> make_executor(unsigned threads);

}  // namespace carom
