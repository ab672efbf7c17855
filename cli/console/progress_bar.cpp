#include "cli/console/progress_bar.hpp"

#include "cli/console/terminal.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <new>
#include <string>
#include <string_view>
#include <system_error>

namespace beespace::cli {
namespace {

constexpr std::chrono::milliseconds kPatience{1'000};
constexpr std::chrono::milliseconds kRedraw{100};
constexpr std::string_view kWipeLine = "\r\x1b[K";

std::string bar(double fraction) {
  constexpr int kWidth = 30;
  const int full = static_cast<int>(fraction * kWidth);
  std::string text = "[";
  for (int i = 0; i < kWidth; ++i) text += i < full ? '=' : ' ';
  return text + "]";
}

}  // namespace

std::string left_text(double fraction, double passed_s) {
  constexpr double kLeastShare = 0.01;
  constexpr double kLeast_s = 1.0;
  if (fraction < kLeastShare || fraction >= 1.0 || passed_s < kLeast_s) return {};
  return ", about " + io::time_span(std::ceil(passed_s * (1.0 - fraction) / fraction)) + " left";
}

ProgressBar::ProgressBar(bool wanted) {
  if (!wanted || !messages_are_on_terminal()) return;
  // Signals are for the main thread, whose waiting system calls they interrupt.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  try {
    thread_ = std::thread([this] {
      try {
        run();
      } catch (const std::bad_alloc&) {
        drawn_ = true;  // the line may stand there half; no memory for a bar is no error
      }
    });
  } catch (const std::system_error&) {
    finished_ = true;  // no thread to be had: the work goes on without a bar
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

ProgressBar::~ProgressBar() {
  finish();
}

void ProgressBar::enter_stage(const char* name) {
  const std::lock_guard lock(mutex_);
  if (std::string_view(name) == stage_.name) return;
  share_.store(kUnknown, std::memory_order_relaxed);
  stage_ = {name};
}

void ProgressBar::finish() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }
  wake_.notify_all();
  thread_.join();
  if (drawn_) say(kWipeLine);
}

void ProgressBar::run() {
  std::unique_lock lock(mutex_);
  auto wait = kPatience;
  while (!wake_.wait_for(lock, wait, [this] { return finished_; })) {
    draw(stage_);
    wait = kRedraw;
  }
}

void ProgressBar::draw(const Stage& at) {
  const std::string_view stage = at.name;
  const auto done = static_cast<double>(reading_.done.load(std::memory_order_relaxed));
  const auto total = static_cast<double>(reading_.total.load(std::memory_order_relaxed));
  std::string line(kWipeLine);
  line += stage;
  double fraction = share_.load(std::memory_order_relaxed);
  if (stage == kReading && total > 0.0) fraction = done / total;
  if (fraction >= 0.0) {
    fraction = std::clamp(fraction, 0.0, 1.0);
    line += ' ';
    line += bar(fraction);
    line += ' ';
    line += io::percentage(fraction);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - at.began;
    line += left_text(fraction, passed.count());
  } else {
    line += " ...";
  }
  if (stage == kReading && total == 0.0 && done > 0.0) {
    line += ' ';
    line += io::byte_count(static_cast<std::uint64_t>(done));
  }
  say(line);
  drawn_ = true;
}

}  // namespace beespace::cli
