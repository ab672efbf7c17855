#include "c/live/reports.hpp"

#include "c/door/agents.hpp"
#include "c/door/door.hpp"
#include "c/door/points.hpp"

#include <beespace/mover.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace beespace::c {

namespace {

std::optional<Error> check_columns(const FixColumns& columns, std::size_t size,
                                   bool heights_apart) {
  if (heights_apart && !columns.heights_m && size != 0) {
    return invalid("this is NULL, but the swarm has heights apart from positions", "heights");
  }
  if (!heights_apart && (columns.heights_m || columns.climbs_mps)) {
    return invalid(
        "the swarm has no heights apart from positions: make it with "
        "BEESPACE_SWARM_HEIGHTS_APART, or give these as z",
        "heights");
  }
  if (columns.height_unit_m != 0.0) {
    return invalid("the unit of heights of a swarm belongs to its options", "reports");
  }
  return std::nullopt;
}

bool all_in_motion(std::initializer_list<double> values) {
  return std::all_of(values.begin(), values.end(),
                     [](double value) { return std::abs(value) <= kLargestInMotion; });
}

}  // namespace

PositionReport Reports::operator[](std::size_t row) const {
  PositionReport report;
  report.id = agent_id_of(columns.agents[row]);
  report.time_s = columns.times_s[row];
  report.position = positions[row];
  if (velocities) {
    const Point v = (*velocities)[row];
    const bool unknown = std::isnan(v.x) && std::isnan(v.y) && (planar || std::isnan(v.z));
    if (!unknown) report.velocity = Velocity{v.x, v.y, v.z};
  }
  if (columns.heights_m) report.height_m = (*columns.heights_m)[row];
  if (columns.climbs_mps) report.climb_mps = (*columns.climbs_mps)[row];
  return report;
}

Result<Reports> reports_of(const beespace_fixes* reports, const beespace_points* positions,
                           const beespace_points* velocities, bool heights_apart) {
  const Result<PointsView> places = view_of(positions, "positions");
  if (!places) return places.error();
  const Result<FixColumns> columns = columns_of(reports, places->size());
  if (!columns) return columns.error();
  if (auto error = check_columns(*columns, places->size(), heights_apart)) return *error;
  Reports all{*columns, *places, std::nullopt, false};
  if (velocities == nullptr) return all;
  const Result<PointsView> speeds = view_of(velocities, "velocities");
  if (!speeds) return speeds.error();
  if (speeds->size() != places->size()) {
    return invalid("there is not one velocity for each position", "velocities");
  }
  all.velocities = *speeds;
  all.planar = velocities->z == nullptr;
  return all;
}

Error at_report(Error error, const PositionReport& report, std::size_t row) {
  error.location.record = row;
  error.location.array = "agents";
  if (error.code != ErrorCode::kNotFinite && error.code != ErrorCode::kOutsideDomain) return error;
  const Point& at = report.position;
  const Velocity v = report.velocity.value_or(Velocity{});
  if (!all_in_motion({at.x, at.y, at.z})) {
    error.location.array = "positions";
  } else if (!all_in_motion({v.x, v.y, v.z})) {
    error.location.array = "velocities";
  } else if (!all_in_motion({report.height_m})) {
    error.location.array = "heights";
  } else if (!all_in_motion({report.climb_mps})) {
    error.location.array = "climbs";
  } else {
    error.location.array = "times";
  }
  return error;
}

}  // namespace beespace::c
