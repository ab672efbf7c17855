// How far ahead is looked where nothing says it.
#pragma once

#include "io/recording/recording.hpp"

namespace beespace::analysis {

// In seconds: aircraft fly straight on for minutes as a rule, and others do not.
inline double usual_horizon_s(const io::Recording& recording) {
  constexpr double kOfAircraft_s = 300.0;
  constexpr double kOfOthers_s = 60.0;
  return recording.of_aircraft ? kOfAircraft_s : kOfOthers_s;
}

}  // namespace beespace::analysis
