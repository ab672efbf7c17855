#include "base/stopping.hpp"

namespace beespace::core {

namespace {

// Of the call that this thread works for, if that can be stopped.
thread_local const std::stop_token* current_stop = nullptr;

class Scope {
 public:
  explicit Scope(const std::stop_token* stop) : before_(std::exchange(current_stop, stop)) {}
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;
  ~Scope() { current_stop = before_; }

 private:
  const std::stop_token* before_;
};

}  // namespace

NotStopping::NotStopping() : before_(std::exchange(current_stop, nullptr)) {
}
NotStopping::~NotStopping() {
  current_stop = before_;
}

Error stopped_error() {
  return {ErrorCode::kStopped, "a stop was requested before the answer was complete", {}};
}

bool is_stopping() {
  return current_stop != nullptr && current_stop->stop_requested();
}

void StoppableCrew::run(Task task) {
  if (!stop_->stop_possible()) return crew_->run(task);
  if (stop_->stop_requested()) throw Stopped();
  crew_->run([&](unsigned worker) {
    const Scope scope(stop_);
    task(worker);
  });
  if (stop_->stop_requested()) throw Stopped();
}

}  // namespace beespace::core
