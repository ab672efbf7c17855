#include "cpu/thread_crew.hpp"

#include <algorithm>
#include <exception>

namespace beespace::cpu {

unsigned crew_size(unsigned requested, std::size_t points) {
  constexpr std::size_t kPointsWorthAThread = 8192;
  constexpr unsigned kMostThreads = 256;
  if (requested == 0) requested = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t useful = std::max<std::size_t>(1, points / kPointsWorthAThread);
  return static_cast<unsigned>(std::min<std::size_t>({requested, useful, kMostThreads}));
}

ThreadCrew::ThreadCrew(unsigned size) {
  threads_.reserve(size);
  for (unsigned worker = 1; worker < size; ++worker) {
    try {
      threads_.emplace_back([this, worker] { work(worker); });
    } catch (const std::exception&) {  // no thread to be had, or no memory for one
      break;                           // fewer hands, the same answer
    }
  }
}

ThreadCrew::~ThreadCrew() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  start_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void ThreadCrew::run(const Task& task) {
  {
    const std::lock_guard lock(mutex_);
    task_ = &task;
    busy_ = threads_.size();
    ++round_;
  }
  start_.notify_all();
  perform(0);
  std::unique_lock lock(mutex_);
  done_.wait(lock, [this] { return busy_ == 0; });
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void ThreadCrew::work(unsigned worker) {
  unsigned seen = 0;
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      start_.wait(lock, [&] { return stopping_ || round_ != seen; });
      if (stopping_) return;
      seen = round_;
    }
    perform(worker);
    {
      const std::lock_guard lock(mutex_);
      --busy_;
    }
    done_.notify_one();
  }
}

void ThreadCrew::perform(unsigned worker) {
  try {
    (*task_)(worker);
  } catch (...) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
  }
}

}  // namespace beespace::cpu
