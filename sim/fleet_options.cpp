#include "sim/fleet_options.hpp"

#include <algorithm>

namespace beespace::sim {

namespace {

// None can state that places are exact: the truth is integrated, and rounded otherwise.
constexpr double kRounding_m = 1e-6;

double seconds_of(const FleetOptions& options, std::int64_t ticks) {
  return static_cast<double>(ticks) * options.link.period_s;
}

}  // namespace

FleetFigures stated_figures(const FleetOptions& options) {
  const AgentErrors& errors = options.errors;
  const double instant_s = options.link.period_s / options.instants;
  FleetFigures figures;
  figures.loop = options.place;
  figures.report_error_m = std::max(errors.report_error_m, kRounding_m);
  figures.report_age_s = seconds_of(options, options.reports.most_latency);
  figures.sensing_error_m = errors.sensing_error_m;
  figures.loop_period_s = options.loop_period * instant_s;
  figures.loop_delay_s = options.loop_delay * instant_s;
  figures.deviation_mps = errors.disturbance.drift_mps + errors.disturbance.gust_mps;
  if (figures.deviation_mps > 0.0) {
    figures.correction_mps2 = options.correction_mps2;
    figures.correction_mps = options.correction_mps;
  }
  if (!(errors.clock.bound_s > 0.0)) return figures;
  figures.clock_error_s = errors.clock.bound_s;
  // A late clock begins its tick after the planner's, and looks at itself once an instant.
  figures.report_age_s += options.link.period_s;
  // Ticks begin within instants: accelerations then change there, by twice the greatest.
  figures.deviation_mps +=
      0.25 * options.limits.max_acceleration_mps2 * instant_s * instant_s / options.link.period_s;
  if (!errors.clock.wanders) return figures;
  // To its loop a clock that wanders is an error of measurement, and its velocities are those of
  // another time.
  figures.sensing_error_m += options.limits.max_speed_mps * errors.clock.bound_s;
  figures.deviation_mps += options.limits.max_acceleration_mps2 * errors.clock.bound_s;
  return figures;
}

Result<Tube> stated_tube(const FleetOptions& options) {
  return tube_of(stated_figures(options), options.link, options.limits);
}

FleetOptions ideal_of(const FleetOptions& options, double wider_m) {
  FleetOptions ideal = options;
  ideal.threshold_m += 2.0 * wider_m;
  if (stated_figures(options).deviation_mps > 0.0) {
    ideal.limits.max_speed_mps -= options.correction_mps;
    ideal.limits.max_acceleration_mps2 -= options.correction_mps2;
  }
  ideal.errors = {};
  ideal.commands = {};
  ideal.reports = {};
  ideal.link.longest_loss = 0;
  ideal.weak_share = 0.0;
  ideal.silent_are_told = true;
  ideal.faults = {};
  return ideal;
}

}  // namespace beespace::sim
