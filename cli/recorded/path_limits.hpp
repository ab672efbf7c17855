// Limits of flights along their paths: what they are called, and where they come from.
#pragma once

#include "io/recording/show_facts.hpp"

#include <beespace/verify_path.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace beespace::cli {

struct PathLimitWords {
  PathLimit limit;
  const char* finding;  // "horizontal": as a row says it, and a member in JSON
  const char* noun;     // "horizontal speed"
  const char* unit;
  const char* option;
};
inline constexpr std::array<PathLimitWords, kPathLimits> kPathLimitWords = {{
    {PathLimit::kSpeed, "speed", "speed", "m/s", "--max-speed"},
    {PathLimit::kHorizontalSpeed, "horizontal", "horizontal speed", "m/s", "--max-horizontal"},
    {PathLimit::kClimb, "climb", "climb", "m/s", "--max-climb"},
    {PathLimit::kDescent, "descent", "descent", "m/s", "--max-descent"},
    {PathLimit::kAcceleration, "acceleration", "acceleration", "m/s^2", "--max-acceleration"},
    {PathLimit::kHeight, "height", "height", "m", "--max-height"},
}};

const PathLimitWords& words_of(PathLimit limit);

// Down is no climb, and up no descent.
double shown_value(const PathPeak& peak, PathLimit limit);

// What options say, in the order of PathLimit.
using AskedLimits = std::array<std::optional<double>, kPathLimits>;

struct SettledLimits {
  PathLimits limits = {};
  std::array<bool, kPathLimits> declared{};  // which come from the show
};

// What options do not say, a show may.
SettledLimits settle_limits(const AskedLimits& asked, const std::optional<io::ShowFacts>& show);

// "horizontal speed 8 m/s, climb 2.5 m/s (as the show declares)".
std::string limits_text(const SettledLimits& settled);

}  // namespace beespace::cli
