// Runs of `beespace guide` and `beespace follow`, and the first messages of a fleet.
#pragma once

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace beespace::cli_test {

inline Arguments guide_with(const Arguments& more) {
  return Arguments{"guide", "--threshold",        "2", "--max-speed",
                   "10",    "--max-acceleration", "5", "--ticks-from-input"} +
         more;
}

inline Arguments follow_with(const Arguments& more) {
  return Arguments{
             "follow", "--agent", "a",      "--planned-speed",   "10", "--planned-acceleration",
             "5",      "--start", "0,0,30", "--ticks-from-input"} +
         more;
}

inline Finished guide(const std::string& input, const Arguments& more = {}) {
  return run(guide_with(more), input);
}

inline Finished follow(const std::string& input, const Arguments& more = {}) {
  return run(follow_with(more), input);
}

inline void expect_in(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << " in:\n" << text;
}

// The first line that has the part.
inline std::string line_with(const std::string& text, const std::string& part) {
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = text.find('\n', begin);
    const std::string line = text.substr(begin, end - begin);
    if (line.find(part) != std::string::npos) return line;
    if (end == std::string::npos) break;
    begin = end + 1;
  }
  ADD_FAILURE() << part << " in:\n" << text;
  return {};
}

inline std::string tick(int number) {
  return R"({"event": "tick", "tick": )" + std::to_string(number) + "}\n";
}

inline const std::string kJoin = R"({"event": "join", "id": "a", "position": [0, 0, 30]})"
                                 "\n";
inline const std::string kTick = tick(1);

}  // namespace beespace::cli_test
