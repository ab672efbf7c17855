#include "tests/closed_loop/flight_plan.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace beespace::closed_loop {

FlightPlan head_on(double gap_m, double speed_mps) {
  FlightPlan plan;
  plan.name = "head on";
  plan.bees = {{{0, 0, 0}, {speed_mps, 0, 0}}, {{gap_m, 0.3L, 0}, {-speed_mps, 0, 0}}};
  plan.steps = 120;
  return plan;
}

FlightPlan swap(std::size_t bees, double spacing_m, double speed_mps) {
  FlightPlan plan;
  plan.name = "swap";
  const long double turn = 2 * std::acos(-1.0L) / static_cast<long double>(bees);
  const long double radius = std::max(static_cast<long double>(spacing_m) / turn, 20.0L);
  for (std::size_t i = 0; i < bees; ++i) {
    const long double angle = turn * static_cast<long double>(i);
    const Vector out = {std::cos(angle), std::sin(angle), 0};
    plan.bees.push_back({out * radius, out * -speed_mps});
  }
  plan.steps = 200;
  return plan;
}

FlightPlan crowd(std::size_t bees, double apart_m, double speed_mps, std::uint64_t seed) {
  FlightPlan plan;
  plan.name = "crowd";
  plan.seed = seed;
  Random random(seed);
  const double side = apart_m * (1.0 + 1.6 * std::cbrt(static_cast<double>(bees)));
  for (int tries = 0; plan.bees.size() < bees && tries < 20'000; ++tries) {
    Start start;
    for (long double& x : start.position) x = random.between(-side / 2, side / 2);
    start.position[2] /= 2;
    for (long double& v : start.velocity) v = random.between(-speed_mps, speed_mps) / 2;
    const bool clear = std::all_of(plan.bees.begin(), plan.bees.end(), [&](const Start& other) {
      return length(start.position - other.position) >= apart_m;
    });
    if (clear) plan.bees.push_back(start);
  }
  plan.steps = 150;
  return plan;
}

namespace {

Faults random_faults(Random& random) {
  Faults faults;
  const auto often = [&random](double most) {
    return random.happens(0.5) ? 0.0 : random.between(0, most);
  };
  faults.lost = often(0.3);
  faults.late = often(0.2);
  faults.repeated = often(0.2);
  faults.missed = often(0.05);
  faults.own_will = often(0.02);
  faults.weak = often(0.02);
  faults.silent = often(0.02);
  faults.garbage = often(0.3);
  faults.position_m = often(0.02);
  faults.velocity_mps = often(0.1);
  return faults;
}

}  // namespace

FlightPlan random_plan(std::uint64_t seed) {
  Random random(seed);
  const double speed = random.between(2, 10);
  FlightPlan plan;
  switch (random.below(4)) {
    case 0:
      plan = head_on(random.between(8, 60), speed);
      break;
    case 1:
      plan = swap(2 + random.below(12), random.between(12, 30), speed);
      break;
    default:
      plan = crowd(2 + random.below(30), random.between(5.5, 25), speed, random.bits());
      break;
  }
  plan.seed = random.bits();
  plan.steps = 60 + static_cast<int>(random.below(140));
  const double rates[] = {5, 10, 12.5, 10, 20, 7.3};
  plan.reports_per_s = rates[random.below(6)];
  const double steps[] = {0.1, 0.1, 0.2, 0.25};
  plan.step_s = steps[random.below(4)];
  plan.max_acceleration_mps2 = random.between(2, 8);
  plan.max_age_s = random.between(0.5, 2);
  plan.uncertainty_m = random.happens(0.5) ? 0.1 : random.between(0.01, 0.5);
  plan.epoch_s = random.happens(0.5) ? 0 : 1.7e9 + static_cast<double>(random.below(1000));
  plan.phase_s = random.happens(0.5) ? 0 : random.between(0, 0.1);
  plan.own_phases = random.happens(0.3);
  plan.shuffled = random.happens(0.5);
  plan.velocities = !random.happens(0.1);
  if (random.happens(0.8)) plan.faults = random_faults(random);
  if (random.happens(0.3)) plan.faults.jitter_s = random.between(0, 0.03);
  // Where all reports come, and one in each step at least, no look needs it.
  const bool regular = plan.reports_per_s * plan.step_s >= 1 && plan.faults.lost == 0 &&
                       plan.faults.late == 0 && plan.faults.silent == 0 &&
                       plan.faults.jitter_s == 0 && !plan.own_phases;
  plan.beacon = !regular || random.happens(0.3);
  return plan;
}

std::string description(const FlightPlan& plan) {
  const Faults& f = plan.faults;
  std::ostringstream out;
  out << plan.name << ", " << plan.bees.size() << " bees, " << plan.steps << " steps of "
      << plan.step_s << " s, X " << plan.threshold_m << " m, uncertainty " << plan.uncertainty_m
      << " m, " << plan.max_acceleration_mps2 << " m/s^2, stale after " << plan.max_age_s << " s, "
      << plan.reports_per_s << " reports/s from " << plan.epoch_s << " s + " << plan.phase_s
      << (plan.own_phases ? ", own phases" : "") << (plan.shuffled ? ", shuffled" : "")
      << (plan.velocities ? "" : ", no velocities") << (plan.beacon ? ", beacon" : "") << "; lost "
      << f.lost << ", late " << f.late << ", repeated " << f.repeated << ", missed " << f.missed
      << ", own will " << f.own_will << ", weak " << f.weak << ", silent " << f.silent
      << ", garbage " << f.garbage << ", jitter " << f.jitter_s << " s, off " << f.position_m
      << " m, " << f.velocity_mps << " m/s";
  return out.str();
}

}  // namespace beespace::closed_loop
