#include "cli/generate/generate_values.hpp"

#include "cli/command_line/option_values.hpp"
#include "io/bytes/number_text.hpp"
#include "io/units/stated_length.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

// Within these every coordinate is surely one that a search takes.
constexpr double kSmallestSize_m = 1e-6;
constexpr double kLargestSize_m = 1e15;
constexpr const char* kSizes = " (0.000001 to 1e15)";

// Metres per second and seconds: no way that is flown at these is longer than the largest size.
constexpr double kSmallestSpeed = 1e-6;
constexpr double kLargestSpeed = 1e6;
constexpr double kShortest_s = 1e-6;
constexpr double kLongest_s = 1e9;

std::optional<double> number_within(std::string_view text, double least, double most) {
  const auto value = io::parse_number(text);
  const bool good = value && *value >= least && *value <= most;
  return good ? value : std::nullopt;
}

// The same, of metres, perhaps in another unit.
std::optional<double> metres_within(std::string_view text, double least, double most) {
  const auto value = io::parse_amount(text, "metres");
  const bool good = value && *value >= least && *value <= most;
  return good ? value : std::nullopt;
}

// The hyphen between two numbers, which is none of "1e-3" or "-5"; the end where there is none.
std::size_t find_hyphen(std::string_view text) {
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] == '-' && text[i - 1] != 'e' && text[i - 1] != 'E') return i;
  }
  return text.size();
}

// "--sigma 'abc' is not ...".
Error wrong(const Typed& typed, const std::string& what) {
  return generate_error(std::string(typed.option) + " '" + typed.text + "' " + what);
}

}  // namespace

Error generate_error(std::string message) {
  return usage_error("generate", std::move(message));
}

Result<double> read_length(const Typed& typed) {
  if (const auto value = metres_within(typed.text, kSmallestSize_m, kLargestSize_m)) return *value;
  return wrong(typed, std::string("is not a length in metres") + kSizes);
}

Result<double> read_distance(const Typed& typed) {
  if (const auto value = io::parse_number(typed.text); value && *value == 0.0) return 0.0;
  if (const auto value = metres_within(typed.text, kSmallestSize_m, kLargestSize_m)) return *value;
  return wrong(typed, "is not a distance in metres (0, or 0.000001 to 1e15)");
}

Result<Point> read_size(const Typed& typed) {
  const Error error = wrong(
      typed, std::string("is not a length in metres") + kSizes + ", nor three as in 3300x2300x480");
  std::vector<double> sides;
  std::string_view rest = typed.text;
  while (true) {
    const std::size_t end = std::min(rest.find('x'), rest.size());
    const auto side = metres_within(rest.substr(0, end), kSmallestSize_m, kLargestSize_m);
    if (!side) return error;
    sides.push_back(*side);
    if (end == rest.size()) break;
    rest.remove_prefix(end + 1);
  }
  if (sides.size() == 1) return Point{sides[0], sides[0], sides[0]};
  if (sides.size() != 3) return error;
  return Point{sides[0], sides[1], sides[2]};
}

Result<scenes::Speeds> read_speeds(const Typed& typed) {
  const std::string_view whole = typed.text;
  const std::size_t hyphen = find_hyphen(whole);
  const std::string_view high = hyphen == whole.size() ? whole : whole.substr(hyphen + 1);
  const auto slowest = number_within(whole.substr(0, hyphen), kSmallestSpeed, kLargestSpeed);
  const auto fastest = number_within(high, kSmallestSpeed, kLargestSpeed);
  if (slowest && fastest && *slowest <= *fastest) return scenes::Speeds{*slowest, *fastest};
  return wrong(typed,
               "is not a speed in metres per second (0.000001 to 1e6), nor two as in "
               "5-20, the slowest first");
}

Result<double> read_seconds(const Typed& typed) {
  if (const auto value = number_within(typed.text, kShortest_s, kLongest_s)) return *value;
  return wrong(typed, "is not a number of seconds (0.000001 to 1e9)");
}

}  // namespace beespace::cli
