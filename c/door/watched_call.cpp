#include "c/door/watched_call.hpp"

#include "c/door/door.hpp"
#include "c/door/structs.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <new>
#include <optional>
#include <system_error>
#include <thread>

namespace beespace::c {

namespace {

// Often enough for a person at the keyboard.
constexpr std::chrono::milliseconds kBetweenPolls{50};

// Some work on a thread of its own, and how it ended.
class Worker {
 public:
  Worker(const WatchedWork& work, RunOptions options)
      : thread_([this, &work, options = std::move(options)] { run(work, options); }) {}

  // Whether it has ended by now, or ends within the time.
  bool wait_for(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, time, [this] { return ended_; });
  }

  Status finish() {
    thread_.join();
    if (thrown_) std::rethrow_exception(thrown_);
    return std::move(*status_);
  }

 private:
  void run(const WatchedWork& work, const RunOptions& options) {
    try {
      status_ = work(options);
    } catch (...) {
      thrown_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_one();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
  std::optional<Status> status_;
  std::exception_ptr thrown_;
  std::thread thread_;  // last: it uses all the others
};

Status poll_until_done(const beespace_run& run, RunOptions options, const WatchedWork& work) {
  std::stop_source source;
  const std::stop_callback pass_on(options.stop, [&source] { source.request_stop(); });
  options.stop = source.get_token();
  std::optional<Worker> worker;
  try {
    worker.emplace(work, options);
  } catch (const std::system_error&) {
    return work(options);  // no thread to be had: the answer matters more than the poll
  }
  bool asked = false;
  while (!worker->wait_for(kBetweenPolls)) {
    if (!asked && run.poll(run.poll_data) != 0) {
      asked = true;
      source.request_stop();
    }
  }
  Status status = worker->finish();
  // A poll may have taken a signal away to say so: the caller must hear of it, even where the
  // answer was complete by then, or another error came first.
  if (asked && (status || status.error().code != ErrorCode::kStopped))
    return Error{ErrorCode::kStopped, "the poll ended the call", {}};
  return status;
}

}  // namespace

unsigned threads_of(std::uint32_t threads) {
  if (threads == BEESPACE_ALL_PROCESSORS) return 0;
  return threads == 0 ? 1 : threads;
}

Status call_watched(const beespace_run* run, const WatchedWork& work) {
  if (run == nullptr) return work(RunOptions());
  const Result<beespace_run> given = read_struct(run, "run");
  if (!given) return given.error();
  RunOptions options;
  options.threads = threads_of(given->threads);
  if (given->stop != nullptr) options.stop = given->stop->source.get_token();
  return given->poll == nullptr ? work(options) : poll_until_done(*given, options, work);
}

}  // namespace beespace::c

extern "C" {

beespace_stop* beespace_stop_create(void) {
  try {
    return new beespace_stop;
  } catch (...) {
    return nullptr;
  }
}

void beespace_stop_request(beespace_stop* stop) {
  if (stop != nullptr) stop->source.request_stop();
}

void beespace_stop_free(beespace_stop* stop) {
  delete stop;
}

}  // extern "C"
