#include "bench/compare/cost_meters.hpp"

#include <algorithm>
#include <ctime>
#include <fstream>
#include <string>

namespace beespace::compare {
namespace {

double milliseconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// A line of /proc/self/status in megabytes (10^6 bytes).
double status_mb(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(name)) return std::stod(line.substr(name.size())) * 1024.0 / 1e6;
  }
  return 0.0;
}

}  // namespace

Stopwatch::Stopwatch()
    : cpu_start_ms_(milliseconds(CLOCK_PROCESS_CPUTIME_ID)),
      wall_start_ms_(milliseconds(CLOCK_MONOTONIC)) {
}

double Stopwatch::cpu_ms() const {
  return milliseconds(CLOCK_PROCESS_CPUTIME_ID) - cpu_start_ms_;
}

double Stopwatch::wall_ms() const {
  return milliseconds(CLOCK_MONOTONIC) - wall_start_ms_;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double peak_of_process_mb() {
  return status_mb("VmHWM:");
}

MemoryMeter::MemoryMeter() {
  std::ofstream("/proc/self/clear_refs") << "5";  // the peak starts anew
  start_mb_ = status_mb("VmRSS:");
}

double MemoryMeter::peak_mb() const {
  return peak_of_process_mb() - start_mb_;
}

}  // namespace beespace::compare
