// How much memory the program takes while something goes on.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <string>
#include <thread>

namespace beespace::bench {

// Memory of the process that no file stands behind, in bytes.
inline std::uint64_t anonymous_bytes() {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    std::uint64_t kilobytes = 0;
    if (word == "RssAnon:" && status >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

// Looks fifty times a second.
class PeakMemory {
 public:
  PeakMemory()
      : thread_([this](const std::stop_token& stop) {
          while (!stop.stop_requested()) {
            peak_ = std::max(peak_.load(), anonymous_bytes());
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
          }
        }) {}

  [[nodiscard]] std::uint64_t bytes() const { return peak_; }

 private:
  std::atomic<std::uint64_t> peak_ = 0;
  std::jthread thread_;
};

}  // namespace beespace::bench
