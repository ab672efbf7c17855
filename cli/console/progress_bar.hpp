// A line on the terminal that says how far the work has come, when it takes more than a second, and
// about how long its stage will take yet.
//
// One small thread draws ten times a second; the working threads only write atomics. The line is
// wiped when the object ends. Nothing is drawn where standard error is no terminal.
#pragma once

#include "io/bytes/progress.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace beespace::cli {

class ProgressBar {
 public:
  explicit ProgressBar(bool wanted);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // What is being done from now on: a literal, such as "searching".
  void enter_stage(const char* name);

  // How much of this stage is done, from 0 to 1, where that is known: then the bar shows it.
  void set_share(double done) { share_.store(done, std::memory_order_relaxed); }

  // For the reader to fill in; the bar shows its fraction during the stage kReading.
  io::Progress& reading() { return reading_; }
  static constexpr const char* kReading = "reading";

  // Wipes the line and ends the thread; before other messages.
  void finish();

 private:
  static constexpr double kUnknown = -1.0;

  // Of a stage: a literal, and when it began.
  struct Stage {
    const char* name = kReading;
    std::chrono::steady_clock::time_point began = std::chrono::steady_clock::now();
  };

  void run();
  void draw(const Stage& at);

  io::Progress reading_;
  std::atomic<double> share_{kUnknown};
  std::mutex mutex_;
  std::condition_variable wake_;
  Stage stage_;  // as what follows, under the mutex
  bool finished_ = false;
  bool drawn_ = false;
  std::thread thread_;
};

// ", about 5 s left": what a stage will take yet, at its pace so far; nothing as long as that is a
// guess.
std::string left_text(double fraction, double passed_s);

}  // namespace beespace::cli
