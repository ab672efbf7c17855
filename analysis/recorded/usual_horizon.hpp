// How far ahead is looked where nothing says it.
#pragma once

#include "io/recording/recording.hpp"

namespace beespace::analysis {

// Aircraft fly straight on for minutes as a rule, and others do not.
inline double usual_horizon_s(bool of_aircraft) {
  constexpr double kOfAircraft_s = 300.0;
  constexpr double kOfOthers_s = 60.0;
  return of_aircraft ? kOfAircraft_s : kOfOthers_s;
}

inline double usual_horizon_s(const io::Recording& recording) {
  return usual_horizon_s(recording.of_aircraft);
}

}  // namespace beespace::analysis
