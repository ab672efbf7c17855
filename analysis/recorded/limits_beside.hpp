// The limits of a drone show beside speeds and height: accelerations in one direction, and heights
// below which none moves sideways.
#pragma once

#include "analysis/recorded/flights.hpp"
#include "analysis/recorded/low_navigation.hpp"
#include "io/recording/recording.hpp"
#include "io/recording/show_facts.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>
#include <beespace/verify_path.hpp>

#include <optional>
#include <string>
#include <vector>

namespace beespace::analysis {

struct BeePeak {
  PointId bee = 0;
  PathPeak peak;
};

struct BeeExcess {
  PointId bee = 0;
  PathExcess excess;
};

// An acceleration that was looked at in its direction.
struct AccelerationCheck {
  io::ShowAcceleration declared;
  std::optional<BeePeak> greatest;  // nothing where no bee flies
  std::vector<BeeExcess> excesses;  // by bee, then time
};

struct LimitsBeside {
  std::vector<AccelerationCheck> accelerations;
  std::vector<NavigationCheck> navigation;
  // Names of those of which it is not known whether they are kept: accelerations in a direction
  // that is not known, which the greatest one in any direction exceeds; those of which nothing is
  // looked at. Those of `navigation` that are not kept are among them.
  std::vector<std::string> not_known;
};

// Of `recording`, a show, whose flights these are. Errors: those of check_path(), with the bee's
// id.
Result<LimitsBeside> check_limits_beside(const io::Recording& recording,
                                         const std::vector<Flight>& flights);

// "horizontal acceleration", "acceleration".
const char* acceleration_noun(io::ShowAcceleration::Direction direction);

// The limits that a recording declares and that a question may skip.
std::vector<std::string> skippable_limits(const io::Recording& recording);

}  // namespace beespace::analysis
