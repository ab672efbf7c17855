#include <beespace/result.hpp>
#include <beespace/version.hpp>

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace beespace {
namespace {

TEST(Result, HoldsAValueOrAnError) {
  const Result<int> value = 7;
  EXPECT_TRUE(value.has_value());
  EXPECT_EQ(*value, 7);
  const Result<int> error = Error{ErrorCode::kNoPoints, "nothing there", {}};
  EXPECT_FALSE(error);
  EXPECT_EQ(error.error().code, ErrorCode::kNoPoints);
}

TEST(Result, MovesItsValueOut) {
  Result<std::string> text = std::string(100, 'x');
  const std::string moved = *std::move(text);
  EXPECT_EQ(moved.size(), 100U);
}

TEST(ErrorText, ReadsLikeACompilersMessage) {
  Error error{ErrorCode::kNotANumber, "'abc' is not a number", {}};
  EXPECT_EQ(to_string(error), "'abc' is not a number");
  error.place.record = 1;
  EXPECT_EQ(to_string(error), "point 1: 'abc' is not a number");
  error.place.source = "bees.csv";
  EXPECT_EQ(to_string(error), "bees.csv: point 1: 'abc' is not a number");
  error.place.line = 3;
  error.place.column = 2;
  EXPECT_EQ(to_string(error), "bees.csv:3:2: 'abc' is not a number");
}

TEST(ErrorText, EveryCodeHasANameOfItsOwn) {
  std::set<std::string_view> names;
  const auto last = static_cast<int>(ErrorCode::kWriteFailed);
  for (int code = 0; code <= last; ++code) {
    names.insert(to_string(static_cast<ErrorCode>(code)));
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(last) + 1);
  EXPECT_EQ(names.count("unknown"), 0U);
}

TEST(Version, OfHeadersAndLibraryAgree) {
  EXPECT_EQ(version(), BEESPACE_VERSION);
}

}  // namespace
}  // namespace beespace
