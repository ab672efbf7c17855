// The bees of a closed loop, how they are reported, and what goes wrong.
#pragma once

#include "tests/closed_loop/flown.hpp"
#include "tests/closed_loop/random.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace beespace::closed_loop {

struct Start {
  Vector position{};
  Vector velocity{};
};

// Each is a probability: of a report, of a bee and a step, or of a step.
struct Faults {
  double lost = 0;      // of a report
  double late = 0;      // of a report: by some steps
  double repeated = 0;  // of a report
  double missed = 0;  // of a bee and a step: it does not receive its advice, and flies straight on
  double own_will = 0;    // of a bee and a step: for some steps it flies as it likes
  double weak = 0;        // of a bee and a step: for some steps it has half its acceleration
  double silent = 0;      // of a bee and a step: for some steps no report comes
  double garbage = 0;     // of a step: a line that is none
  double jitter_s = 0;    // reports are made earlier or later by up to so much
  double position_m = 0;  // what reports say is off by up to so much
  double velocity_mps = 0;
};

struct FlightPlan {
  std::string name;
  std::vector<Start> bees;
  int steps = 100;
  double step_s = 0.1;
  double threshold_m = 5;
  double uncertainty_m = 0.1;
  double max_speed_mps = 10;
  double max_acceleration_mps2 = 5;  // infinite: a bee flies with its new velocity at once
  double max_age_s = 5;              // a bee that is silent for longer may be anywhere
  double epoch_s = 0;                // what clocks show as the flight begins
  double reports_per_s = 10;
  double phase_s = 0;       // of the first report of all
  bool own_phases = false;  // each bee has another
  bool shuffled = false;    // within a step
  bool velocities = true;   // in reports
  // A bee far from all others, whose reports never fail, halfway in each step: so the look of a
  // step is due by the clock of the reports, whatever else is lost.
  bool beacon = false;
  Faults faults;
  std::uint64_t seed = 1;
};

FlightPlan head_on(double gap_m, double speed_mps);
// Around a circle, each to the opposite side.
FlightPlan swap(std::size_t bees, double spacing_m, double speed_mps);
// In a box, each on its way to somewhere; none closer than `apart_m` to another.
FlightPlan crowd(std::size_t bees, double apart_m, double speed_mps, std::uint64_t seed);
// Any of them, with any rates, clocks and faults.
FlightPlan random_plan(std::uint64_t seed);
// In one line.
std::string description(const FlightPlan& plan);

}  // namespace beespace::closed_loop
