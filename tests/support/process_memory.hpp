// The memory of the test itself, as Linux counts it.
#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>

namespace beespace::test {

inline std::optional<std::uint64_t> status_bytes(const std::string& field) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word != field) continue;
    std::uint64_t kibibytes = 0;
    status >> kibibytes;
    return kibibytes * 1024;
  }
  return std::nullopt;
}

// From now on "VmHWM:" is the most since then; false where the system cannot.
inline bool reset_peak() {
  std::ofstream clear("/proc/self/clear_refs");
  clear << "5" << std::flush;
  return clear.good() && status_bytes("VmHWM:").has_value();
}

}  // namespace beespace::test
