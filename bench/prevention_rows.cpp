#include "bench/prevention_rows.hpp"

#include <utility>

namespace beespace::bench {

namespace {

using sim::FleetOptions;

// In every row a drift, and a place that is measured with an error.
FleetOptions usual() {
  FleetOptions fleet;
  fleet.errors.disturbance.drift_mps = 0.1;
  fleet.errors.sensing_error_m = 0.05;
  fleet.errors.report_error_m = 0.05;
  return fleet;
}

FleetOptions on_ground(double report_error_m) {
  FleetOptions fleet = usual();
  fleet.place = LoopPlace::kGround;
  fleet.errors.report_error_m = report_error_m;
  fleet.errors.report_velocity_error_mps = 0.25;
  return fleet;
}

FleetOptions reports_late(int ticks) {
  FleetOptions fleet = on_ground(0.05);
  fleet.reports.least_latency = fleet.reports.most_latency = ticks;
  return fleet;
}

FleetOptions both_late() {
  FleetOptions fleet = reports_late(1);
  fleet.commands = fleet.reports;
  return fleet;
}

// What is kept of the speed for corrections grows with the wind.
FleetOptions gusts(double gust_mps) {
  FleetOptions fleet = usual();
  fleet.errors.disturbance.gust_mps = gust_mps;
  fleet.correction_mps2 = 1.0;
  fleet.correction_mps = gust_mps > 0.5 ? 1.5 : 1.0;
  return fleet;
}

void lose(FleetOptions& fleet, double share) {
  fleet.link.command_delay = 4;
  fleet.link.longest_loss = 8;
  fleet.commands = {.most_latency = 1, .loss = share, .duplicates = 0.1, .longest_run = 8};
  fleet.reports = fleet.commands;
}

FleetOptions losses(double share) {
  FleetOptions fleet = usual();
  lose(fleet, share);
  return fleet;
}

FleetOptions clocks() {
  FleetOptions fleet = usual();
  fleet.errors.clock = {.bound_s = 0.02, .wanders = true};
  return fleet;
}

template <class Change>
FleetOptions usual_with(const Change& change) {
  FleetOptions fleet = usual();
  change(fleet);
  return fleet;
}

void add_errors(std::vector<PreventionRow>& rows) {
  rows.push_back({"report error 0.05 m, ground", on_ground(0.05), 2.0});
  rows.push_back({"report error 0.25 m, ground", on_ground(0.25), 2.0});
  rows.push_back({"report error 0.5 m, ground", on_ground(0.5), 2.0});
  rows.push_back({"gusts of 0.1 m/s, on board", gusts(0.1), 5.0});
  rows.push_back({"gusts of 0.5 m/s, on board", gusts(0.5), 5.0});
  rows.push_back({"gusts of 1 m/s, on board", gusts(1.0), 5.0});
  rows.push_back({"reports and commands one tick late, ground", both_late(), 5.0});
  rows.push_back({"reports one tick late, ground", reports_late(1), 5.0});
  rows.push_back({"reports two ticks late, ground", reports_late(2), 5.0});
  rows.push_back({"reports five ticks late, ground", reports_late(5), 5.0});
  rows.push_back({"1 % lost, both ways", losses(0.01), 5.0});
  rows.push_back({"10 % lost, both ways", losses(0.1), 5.0});
  rows.push_back({"30 % lost, both ways", losses(0.3), 10.0});
  rows.push_back({"all at once, middle values", middle_values()});
}

void add_agents(std::vector<PreventionRow>& rows) {
  rows.push_back({"10 % with half the acceleration",
                  usual_with([](FleetOptions& fleet) { fleet.weak_share = 0.1; })});
  rows.push_back({"clock error 0.02 s", clocks(), 5.0});
  rows.push_back(
      {"20 % fall silent", usual_with([](FleetOptions& fleet) { fleet.silent_share = 0.2; }), 5.0});
  rows.push_back(
      {"joins, 10 a second", usual_with([](FleetOptions& fleet) { fleet.joins_per_s = 10.0; })});
  rows.push_back({"radii 1 to 4 m", usual_with([](FleetOptions& fleet) {
                    fleet.least_radius_m = 1.0;
                    fleet.most_radius_m = 4.0;
                  })});
  rows.push_back({"ellipsoid, factor 3", usual_with([](FleetOptions& fleet) {
                    fleet.separation = {SeparationShape::kEllipsoid, 3.0};
                  })});
  rows.push_back({"cylinder of 5 m by 3 m", usual_with([](FleetOptions& fleet) {
                    fleet.separation = {SeparationShape::kCylinder, 1.0, 3.0};
                  })});
  rows.push_back({"nothing differs", FleetOptions{}});
}

}  // namespace

sim::FleetOptions middle_values() {
  FleetOptions fleet = gusts(0.5);
  fleet.errors.report_error_m = 0.25;
  fleet.errors.report_velocity_error_mps = 0.25;
  fleet.errors.clock = {.bound_s = 0.02, .wanders = true};
  lose(fleet, 0.1);
  return fleet;
}

std::vector<PreventionRow> prevention_rows() {
  std::vector<PreventionRow> rows;
  add_errors(rows);
  add_agents(rows);
  return rows;
}

}  // namespace beespace::bench
