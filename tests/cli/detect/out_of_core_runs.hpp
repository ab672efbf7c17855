// Runs of `beespace detect` with --memory, and beside them without.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <string_view>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {

// The document without what differs from run to run.
inline std::string without_timings(std::string json) {
  const std::size_t begin = json.find("  \"timings\": {");
  if (begin != std::string::npos)
    json.erase(begin, json.find('\n', json.find('}', begin)) + 1 - begin);
  return json;
}

class OutOfCoreRuns : public testing::Test {
 protected:
  // With so little memory that some ten thousand points make several cells.
  [[nodiscard]] Finished small(const Arguments& arguments, std::string_view input = {},
                               const Surroundings& surroundings = {}) const {
    return run(
        Arguments{"detect"} + arguments +
            Arguments{"--memory", "17MB", "--threads", "1", "--temporary", scratch_.path("")},
        input, surroundings);
  }

  // The answers with and without --memory are the same bytes, at least so many.
  void expect_same(const Arguments& arguments, std::string_view input = {},
                   std::size_t least = 4) const {
    expect_answer(arguments, arguments, input, least);
  }
  // Of `arguments` with --memory that of `whole` without.
  void expect_answer(const Arguments& arguments, const Arguments& whole,
                     std::string_view input = {}, std::size_t least = 4) const {
    SCOPED_TRACE(joined(arguments));
    const Finished expected = run(Arguments{"detect"} + whole, input);
    const Finished found = small(arguments, input);
    EXPECT_EQ(found.exit_code, expected.exit_code) << found.err;
    EXPECT_GE(expected.out.size(), least) << expected.err;
    EXPECT_TRUE(without_timings(found.out) == without_timings(expected.out))
        << found.out.substr(0, 1000) << "\ninstead of\n"
        << expected.out.substr(0, 1000);
    EXPECT_TRUE(scratch_.names().empty());
  }

  void expect_refused(const Arguments& arguments, int exit_code, const std::string& message,
                      std::string_view input = {}) const {
    const Finished finished = small(arguments, input);
    EXPECT_EQ(finished.exit_code, exit_code) << joined(arguments);
    EXPECT_EQ(finished.out, "");
    EXPECT_NE(finished.err.find(message), std::string::npos) << "'" << message << "' in\n"
                                                             << finished.err;
  }

  // The path of a generated swarm: `points` of them, about as dense as one a cubic metre.
  [[nodiscard]] std::string swarm(const std::string& name, int points = 100'000) const {
    const std::string path = folder_.path(name);
    EXPECT_EQ(run({"generate", "--points", std::to_string(points), "--size", "46", "--quiet",
                   "--output", path})
                  .exit_code,
              0);
    return path;
  }

  static std::string joined(const Arguments& arguments) {
    std::string text;
    for (const std::string& argument : arguments) text += argument + ' ';
    return text;
  }

  TemporaryFolder folder_;
  TemporaryFolder scratch_;  // of temporary files
};

}  // namespace beespace::cli_test
