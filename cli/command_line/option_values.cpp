#include "cli/command_line/option_values.hpp"

#include "io/bytes/number_text.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

namespace beespace::cli {

Error usage_error(std::string_view command, std::string message) {
  return {ErrorCode::kInvalidArgument,
          std::move(message) + " (see 'beespace " + std::string(command) + " --help')",
          {}};
}

namespace {

struct Domain {
  double least_m;
  double most_m;
  const char* words;
};

Result<double> read_threshold_in(const std::string& text, const Domain& domain) {
  const auto stated = parse_stated(text, io::Quantity::kLength);
  if (!stated) {
    return Error{ErrorCode::kInvalidThreshold,
                 "the threshold '" + text +
                     "' is not a length; give metres, or a number with its unit, for example "
                     "--threshold 100, 5NM, 0.3km or 1000ft (units: " +
                     io::list_units(io::Quantity::kLength) + ")",
                 {}};
  }
  const std::optional<double> value = stated->metric;
  if (*value >= domain.least_m && *value <= domain.most_m) return *value;
  // The ends of the domain matter to those alone who are beyond them.
  const bool finite = std::isfinite(*value);
  std::string remedy = "give a finite distance above zero, in metres, for example --threshold 100";
  if (finite && *value > 0.0) remedy = std::string("give one from ") + domain.words;
  const bool has_unit = finite && std::isalpha(static_cast<unsigned char>(text.back())) != 0;
  return Error{ErrorCode::kInvalidThreshold,
               "the threshold is " + text + (has_unit ? "; " : " m; ") + remedy,
               {}};
}

}  // namespace

Result<double> read_threshold(const std::string& text) {
  return read_threshold_in(
      text, {kSmallestCoordinate_m, kLargestCoordinate_m, "3.9e-121 m to 2.6e+120 m"});
}

Result<double> read_threshold_in_motion(const std::string& text) {
  return read_threshold_in(text, {kSmallestInMotion, kLargestInMotion, "7.9e-31 m to 1.3e+30 m"});
}

Result<unsigned> read_threads(std::string_view command, const std::string& text) {
  constexpr unsigned kMost = std::numeric_limits<unsigned>::max();
  const auto count = io::parse_whole(text);
  if (count && *count <= kMost) return static_cast<unsigned>(*count);
  return usage_error(command, "--threads '" + text + "' is not a whole number from 0 (all) to " +
                                  io::grouped(std::uint64_t{kMost}));
}

Result<std::uint64_t> read_max_results(std::string_view command, const std::string& text) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  if (text.empty()) return kMost;
  const auto count = io::parse_whole(text);
  if (count && *count >= 1) return *count;
  return usage_error(command, "--max-results '" + text + "' is not a whole number from 1 to " +
                                  std::to_string(kMost));
}

Result<std::optional<io::StatedLength>> read_vertical(std::string_view command,
                                                      const std::string& text) {
  const auto metres = read_optional_amount(command, "--vertical", text, "metres", {0.0, false});
  if (!metres) return metres.error();
  if (!*metres) return std::optional<io::StatedLength>();
  return parse_stated(text, io::Quantity::kLength);
}

Result<double> read_amount(std::string_view command, const std::string& option,
                           const std::string& text, const char* unit, Least least) {
  const auto value = io::parse_amount(text, unit);
  const bool enough = value && (least.itself ? *value >= least.value : *value > least.value);
  if (enough && std::isfinite(*value)) return *value;
  return usage_error(command, option + " '" + text + "' is not a number of " + unit +
                                  (least.itself ? " from " : " above ") + io::exact(least.value) +
                                  (least.itself ? " on" : ""));
}

Result<std::optional<double>> read_optional_amount(std::string_view command,
                                                   const std::string& option,
                                                   const std::string& text, const char* unit,
                                                   Least least) {
  if (text.empty()) return std::optional<double>();
  const auto value = read_amount(command, option, text, unit, least);
  if (!value) return value.error();
  return std::optional<double>(*value);
}

Status in_motion_domain(std::string_view command, const std::string& option,
                        const std::string& text, double value) {
  const double size = std::abs(value);
  if (value == 0.0 || (size >= kSmallestInMotion && size <= kLargestInMotion)) {
    return std::monostate{};
  }
  return usage_error(command, option + " '" + text +
                                  "' cannot be computed with; use a size from 7.9e-31 to 1.3e+30");
}

}  // namespace beespace::cli
