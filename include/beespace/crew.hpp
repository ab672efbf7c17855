// The hands that share a search: threads of beespace's own, or of the caller's pool.
//
// A crew runs a task once per worker and returns when all are done. The base class is a crew of
// one: the calling thread. Derive from it to lend a search the threads of another pool.
#pragma once

#include <beespace/export.hpp>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace beespace {

// What a worker does: a reference to something callable with a worker's number, which must outlive
// it. (std::function may allocate memory; this never does.)
class CrewTask {
 public:
  template <class Callable>
  requires(!std::is_same_v<std::remove_cvref_t<Callable>, CrewTask>)
      // NOLINTNEXTLINE(google-explicit-constructor, bugprone-forwarding-reference-overload)
      CrewTask(Callable&& callable)  // like a reference
      : callable_(const_cast<void*>(static_cast<const void*>(std::addressof(callable)))),
        call_([](void* object, unsigned worker) {
          (*static_cast<std::remove_reference_t<Callable>*>(object))(worker);
        }) {}

  void operator()(unsigned worker) const { call_(callable_, worker); }

 private:
  void* callable_;
  void (*call_)(void* object, unsigned worker);
};

class BEESPACE_API Crew {
 public:
  using Task = CrewTask;

  Crew() = default;
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;
  virtual ~Crew();

  // How many workers there are; always the same, and at least 1.
  [[nodiscard]] virtual unsigned size() const { return 1; }

  // Calls task(worker) once for each worker in [0, size()), on any threads, and returns when all
  // have returned. The calls must not wait for each other. An exception (std::bad_alloc) of a call
  // is rethrown here after all have stopped.
  virtual void run(Task task) { task(0); }

  // The part [first, second) of `count` things that belongs to `worker`.
  [[nodiscard]] std::pair<std::size_t, std::size_t> share(std::size_t count,
                                                          unsigned worker) const {
    return {count * worker / size(), count * (worker + 1) / size()};
  }

  // Calls task(begin, end, worker) with each worker's share of `count` things. (Hidden: what
  // the compiler makes of it belongs to whoever calls.)
  template <class SharedTask>
  [[gnu::visibility("hidden")]] void split(std::size_t count, SharedTask&& task) {
    run([&](unsigned worker) {
      const auto [begin, end] = share(count, worker);
      task(begin, end, worker);
    });
  }
};

// A crew of threads of its own, which sleep between tasks.
//
// Many threads may use one crew at the same time without waiting for each other: whoever finds it
// at work does all the workers' parts alone. So a process that shares one crew never has more
// threads at work than its callers and this crew's.
class BEESPACE_API ThreadCrew final : public Crew {
 public:
  // `size` workers, of which the caller of run() is one; 0 means one per processor. If the system
  // gives fewer threads than asked for, the crew is smaller.
  explicit ThreadCrew(unsigned size = 0);
  ThreadCrew(const ThreadCrew&) = delete;
  ThreadCrew& operator=(const ThreadCrew&) = delete;
  ~ThreadCrew() override;

  [[nodiscard]] unsigned size() const override;
  void run(Task task) override;

 private:
  class Threads;
  std::unique_ptr<Threads> threads_;
};

}  // namespace beespace
