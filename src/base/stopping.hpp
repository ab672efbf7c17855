// How a long search ends early: by an exception inside the library, which no caller sees.
//
// Workers look at the stop token of the call between two pieces of their work and return; the
// thread that called then throws. So what an unfinished task has left behind is never read, and no
// exception goes through the threads of a crew.
#pragma once

#include <beespace/crew.hpp>
#include <beespace/result.hpp>

#include <algorithm>
#include <cstddef>
#include <stop_token>
#include <utility>

namespace beespace::core {

// A stop was requested. Thrown by the crew of a call, and caught by unless_stopped.
struct Stopped {};

Error stopped_error();

// For loops that work on a piece of a task: whether the call that this thread works for is to end.
bool is_stopping();

// Calls work(begin, end) for one stretch of [0, size) after the other: some milliseconds of work
// that takes nanoseconds each. Ends early, with stretches missing, where the call is to end.
template <class Work>
void in_stretches(std::size_t size, Work&& work) {
  constexpr std::size_t kStretch = std::size_t{1} << 20;
  for (std::size_t begin = 0; begin < size && !is_stopping(); begin += kStretch) {
    work(begin, std::min(begin + kStretch, size));
  }
}

// While it lives, this thread works for no call that can be stopped: around calls of the caller's
// functions, which may search themselves.
class NotStopping {
 public:
  NotStopping();
  NotStopping(const NotStopping&) = delete;
  NotStopping& operator=(const NotStopping&) = delete;
  ~NotStopping();

 private:
  const std::stop_token* before_;
};

// A crew whose tasks can be given up.
class StoppableCrew final : public Crew {
 public:
  // Both must outlive this.
  StoppableCrew(Crew& crew, const std::stop_token& stop) : crew_(&crew), stop_(&stop) {}

  [[nodiscard]] unsigned size() const override { return crew_->size(); }
  // Throws Stopped where a stop was requested.
  void run(Task task) override;

 private:
  Crew* crew_;
  const std::stop_token* stop_;
};

// What work() returns, or the error of a call that was stopped.
template <class Work>
auto unless_stopped(Work&& work) -> decltype(work()) {
  try {
    return std::forward<Work>(work)();
  } catch (const Stopped&) {
    return stopped_error();
  }
}

}  // namespace beespace::core
