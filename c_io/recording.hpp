// What is behind beespace_io_recording.
#pragma once

#include "c_io/facts.hpp"
#include "c_io/texts.hpp"
#include "io/recording/recording.hpp"

#include <beespace_io.h>
#include <beespace/mover.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace beespace::c_io {

// What arrays of numbers hold where nothing is known.
constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();
constexpr Velocity kNoVelocity{kNotKnown, kNotKnown, kNotKnown};

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
  bool since_1970 = false;
  std::int64_t missing = 0;
  // Of each agent the last two fixes, as the input has them: they tell how fast it flies now.
  // Curves of shows are here as a whole.
  beespace::io::Recording last;
  beespace_io_facts facts;
};
