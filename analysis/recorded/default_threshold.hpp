// What is too close where the command does not say: what the input declares, or what is usual.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::analysis {

// Drones of shows fly some metres apart: a default for aircraft would find nothing but conflicts.
inline constexpr double kDefaultShowThreshold_m = 2.0;

struct DefaultThreshold {
  double metres;
  // ", as the input declares"; empty where it is `otherwise_m`.
  std::string_view words;
};

DefaultThreshold default_threshold(const io::Recording& recording, double otherwise_m);

// Of air traffic nothing else is usual than what its rules say, and these are of several kinds:
// what to type where nothing was. Nothing for what is no air traffic, as far as is known.
// `knows_usual`: the command has --separation.
std::optional<Error> threshold_needed(const io::Recording& recording, bool knows_usual);

}  // namespace beespace::analysis
