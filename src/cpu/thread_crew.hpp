// A crew of threads for the duration of one search. Nothing global: two searches on two threads
// have two crews. If the system gives fewer threads than asked for, the crew is smaller.
#pragma once

#include "core/crew.hpp"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace beespace::cpu {

// How many workers suit `requested` threads (0: all processors) and `points` points: small
// searches are over before a second thread has started.
unsigned crew_size(unsigned requested, std::size_t points);

class ThreadCrew final : public core::Crew {
 public:
  explicit ThreadCrew(unsigned size);
  ThreadCrew(const ThreadCrew&) = delete;
  ThreadCrew& operator=(const ThreadCrew&) = delete;
  ~ThreadCrew() override;

  [[nodiscard]] unsigned size() const override {
    return static_cast<unsigned>(threads_.size()) + 1;
  }
  void run(const Task& task) override;

 private:
  void work(unsigned worker);
  void perform(unsigned worker);

  std::mutex mutex_;
  std::condition_variable start_;
  std::condition_variable done_;
  const Task* task_ = nullptr;
  unsigned round_ = 0;
  std::size_t busy_ = 0;
  bool stopping_ = false;
  std::exception_ptr failure_;
  std::vector<std::thread> threads_;
};

}  // namespace beespace::cpu
