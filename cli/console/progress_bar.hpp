// A line on the terminal that says how far the work has come, when it takes more than a second.
//
// One small thread draws ten times a second; the working threads only write atomics. The line is
// wiped when the object ends. Nothing is drawn where standard error is no terminal.
#pragma once

#include "io/bytes/progress.hpp"

#include <atomic>
#include <condition_variable>
#include <mutex>
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

  void run();
  void draw();

  io::Progress reading_;
  std::atomic<const char*> stage_{kReading};
  std::atomic<double> share_{kUnknown};
  std::mutex mutex_;
  std::condition_variable wake_;
  bool finished_ = false;
  bool drawn_ = false;
  std::thread thread_;
};

}  // namespace beespace::cli
