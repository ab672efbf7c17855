// The tube that the figures of a fleet allow; derived in docs/tube.md.
#include "fleet/check_figures.hpp"
#include "fleet/loop_needs.hpp"

#include <beespace/fleet.hpp>
#include <beespace/mover.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace beespace {

namespace {

using fleet::LoopBurden;
using fleet::number;
using fleet::refused;

// More than the roundings of all sums here, relatively.
constexpr double kRoundedUp = 1.0 + 0x1p-40;

// Smaller numbers than those of the motion domain count as its smallest: so none underflows.
double in_domain(double value) {
  return value > 0.0 ? std::max(value, kSmallestInMotion) : 0.0;
}

// How long before a correction begins the position was measured that it is made from. On the ground
// the correction takes effect when the agent's clock says so, and so `clock_error_s` later.
double delay_of(const FleetFigures& figures, const LinkFigures& link) {
  if (figures.loop == LoopPlace::kOnboard) return figures.loop_delay_s;
  return figures.report_age_s + link.command_delay * link.period_s + figures.clock_error_s;
}

// The error of what the loop takes for the deviation. Own corrections are known; what else
// happens in the delay is not. No less than the error of the report by which an agent joins: so it
// joins within its tube.
LoopBurden burden_of(const FleetFigures& figures, const LinkFigures& link) {
  const bool on_board = figures.loop == LoopPlace::kOnboard;
  const double measured_m = on_board ? figures.sensing_error_m : figures.report_error_m;
  const double deviation_mps = in_domain(figures.deviation_mps);
  const double delayed_m = measured_m + deviation_mps * delay_of(figures, link);
  return {.deviation_mps = deviation_mps,
          .error_m = in_domain(std::max(delayed_m, figures.report_error_m)) * kRoundedUp};
}

// Nothing carries it off that does not need as much speed to come back, and something to
// accelerate with.
std::optional<Error> check_strength(const FleetFigures& figures, const LoopBurden& burden) {
  if (burden.deviation_mps == 0.0) return std::nullopt;
  const bool needs_more = burden.error_m > 0.0;
  const bool is_fast_enough = needs_more ? figures.correction_mps > burden.deviation_mps
                                         : figures.correction_mps >= burden.deviation_mps;
  if (!is_fast_enough) {
    return refused("deviation_mps " + number(figures.deviation_mps) + " needs correction_mps of " +
                   (needs_more ? "more than " : "at least ") + number(figures.deviation_mps) +
                   ", " + number(figures.correction_mps) +
                   " is given: the agent would be carried off faster than it can fly back; keep "
                   "more speed for corrections, or fly in less wind");
  }
  if (figures.correction_mps2 > 0.0) return std::nullopt;
  return refused("deviation_mps " + number(figures.deviation_mps) +
                 " needs correction_mps2 above zero, 0 is given: say how much of the acceleration "
                 "is kept for corrections");
}

Error too_weak(const FleetFigures& figures, const LoopBurden& burden) {
  return refused("deviation_mps " + number(figures.deviation_mps) + " with an error of " +
                 number(burden.error_m) + " m, delays included, needs more than correction_mps " +
                 number(figures.correction_mps) + " and correction_mps2 " +
                 number(figures.correction_mps2) +
                 ": the tube would have no bound to speak of; keep more for corrections");
}

double fastest(double period_s, const FleetFigures& figures, const LoopBurden& burden) {
  return period_s > 0.0
             ? fleet::fastest_sampled(period_s, burden, figures.correction_mps,
                                      figures.correction_mps2)
             : fleet::fastest_continuous(burden, figures.correction_mps, figures.correction_mps2);
}

// The loop of the tube: without its clock, and without what is planned.
Result<Tube> loop_of(const FleetFigures& figures, const LinkFigures& link) {
  const LoopBurden burden = burden_of(figures, link);
  if (auto error = check_strength(figures, burden)) return *std::move(error);
  Tube tube{.radius_m = burden.error_m, .error_m = burden.error_m, .planned = {}};
  // What nothing carries off stays where it began.
  if (burden.deviation_mps == 0.0) return tube;
  const double period_s =
      in_domain(figures.loop == LoopPlace::kOnboard ? figures.loop_period_s : link.period_s);
  const double speed = fastest(period_s, figures, burden);
  if (speed == 0.0) return too_weak(figures, burden);
  tube.gain_per_s = period_s > 0.0 ? -std::log1p(-speed) / period_s : speed;
  const fleet::LoopNeeds needs = period_s > 0.0 ? fleet::sampled_needs(speed, period_s, burden)
                                                : fleet::continuous_needs(speed, burden);
  tube.radius_m = needs.radius_m;
  tube.correction_mps = needs.speed_mps;
  tube.correction_mps2 = needs.thrust_mps2;
  if (!(tube.radius_m <= kLargestInMotion)) return too_weak(figures, burden);
  return tube;
}

}  // namespace

Result<Tube> tube_of(const FleetFigures& figures, const LinkFigures& link,
                     const FlightLimits& limits) {
  if (auto error = fleet::check_figures(figures, link, limits)) return *std::move(error);
  Result<Tube> tube = loop_of(figures, link);
  if (!tube) return tube;
  tube->planned = {.max_speed_mps = limits.max_speed_mps - figures.correction_mps,
                   .max_acceleration_mps2 = limits.max_acceleration_mps2 - figures.correction_mps2};
  // An agent whose clock is off is near where it should be at another time.
  tube->clock_m = tube->planned.max_speed_mps * figures.clock_error_s;
  tube->radius_m = (tube->radius_m + tube->clock_m) * kRoundedUp;
  return tube;
}

}  // namespace beespace
