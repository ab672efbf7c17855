// Bees and what they intend: where each is, and where it wants to go or how it would like to fly.
#pragma once

#include "io/units/unit_taken.hpp"

#include <beespace/advise.hpp>
#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace beespace::io {

// What the table must tell of every bee, beside where it is. Where nothing is needed there may be
// no bee in it, but for the header.
enum class PlanNeed : std::uint8_t { kNothing, kGoals, kGoalsOrPreferred };

// One entry a bee; empty what the table has no columns for.
struct FlightPlans {
  std::vector<std::string> ids;
  bool has_ids = false;  // of an id column; otherwise they are numbers
  std::vector<Point> positions;
  std::vector<Velocity> velocities;
  std::vector<Point> goals;
  std::vector<Velocity> preferred;
  std::vector<double> max_speeds_mps;
  std::vector<double> max_accelerations_mps2;
  std::string format_description;  // "text, comma-separated"
  std::vector<UnitTaken> units;
  std::vector<std::string> notes;  // what else was decided and must be told
};

// What each bee can do, with `otherwise` for what the table does not tell; empty where it tells
// neither of the two.
std::vector<FlightLimits> limits_of(const FlightPlans& plans, const FlightLimits& otherwise);

}  // namespace beespace::io
