/// @file
/// @brief The threads that a search works with: beespace's own, or those of the caller's pool.
///
/// A Crew runs a task once per worker and returns when all calls have returned. The base class has
/// one worker: the calling thread. Derive from it to lend a search the threads of another pool.
#pragma once

#include <beespace/export.hpp>
#include <beespace/lifetimebound.hpp>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace beespace {

/// @brief A task for the workers of a Crew: a reference to a callable that takes the number of a
/// worker.
///
/// Ownership: none; the callable must outlive it. (std::function may allocate memory; this never
/// does.)
class CrewTask {
 public:
  /// @brief Refers to a callable.
  /// @param callable Called as `callable(unsigned worker)`; must outlive this.
  template <class Callable>
  requires(!std::is_same_v<std::remove_cvref_t<Callable>, CrewTask>)
      // NOLINTNEXTLINE(google-explicit-constructor, bugprone-forwarding-reference-overload)
      CrewTask(Callable&& callable BEESPACE_LIFETIMEBOUND)  // like a reference
      : callable_(const_cast<void*>(static_cast<const void*>(std::addressof(callable)))),
        call_([](void* object, unsigned worker) {
          (*static_cast<std::remove_reference_t<Callable>*>(object))(worker);
        }) {}

  /// @brief Calls the callable.
  /// @param worker The number of the worker, from 0.
  void operator()(unsigned worker) const { call_(callable_, worker); }

 private:
  void* callable_;
  void (*call_)(void* object, unsigned worker);
};

/// @brief Runs a task once per worker. The base class has one worker, the calling thread.
class BEESPACE_API Crew {
 public:
  /// @brief What a worker does.
  using Task = CrewTask;

  /// @brief One worker: the calling thread.
  Crew() = default;
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;
  /// @brief No task may be running.
  virtual ~Crew();

  /// @brief Says how many workers there are.
  /// @return At least 1, and always the same.
  [[nodiscard]] virtual unsigned size() const { return 1; }

  /// @brief Calls `task(worker)` once for each worker in [0, size()), on any threads, and returns
  /// when all calls have returned.
  ///
  /// A task never waits for another worker, so the calls may be made one after the other on one
  /// thread. If a call throws (std::bad_alloc), an implementation must rethrow that here, after all
  /// calls have returned. It must be safe to call from several threads at once where the crew is
  /// lent to objects that are used so.
  ///
  /// @param task What each worker does.
  virtual void run(Task task) { task(0); }

  /// @brief Says which of `count` items belong to a worker.
  /// @param count How many items there are.
  /// @param worker The number of the worker, below size().
  /// @return The interval [first, second) of the worker's items.
  [[nodiscard]] std::pair<std::size_t, std::size_t> share(std::size_t count,
                                                          unsigned worker) const {
    return {count * worker / size(), count * (worker + 1) / size()};
  }

  /// @brief Calls `task(begin, end, worker)` with each worker's share of `count` items.
  ///
  /// (Its visibility is hidden: each library that calls it has an instantiation of its own.)
  ///
  /// @param count How many items there are.
  /// @param task What each worker does with its interval [begin, end).
  template <class SharedTask>
  [[gnu::visibility("hidden")]] void split(std::size_t count, SharedTask&& task) {
    run([&](unsigned worker) {
      const auto [begin, end] = share(count, worker);
      task(begin, end, worker);
    });
  }
};

/// @brief A Crew with threads of its own, which sleep between tasks.
///
/// Thread safety: many threads may use one ThreadCrew at the same time without waiting for each
/// other. A caller that finds the workers busy runs the parts of all workers itself. So a process
/// that shares one ThreadCrew never has more threads at work than its callers and those of this.
class BEESPACE_API ThreadCrew final : public Crew {
 public:
  /// @brief Starts the threads.
  /// @param size The number of workers, of which the caller of run() is one, at most 256; 0 means
  /// one
  ///   per processor. If the system gives fewer threads than asked for, there are fewer workers.
  explicit ThreadCrew(unsigned size = 0);
  ThreadCrew(const ThreadCrew&) = delete;
  ThreadCrew& operator=(const ThreadCrew&) = delete;
  /// @brief Ends the threads; no task may be running.
  ~ThreadCrew() override;

  /// @brief Says how many workers there are.
  /// @return At least 1, and always the same.
  [[nodiscard]] unsigned size() const override;
  /// @brief As Crew::run.
  /// @param task What each worker does.
  void run(Task task) override;

 private:
  class Threads;
  std::unique_ptr<Threads> threads_;
};

}  // namespace beespace
