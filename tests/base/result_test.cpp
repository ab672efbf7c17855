#include <beespace/result.hpp>
#include <beespace/version.hpp>

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

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

// What a temporary would take with it does not compile; what is moved out of it does.
template <class R>
concept HasArrow = requires(R&& result) {
  std::forward<R>(result).operator->();
};
template <class R>
concept HasStar = requires(R&& result) {
  *std::forward<R>(result);
};
template <class R>
concept HasValue = requires(R&& result) {
  std::forward<R>(result).value();
};
template <class R>
concept HasError = requires(R&& result) {
  std::forward<R>(result).error();
};

using Text = Result<std::string>;
static_assert(HasArrow<Text&> && HasArrow<const Text&>);
static_assert(!HasArrow<Text> && !HasArrow<const Text>);
static_assert(!HasArrow<Status> && HasArrow<Status&>);
static_assert(HasStar<Text> && HasValue<Text> && HasError<Text>);
static_assert(!HasStar<const Text> && !HasValue<const Text> && !HasError<const Text>);
static_assert(std::is_same_v<decltype(*std::declval<Text>()), std::string>);
static_assert(std::is_same_v<decltype(std::declval<Text>().value()), std::string>);
static_assert(std::is_same_v<decltype(std::declval<Text>().error()), Error>);
static_assert(std::is_same_v<decltype(*std::declval<const Text&>()), const std::string&>);

const Error kNothingThere{ErrorCode::kNoPoints, "nothing there", {}};

TEST(Result, ReadsAnElementOfATemporaryInALoop) {
  const auto ids = [] { return Result<std::vector<int>>(std::vector{1, 2, 3}); };
  int sum = 0;
  for (const int id : *ids()) sum += id;
  EXPECT_EQ(sum, 6);
}

TEST(Result, GivesAFallbackForAnError) {
  const Result<std::string> text = std::string("there");
  EXPECT_EQ(text.value_or("fallback"), "there");
  EXPECT_EQ(Result<std::string>(kNothingThere).value_or("fallback"), "fallback");
  EXPECT_EQ(*Result<std::unique_ptr<int>>(std::make_unique<int>(3)).value_or(nullptr), 3);
}

TEST(Result, GoesOnWithAFunctionThatMayFail) {
  const auto half = [](int number) -> Result<double> {
    if (number % 2 != 0) return Error{ErrorCode::kInvalidArgument, "odd", {}};
    return number / 2.0;
  };
  const Result<int> even = 6;
  EXPECT_EQ(even.and_then(half).value(), 3.0);
  EXPECT_EQ(Result<int>(7).and_then(half).error().message, "odd");
  EXPECT_EQ(Result<int>(kNothingThere).and_then(half).error().message, "nothing there");
}

TEST(Result, ChangesItsValue) {
  Result<int> number = 3;
  EXPECT_EQ(
      number.transform([](int& value) { return std::string(2, static_cast<char>('0' + value)); })
          .value(),
      "33");
  EXPECT_EQ(Result<int>(kNothingThere).transform([](int value) { return value + 1; }).error().code,
            ErrorCode::kNoPoints);
  // Without a copy: the value is moved through.
  auto moved = Result<std::unique_ptr<int>>(std::make_unique<int>(3))
                   .transform([](std::unique_ptr<int> value) { return value; });
  EXPECT_EQ(**moved, 3);
  int seen = 0;
  const Status shown = number.transform([&seen](int value) { seen = value; });
  EXPECT_TRUE(shown.has_value());
  EXPECT_EQ(seen, 3);
}

TEST(Result, ChangesItsError) {
  const auto placed = [](Error error) {
    error.location.source = "bees.csv";
    return error;
  };
  EXPECT_EQ(to_string(Result<int>(kNothingThere).transform_error(placed).error()),
            "bees.csv: nothing there");
  const Result<int> number = 3;
  EXPECT_EQ(number.transform_error(placed).value(), 3);
}

TEST(Result, TriesSomethingElseAfterAnError) {
  const auto other = [](const Error& error) -> Result<int> {
    if (error.code == ErrorCode::kNoPoints) return 0;
    return error;
  };
  EXPECT_EQ(Result<int>(kNothingThere).or_else(other).value(), 0);
  EXPECT_EQ(Result<int>(Error{ErrorCode::kCorrupt, "damaged", {}}).or_else(other).error().message,
            "damaged");
  const Result<int> number = 3;
  EXPECT_EQ(number.or_else(other).value(), 3);
}

// The steps of a Status take nothing, as there is nothing to take.
TEST(Status, GoesOnLikeAResult) {
  const Status success = std::monostate{};
  const Status failure = kNothingThere;
  const auto next = [] { return Result<int>(7); };
  EXPECT_EQ(success.and_then(next).value(), 7);
  EXPECT_EQ(failure.and_then(next).error().code, ErrorCode::kNoPoints);
  EXPECT_EQ(success.transform([] { return 7; }).value(), 7);
  EXPECT_EQ(success.and_then([](std::monostate) { return Result<int>(8); }).value(), 8);
  EXPECT_TRUE(failure.or_else([](const Error&) { return Status(std::monostate{}); }).has_value());
}

TEST(ErrorText, ReadsLikeACompilersMessage) {
  Error error{ErrorCode::kNotANumber, "'abc' is not a number", {}};
  EXPECT_EQ(to_string(error), "'abc' is not a number");
  error.location.record = 1;
  EXPECT_EQ(to_string(error), "point 1: 'abc' is not a number");
  error.location.source = "bees.csv";
  EXPECT_EQ(to_string(error), "bees.csv: point 1: 'abc' is not a number");
  error.location.line = 3;
  error.location.column = 2;
  EXPECT_EQ(to_string(error), "bees.csv:3:2: 'abc' is not a number");
  error.location = {};
  error.location.array = "limits";
  EXPECT_EQ(to_string(error), "limits: 'abc' is not a number");
  error.location.record = 3;
  EXPECT_EQ(to_string(error), "limits[3]: 'abc' is not a number");
}

TEST(ErrorText, EveryCodeHasANameOfItsOwn) {
  std::set<std::string_view> names;
  const auto last = static_cast<int>(ErrorCode::kStopped);
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
