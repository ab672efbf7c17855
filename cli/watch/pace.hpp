// How fast a recording is read: as fast as it happened, so many reports a second, or at once.
#pragma once

#include "cli/console/signals.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>

namespace beespace::cli {

class Pace {
 public:
  // `speed` times as fast as by the clock of the reports; or `rate` reports a second.
  Pace(std::optional<double> speed, std::optional<double> rate) : speed_(speed), rate_(rate) {}

  // Waits until a report of this time is due, or the end is asked for.
  void wait_for(double time_s) {
    if (!speed_ && !rate_) return;
    const auto now = std::chrono::steady_clock::now();
    if (!start_) {
      start_ = now;
      first_s_ = time_s;
    }
    const double due_s = speed_ ? (time_s - first_s_) / *speed_ : count_ / *rate_;
    count_ += 1.0;
    // A day at most at a time: clocks may say anything.
    constexpr double kDay_s = 86'400.0;
    const std::chrono::duration<double> passed = now - *start_;
    wait(std::min(due_s - passed.count(), kDay_s));
  }

 private:
  // In short sleeps, which outlive no Ctrl-C for long.
  static void wait(double for_s) {
    using Seconds = std::chrono::duration<double>;
    const auto begin = std::chrono::steady_clock::now();
    while (!interrupted()) {
      const Seconds rest = Seconds(for_s) - (std::chrono::steady_clock::now() - begin);
      if (rest.count() <= 0.0) return;
      std::this_thread::sleep_for(std::min(rest, Seconds(0.1)));
    }
  }

  std::optional<double> speed_;
  std::optional<double> rate_;
  std::optional<std::chrono::steady_clock::time_point> start_;
  double first_s_ = 0.0;
  double count_ = 0.0;
};

}  // namespace beespace::cli
