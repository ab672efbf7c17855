// What is behind beespace_io_recording.
#pragma once

#include "c_io/facts.hpp"
#include "c_io/texts.hpp"
#include "io/recording/recording.hpp"

#include <beespace_io.h>
#include <beespace/mover.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace beespace::c_io {

// What arrays of numbers hold where nothing is known.
constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();
constexpr Velocity kNoVelocity{kNotKnown, kNotKnown, kNotKnown};

// What is too close: what is given, in metres; of 0 what the recording declares. Errors:
// kInvalidThreshold.
Result<double> threshold_of(const io::Recording& recording, double given_m);

}  // namespace beespace::c_io

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_io_recording {
  beespace::c_io::Texts ids;
  beespace::c_io::Texts labels;
  std::vector<std::int64_t> offsets = {0};
  std::vector<std::int64_t> agent;
  std::vector<double> times_s;
  std::vector<double> xyz;
  std::vector<double> velocities;  // three a fix; none where no fix has one
  std::vector<double> degrees;     // none of metres
  double tolerance_m = 0.0;        // of curves that have become straight lines
  beespace::io::Recording loaded;  // as the input has it: what is said of it is said of this
  beespace_io_facts facts;
};
