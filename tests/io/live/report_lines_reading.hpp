// Short functions to state the expected reports of live input.
#pragma once

#include "io/live/report_lines.hpp"
#include "tests/io/points/loading.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

using Taken = Result<std::optional<ReportLine>>;

// The report, or an empty one (and a failed test) when there is none.
inline ReportLine report_of(const Taken& taken) {
  EXPECT_TRUE(taken.has_value()) << (taken ? "" : to_string(taken.error()));
  if (!taken) return {};
  EXPECT_TRUE(taken->has_value());
  return taken->value_or(ReportLine());
}

// Whether there is a report; an error fails the test.
inline bool says_something(const Taken& taken) {
  EXPECT_TRUE(taken.has_value()) << (taken ? "" : to_string(taken.error()));
  return taken && taken->has_value();
}

inline void expect_line_error(const Taken& taken, const Expected& expected) {
  ASSERT_FALSE(taken.has_value());
  const std::string text = to_string(taken.error());
  EXPECT_EQ(to_string(taken.error().code), to_string(expected.code)) << text;
  EXPECT_EQ(text.substr(0, expected.place.size() + 2), std::string(expected.place) + ": ") << text;
  EXPECT_NE(text.find(expected.message), std::string::npos) << text;
}

inline bool lines_note(const ReportLines& lines, std::string_view part) {
  for (const std::string& note : lines.notes()) {
    if (note.find(part) != std::string::npos) return true;
  }
  return false;
}

}  // namespace beespace::io
