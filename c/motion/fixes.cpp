#include "c/motion/fixes.hpp"

#include "c/door/door.hpp"
#include "c/door/number_column.hpp"
#include "c/door/points.hpp"
#include "c/door/structs.hpp"

#include <beespace/mover.hpp>
#include <beespace/points_view.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

namespace beespace::c {

namespace {

constexpr std::size_t kFixesBetweenStops = 4096;

// What is too small for exact comparison counts as 0 (see mover.hpp).
double flushed(double value) {
  return std::abs(value) < kSmallestInMotion ? 0.0 : value;
}

Error error_at(ErrorCode code, std::string message, const char* place, std::size_t record) {
  Error error{code, std::move(message), {}};
  error.location.array = place;
  error.location.record = record;
  return error;
}

std::optional<Error> check_value(double value, const char* place, std::size_t record) {
  if (std::abs(value) <= kLargestInMotion) return std::nullopt;
  if (!std::isfinite(value)) {
    return error_at(ErrorCode::kNotFinite, "this is no finite number; leave the fix out", place,
                    record);
  }
  return error_at(ErrorCode::kOutsideDomain, "this is beyond 1.3e+30 in magnitude; check its unit",
                  place, record);
}

Result<Fix> fix_of(double time_s, const Point& position, std::size_t record) {
  for (const double value : {position.x, position.y, position.z}) {
    if (auto error = check_value(value, "positions", record)) return *std::move(error);
  }
  if (auto error = check_value(time_s, "times", record)) return *std::move(error);
  return Fix{flushed(time_s), {flushed(position.x), flushed(position.y), flushed(position.z)}};
}

// Of a recording in which heights are apart: the height of a fix.
Status append_height(Track& track, double height, std::size_t record) {
  if (auto error = check_value(height, "heights", record)) return *std::move(error);
  track.heights_m.push_back(flushed(height));
  return std::monostate{};
}

Status append(Track& track, const Fix& fix, std::size_t record) {
  if (!track.fixes.empty() && !(track.fixes.back().time_s < fix.time_s)) {
    const bool same = track.fixes.back().time_s == fix.time_s;
    return error_at(ErrorCode::kTimeOrder,
                    same ? "the agent has two fixes at this time; leave one of them out"
                         : "this time is before that of the agent's fix before it; sort the fixes "
                           "by time",
                    "times", record);
  }
  track.fixes.push_back(fix);
  return std::monostate{};
}

// The tracks in the order of their agents' ids.
Agents ordered(Agents agents) {
  std::vector<std::size_t> order(agents.ids.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return agents.ids[a] < agents.ids[b]; });
  Agents sorted;
  sorted.heights_apart = agents.heights_apart;
  sorted.height_unit_m = agents.height_unit_m;
  for (const std::size_t i : order) {
    sorted.ids.push_back(agents.ids[i]);
    sorted.tracks.push_back(std::move(agents.tracks[i]));
  }
  return sorted;
}

}  // namespace

Result<FixColumns> columns_of(const beespace_fixes* fixes, std::size_t size) {
  const Result<beespace_fixes> given = read_struct(fixes, "fixes");
  if (!given) return given.error();
  FixColumns columns{{given->agents, given->agents_stride},
                     {given->times_s, given->times_stride},
                     {},
                     {},
                     given->height_unit_m};
  if (given->heights_m != nullptr)
    columns.heights_m.emplace(given->heights_m, given->heights_stride);
  if (given->climbs_mps != nullptr) {
    columns.climbs_mps.emplace(given->climbs_mps, given->climbs_stride);
  }
  if (size == 0) return columns;
  if (const char* const problem = columns.agents.problem(size)) return invalid(problem, "agents");
  if (const char* const problem = columns.times_s.problem(size)) return invalid(problem, "times");
  for (const auto& [column, name] :
       {std::pair(columns.heights_m, "heights"), std::pair(columns.climbs_mps, "climbs")}) {
    const char* const problem = column ? column->problem(size) : nullptr;
    if (problem != nullptr) return invalid(problem, name);
  }
  return columns;
}

Result<Agents> agents_of(const beespace_fixes* fixes, const beespace_points* positions,
                         const std::stop_token& stop) {
  const Result<PointsView> places = view_of(positions, "positions");
  if (!places) return places.error();
  const std::size_t size = places->size();
  const Result<FixColumns> columns = columns_of(fixes, size);
  if (!columns) return columns.error();
  if (columns->climbs_mps) {
    return invalid("climb rates are for live swarms: the heights of a recording say how it climbs",
                   "climbs");
  }
  const bool heights_apart = columns->heights_m.has_value();
  Agents agents;
  if (columns->height_unit_m != 0.0) {
    if (!heights_apart && size != 0) {
      return invalid("there is a unit of heights, but no heights", "heights");
    }
    if (!(columns->height_unit_m >= kSmallestInMotion &&
          columns->height_unit_m <= kLargestInMotion)) {
      return invalid("the unit of heights is a length in metres, above zero: 0.3048 for feet",
                     "heights");
    }
    agents.height_unit_m = columns->height_unit_m;
  }
  agents.heights_apart = heights_apart && size != 0;
  std::unordered_map<std::int64_t, std::size_t> known;
  for (std::size_t row = 0; row < size; ++row) {
    if (row % kFixesBetweenStops == 0 && stop.stop_requested()) {
      return Error{ErrorCode::kStopped, "a stop was requested", {}};
    }
    const Result<Fix> fix = fix_of(columns->times_s[row], (*places)[row], row);
    if (!fix) return fix.error();
    const auto [at, is_new] = known.try_emplace(columns->agents[row], agents.ids.size());
    if (is_new) {
      agents.ids.push_back(at->first);
      agents.tracks.emplace_back();
    }
    Track& track = agents.tracks[at->second];
    Status status = append(track, *fix, row);
    if (status && heights_apart) status = append_height(track, (*columns->heights_m)[row], row);
    if (!status) return std::move(status).error();
  }
  return ordered(std::move(agents));
}

std::vector<Gap> gaps_of(const Agents& agents, double max_gap_s) {
  std::vector<Gap> gaps;
  for (std::size_t id = 0; id < agents.tracks.size(); ++id) {
    const std::vector<Fix>& fixes = agents.tracks[id].fixes;
    for (std::size_t i = 1; i < fixes.size(); ++i) {
      const double before = fixes[i - 1].time_s;
      const double after = fixes[i].time_s;
      if (!(after - before <= max_gap_s)) {
        gaps.push_back({static_cast<PointId>(id), before, after});
      }
    }
  }
  return gaps;
}

}  // namespace beespace::c
