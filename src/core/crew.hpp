// The hands that share a search: `run` calls a task once per worker and returns when all are done.
//
// The base class is a crew of one, the calling thread. src/cpu adds threads. Algorithms split their
// work by worker number, so they read the same for one worker and for many.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>

namespace beespace::core {

class Crew {
 public:
  using Task = std::function<void(unsigned worker)>;

  Crew() = default;
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;
  virtual ~Crew() = default;

  [[nodiscard]] virtual unsigned size() const { return 1; }
  // Rethrows the first exception of a worker (std::bad_alloc), after all have stopped.
  virtual void run(const Task& task) { task(0); }

  // The part [first, second) of `count` things that belongs to `worker`.
  [[nodiscard]] std::pair<std::size_t, std::size_t> share(std::size_t count,
                                                          unsigned worker) const {
    return {count * worker / size(), count * (worker + 1) / size()};
  }

  // Calls task(begin, end, worker) with each worker's share of `count` things.
  template <class SharedTask>
  void split(std::size_t count, SharedTask&& task) {
    run([&](unsigned worker) {
      const auto [begin, end] = share(count, worker);
      task(begin, end, worker);
    });
  }
};

}  // namespace beespace::core
