// Independent pieces of work on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace carom {

/// Calls work(0), work(1), … up to `count` − 1, each once, `threads` at a time, in the order in which threads become
/// free; none is begun after one has returned false or thrown, and what it threw is thrown again when all have ended,
/// or Error if threads cannot be started. About ten times a second calls `meanwhile` from the caller's thread, and once
/// more at the end.
void work_in_parallel(unsigned threads, std::size_t count, const std::function<bool(std::size_t)>& work,
                      const std::function<void()>& meanwhile);

}  // namespace carom
