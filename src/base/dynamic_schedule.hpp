// A dynamic schedule: work of uneven weight, distributed to the threads as they become free.
#pragma once

#include "base/stopping.hpp"

#include <beespace/crew.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace beespace::cpu {

// Calls task(begin, end, worker) for stretches of `count` things, at most `chunk` at a time. A
// worker that is done takes the next stretch, so the distribution differs from run to run.
template <class Task>
void schedule(Crew& crew, std::size_t count, std::size_t chunk, Task&& task) {
  std::atomic<std::size_t> next = 0;
  crew.run([&](unsigned worker) {
    for (;;) {
      const std::size_t begin = next.fetch_add(chunk, std::memory_order_relaxed);
      if (begin >= count || core::is_stopping()) return;
      task(begin, std::min(begin + chunk, count), worker);
    }
  });
}

}  // namespace beespace::cpu
