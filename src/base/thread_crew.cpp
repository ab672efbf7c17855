#include <beespace/crew.hpp>

#include "base/crew_size.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace beespace {

namespace cpu {

namespace {

constexpr unsigned kMostThreads = 256;

unsigned processors() {
  return std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace

unsigned crew_size(unsigned requested, std::size_t points) {
  constexpr std::size_t kPointsWorthAThread = 8192;
  if (requested == 0) requested = processors();
  const std::size_t useful = std::max<std::size_t>(1, points / kPointsWorthAThread);
  return static_cast<unsigned>(std::min<std::size_t>({requested, useful, kMostThreads}));
}

}  // namespace cpu

Crew::~Crew() = default;

class ThreadCrew::Threads {
 public:
  explicit Threads(unsigned size) {
    if (size == 0) size = cpu::processors();
    size = std::min(size, cpu::kMostThreads);
    threads_.reserve(size);
    for (unsigned worker = 1; worker < size; ++worker) {
      try {
        threads_.emplace_back([this, worker] { work(worker); });
      } catch (const std::exception&) {  // no thread to be had, or no memory for one
        break;                           // fewer threads, the same answer
      }
    }
  }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

  ~Threads() {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
    }
    start_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  [[nodiscard]] unsigned size() const { return static_cast<unsigned>(threads_.size()) + 1; }

  void run(const Crew::Task& task) {
    // While the threads are busy, also with a task that this call is part of: runs all parts, one
    // by one.
    if (threads_.empty() || at_work_.exchange(true)) {
      for (unsigned worker = 0; worker < size(); ++worker) task(worker);
      return;
    }
    share(task);
    std::exception_ptr failure = std::exchange(failure_, nullptr);
    at_work_ = false;
    if (failure) std::rethrow_exception(failure);
  }

 private:
  void share(const Crew::Task& task) {
    {
      const std::lock_guard lock(mutex_);
      task_ = &task;
      busy_ = threads_.size();
      ++round_;
    }
    start_.notify_all();
    perform(0);
    if (comes_soon([this] { return busy_ == 0; })) return;
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return busy_ == 0; });
  }

  // A search is a row of short tasks: a thread that sleeps after each wakes up late for the next.
  template <class Condition>
  static bool comes_soon(const Condition& condition) {
    constexpr auto kSoon = std::chrono::microseconds(50);
    constexpr int kLooks = 64;  // between two looks at the clock
    const auto give_up = std::chrono::steady_clock::now() + kSoon;
    do {
      for (int look = 0; look < kLooks; ++look) {
        if (condition()) return true;
      }
    } while (std::chrono::steady_clock::now() < give_up);
    return false;
  }

  void work(unsigned worker) {
    unsigned seen = 0;
    for (;;) {
      const auto wanted = [&] { return stopping_ || round_ != seen; };
      if (!comes_soon(wanted)) {
        std::unique_lock lock(mutex_);
        start_.wait(lock, wanted);
      }
      if (stopping_) return;
      seen = round_;
      perform(worker);
      {
        const std::lock_guard lock(mutex_);
        --busy_;
      }
      done_.notify_one();
    }
  }

  void perform(unsigned worker) {
    try {
      (*task_)(worker);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
  }

  std::atomic<bool> at_work_ = false;  // on the task of one of the callers
  std::mutex mutex_;
  std::condition_variable start_;
  std::condition_variable done_;
  const Crew::Task* task_ = nullptr;
  // Written under the mutex, looked at without it too.
  std::atomic<unsigned> round_ = 0;
  std::atomic<std::size_t> busy_ = 0;
  std::atomic<bool> stopping_ = false;
  std::exception_ptr failure_;
  std::vector<std::thread> threads_;
};

ThreadCrew::ThreadCrew(unsigned size) : threads_(std::make_unique<Threads>(size)) {
}
ThreadCrew::~ThreadCrew() = default;

unsigned ThreadCrew::size() const {
  return threads_->size();
}

void ThreadCrew::run(Task task) {
  threads_->run(task);
}

}  // namespace beespace
