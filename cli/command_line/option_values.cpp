#include "cli/command_line/option_values.hpp"

#include "io/bytes/number_text.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>

namespace beespace::cli {

Error usage_error(std::string_view command, std::string message) {
  return {ErrorCode::kInvalidArgument,
          std::move(message) + " (see 'beespace " + std::string(command) + " --help')",
          {}};
}

namespace {

// "--step 'abc' is not ...".
Error wrong(const Typed& typed, const std::string& what) {
  return usage_error(typed.command, std::string(typed.option) + " '" + typed.text + "' " + what);
}

struct Domain {
  double least_m;
  double most_m;
  const char* words;
};

Result<double> read_threshold_in(const std::string& text, const Domain& domain) {
  const auto stated = io::parse_stated(text, io::Quantity::kLength);
  if (!stated) {
    return Error{ErrorCode::kInvalidThreshold,
                 "the threshold '" + text +
                     "' is not a length; give metres, or a number with its unit, for example "
                     "--threshold 100, 5NM, 0.3km or 1000ft (units: " +
                     io::list_units(io::Quantity::kLength) + ")",
                 {}};
  }
  const double value = stated->metric;
  if (value >= domain.least_m && value <= domain.most_m) return value;
  // The ends of the domain matter to those alone who are beyond them.
  const bool finite = std::isfinite(value);
  std::string remedy = "give a finite distance above zero, in metres, for example --threshold 100";
  if (finite && value > 0.0) remedy = std::string("give one from ") + domain.words;
  const bool has_unit = finite && std::isalpha(static_cast<unsigned char>(text.back())) != 0;
  return Error{ErrorCode::kInvalidThreshold,
               "the threshold is " + text + (has_unit ? "; " : " m; ") + remedy,
               {}};
}

// Of a value that has been read in metres: as it was typed.
Result<io::StatedLength> as_stated(const Typed& typed, const Result<double>& read) {
  if (!read) return read.error();
  return *io::parse_stated(typed.text, io::Quantity::kLength);
}

Result<double> in_motion_domain(const Typed& typed, double value) {
  const double size = std::abs(value);
  if (value == 0.0 || (size >= kSmallestInMotion && size <= kLargestInMotion)) return value;
  return wrong(typed, "cannot be computed with; use a size from 7.9e-31 to 1.3e+30");
}

Result<double> read_within(const Typed& typed, const char* unit, double least, double most) {
  const auto value = io::parse_amount(typed.text, unit);
  if (value && *value >= least && *value <= most) return *value;
  return wrong(typed, std::string("is not a number of ") + unit + " from " +
                          io::grouped(least, least > 0.0 ? 6 : 0) + " to " + io::grouped(most, 0));
}

Result<std::uint64_t> read_whole(const Typed& typed, std::uint64_t least, std::uint64_t most,
                                 const std::string& limits) {
  const auto count = io::parse_whole(typed.text);
  if (count && *count >= least && *count <= most) return *count;
  return wrong(typed, "is not a whole number from " + limits);
}

}  // namespace

Result<double> read_threshold(const Typed& typed) {
  return read_threshold_in(
      typed.text, {kSmallestCoordinate_m, kLargestCoordinate_m, "3.9e-121 m to 2.6e+120 m"});
}

Result<double> read_threshold_in_motion(const Typed& typed) {
  return read_threshold_in(typed.text,
                           {kSmallestInMotion, kLargestInMotion, "7.9e-31 m to 1.3e+30 m"});
}

Result<io::StatedLength> read_stated_threshold(const Typed& typed) {
  return as_stated(typed, read_threshold(typed));
}

Result<io::StatedLength> read_stated_threshold_in_motion(const Typed& typed) {
  return as_stated(typed, read_threshold_in_motion(typed));
}

Result<io::StatedLength> read_vertical(const Typed& typed) {
  return as_stated(typed, amount("metres", kAboveZero)(typed));
}

Result<io::StatedLength> read_vertical_in_motion(const Typed& typed) {
  auto stated = read_vertical(typed);
  if (!stated) return stated;
  // It may be compared as typed, or in metres.
  return in_motion_domain(typed, stated->metric)
      .and_then([&](double) { return in_motion_domain(typed, stated->value); })
      .transform([&](double) { return *stated; });
}

ReadNumber amount(const char* unit, Least least) {
  return [unit, least](const Typed& typed) -> Result<double> {
    const auto value = io::parse_amount(typed.text, unit);
    const bool enough = value && (least.itself ? *value >= least.value : *value > least.value);
    if (enough && std::isfinite(*value)) return *value;
    return wrong(typed, std::string("is not a number of ") + unit +
                            (least.itself ? " from " : " above ") + io::exact(least.value) +
                            (least.itself ? " on" : ""));
  };
}

ReadNumber amount_in_motion(const char* unit, Least least) {
  return [read = amount(unit, least)](const Typed& typed) {
    return read(typed).and_then([&](double value) { return in_motion_domain(typed, value); });
  };
}

Result<double> read_speed(const Typed& typed) {
  return read_within(typed, "metres per second", 1e-6, 1e6);
}

Result<double> read_acceleration(const Typed& typed) {
  if (typed.text == "none") return std::numeric_limits<double>::infinity();
  return read_within(typed, "metres per second squared", 1e-6, 1e9);
}

Result<double> read_span(const Typed& typed) {
  return read_within(typed, "seconds", 1e-6, 1e6);
}

ReadNumber length_from(double least_m) {
  return [least_m](const Typed& typed) { return read_within(typed, "metres", least_m, 1e9); };
}

Result<double> read_max_gap(const Typed& typed) {
  if (typed.text == "never") return std::numeric_limits<double>::infinity();
  const auto seconds = io::parse_number(typed.text);
  if (seconds && *seconds > 0.0 && std::isfinite(*seconds)) return *seconds;
  return wrong(typed, "is not a number of seconds above 0, nor 'never'");
}

ReadCount whole(std::uint64_t least, std::uint64_t most) {
  return [least, most](const Typed& typed) {
    return read_whole(typed, least, most, io::grouped(least) + " to " + io::grouped(most));
  };
}

ReadCount whole_without_commas(std::uint64_t least, std::uint64_t most) {
  return [least, most](const Typed& typed) {
    return read_whole(typed, least, most, std::to_string(least) + " to " + std::to_string(most));
  };
}

Result<unsigned> read_threads(const Typed& typed) {
  constexpr unsigned kMost = std::numeric_limits<unsigned>::max();
  return read_whole(typed, 0, kMost, "0 (all) to " + io::grouped(std::uint64_t{kMost}))
      .transform([](std::uint64_t count) { return static_cast<unsigned>(count); });
}

Result<std::uint64_t> read_max_results(const Typed& typed) {
  return whole_without_commas(1, std::numeric_limits<std::uint64_t>::max())(typed);
}

Result<std::uint64_t> read_memory(const Typed& typed) {
  constexpr struct {
    std::string_view unit;
    std::uint64_t bytes;
  } kUnits[] = {{"MB", 1'000'000},
                {"GB", 1'000'000'000},
                {"TB", 1'000'000'000'000},
                {"MiB", std::uint64_t{1} << 20U},
                {"GiB", std::uint64_t{1} << 30U},
                {"TiB", std::uint64_t{1} << 40U}};
  double number = 0.0;
  const char* const end = typed.text.data() + typed.text.size();
  const auto read = std::from_chars(typed.text.data(), end, number);
  std::string_view rest(read.ptr, static_cast<std::size_t>(end - read.ptr));
  while (rest.starts_with(' ')) rest.remove_prefix(1);
  for (const auto& [unit, bytes] : kUnits) {
    const double size = number * static_cast<double>(bytes);
    if (read.ec == std::errc() && rest == unit && size >= 1.0 && size < 0x1p60) {
      return static_cast<std::uint64_t>(size);
    }
  }
  return wrong(typed,
               "is no size of memory; give a number and its unit: MB, GB, TB, MiB, GiB or TiB");
}

Result<std::uint64_t> read_seed(const Typed& typed) {
  return whole_without_commas(0, std::numeric_limits<std::uint64_t>::max())(typed);
}

}  // namespace beespace::cli
