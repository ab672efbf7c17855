#include "analysis/recorded/last_snapshot.hpp"

#include "analysis/recorded/last_climb.hpp"
#include "analysis/recorded/tracks.hpp"
#include "io/bytes/number_text.hpp"
#include "io/recording/moment_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

// Where a bee was last heard of, and how fast it went.
struct LastState {
  Mover mover;
  double height_m = 0.0;
  double climb_mps = 0.0;
  // What was not of the last fix but of fixes before.
  bool estimated = false;  // the velocity; where heights go in steps, that over ground
  std::optional<ClimbFrom> climb_from = {};  // the climb alone
};

// Of a velocity that is known.
Result<LastState> given_state(const Fix& fix, const Velocity& v, io::Frame frame, Geometry geometry,
                              const StatedHeight& stated) {
  const auto at = in_metres(fix.position, v, frame, geometry, stated);
  if (!at) return at.error();
  return LastState{{at->position, *at->velocity}, at->height_m, at->climb_mps};
}

// Nothing where the last two fixes tell a velocity.
std::optional<Error> no_two_fixes(const io::RecordedBee& bee, double max_age_s) {
  if (bee.fixes.size() < 2) {
    return Error{ErrorCode::kMissingColumn,
                 "there is no velocity, and only one fix to tell it from; give velocities (columns "
                 "vx, vy, vz; or ve, vn, vu beside degrees)",
                 {}};
  }
  const double lasts = bee.fixes.back().time_s - bee.fixes[bee.fixes.size() - 2].time_s;
  if (lasts <= max_age_s) return std::nullopt;
  return Error{ErrorCode::kMissingColumn,
               "there is no velocity, and its last two fixes are " + io::exact(lasts) +
                   " s apart, too far to tell it from; give velocities (columns vx, vy, vz; or "
                   "ve, vn, vu beside degrees), or raise --max-age",
               {}};
}

// The velocity of the last two fixes. With `level` the height of the last one is taken for both.
Result<LastState> two_fix_state(const io::Recording& recording, const io::RecordedBee& bee,
                                Geometry geometry, bool level) {
  const std::size_t index = bee.fixes.size() - 1;
  const double lasts = bee.fixes[index].time_s - bee.fixes[index - 1].time_s;
  Point from = bee.fixes[index - 1].position;
  if (level) from.z = bee.fixes[index].position.z;
  const auto before = in_metres(from, std::nullopt, recording.frame, geometry,
                                stated_height(recording, bee, level ? index : index - 1));
  if (!before) return before.error();
  const auto now = in_metres(bee.fixes[index].position, std::nullopt, recording.frame, geometry,
                             stated_height(recording, bee, index));
  if (!now) return now.error();
  const Point& p = before->position;
  const Point& q = now->position;
  return LastState{
      {q,
       {flushed((q.x - p.x) / lasts), flushed((q.y - p.y) / lasts), flushed((q.z - p.z) / lasts)}},
      now->height_m,
      flushed((now->height_m - before->height_m) / lasts),
      true};
}

// Whether its last velocity is how it flies from there, however long ago that was.
bool flies_on(const io::Recording& recording, const io::RecordedBee& bee) {
  return recording.flies_on && !bee.velocities.empty() && is_known(bee.velocities.back());
}

bool known_over_ground(const Velocity& velocity) {
  return std::isfinite(velocity.x) && std::isfinite(velocity.y);
}

// Where heights go in steps: two fixes do not tell how fast it climbs.
Result<LastState> state_in_steps(const io::Recording& recording, const io::RecordedBee& bee,
                                 const Velocity& told, Geometry geometry, double max_age_s) {
  const auto climb = last_climb(bee, max_age_s);
  if (!climb) {
    return Error{ErrorCode::kMissingColumn,
                 "there is no climb rate, and not " + io::exact(kShortestClimb_s) +
                     " s of heights, which go in steps, to tell it from; give climb rates (a "
                     "column vertical_rate)",
                 {}};
  }
  Velocity known{0.0, 0.0, flushed(climb->up_mps)};
  if (known_over_ground(told)) known = {told.x, told.y, known.z};
  auto state = given_state(bee.fixes.back(), known, recording.frame, geometry,
                           stated_height(recording, bee, bee.fixes.size() - 1));
  if (!state) return state;
  if (climb->from != ClimbFrom::kRecord) state->climb_from = climb->from;
  if (known_over_ground(told)) return state;
  const auto level = two_fix_state(recording, bee, geometry, true);
  if (!level) return level.error();
  Velocity& velocity = state->mover.velocity;
  const Velocity& along = level->mover.velocity;
  velocity = {flushed(velocity.x + along.x), flushed(velocity.y + along.y),
              flushed(velocity.z + along.z)};
  state->estimated = true;
  return state;
}

Result<LastState> last_state(const io::Recording& recording, const io::RecordedBee& bee,
                             Geometry geometry, double max_age_s) {
  const std::size_t index = bee.fixes.size() - 1;
  const Fix& last = bee.fixes[index];
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const Velocity told =
      bee.velocities.empty() ? Velocity{kUnknown, kUnknown, kUnknown} : bee.velocities.back();
  const auto given = [&](const Velocity& v) {
    return given_state(last, v, recording.frame, geometry, stated_height(recording, bee, index));
  };
  if (is_known(told)) return given(told);
  if (auto error = no_two_fixes(bee, max_age_s)) return *std::move(error);
  if (heights_in_steps(recording, bee)) {
    return state_in_steps(recording, bee, told, geometry, max_age_s);
  }
  if (!known_over_ground(told)) return two_fix_state(recording, bee, geometry, false);
  const Fix& before = bee.fixes[index - 1];
  const double up = (last.position.z - before.position.z) / (last.time_s - before.time_s);
  auto state = given({told.x, told.y, flushed(up)});
  if (state) state->climb_from = ClimbFrom::kTwoFixes;
  return state;
}

void bring_forward(LastState& state, double by_s) {
  Point& p = state.mover.position;
  const Velocity& v = state.mover.velocity;
  p = {flushed(p.x + v.x * by_s), flushed(p.y + v.y * by_s), flushed(p.z + v.z * by_s)};
  state.height_m = flushed(state.height_m + state.climb_mps * by_s);
}

// Where it is after so long at its track and height: round the Earth, where a straight line would
// lead away from it. As BlueSky flies, on a sphere, along a rhumb line.
Fix moved_on(const Fix& fix, const Velocity& velocity, double by_s) {
  constexpr double kEarth_m = 6'371'000.0;
  constexpr double kDegree = 0.017453292519943295;
  constexpr double kMostNorth = 89.9 * kDegree;  // beyond it a track says little
  constexpr double kLevel = 1e-9;                // of latitude: along a parallel
  const double from = fix.position.y * kDegree;
  const double to = std::clamp(from + velocity.y * by_s / kEarth_m, -kMostNorth, kMostNorth);
  const auto stretched = [](double latitude) { return std::asinh(std::tan(latitude)); };
  const double stretch = std::abs(to - from) > kLevel
                             ? (stretched(to) - stretched(from)) / (to - from)
                             : 1.0 / std::cos(from);
  const double east = fix.position.x + velocity.x * by_s / kEarth_m * stretch / kDegree;
  return {fix.time_s + by_s,
          {std::remainder(east, 360.0), to / kDegree, fix.position.z + velocity.z * by_s}};
}

// Of one that flies on as it was created, at any time.
Result<LastState> state_flown_on(const io::Recording& recording, const io::RecordedBee& bee,
                                 Geometry geometry, double by_s) {
  const std::size_t index = bee.fixes.size() - 1;
  const Velocity& velocity = bee.velocities[index];
  const StatedHeight stated = stated_height(recording, bee, index);
  auto state = given_state(moved_on(bee.fixes[index], velocity, by_s), velocity, recording.frame,
                           geometry, stated);
  // Of one in metres the place has it, climbed.
  if (state && geometry == Geometry::kGroundAndStatedHeight && stated.unit != io::Unit::kMetre) {
    state->height_m = flushed(state->height_m + state->climb_mps * by_s);
  }
  return state;
}

// Whether the input has a place for them, known or not: then no column was forgotten.
bool has_velocities(const io::Recording& recording) {
  return std::any_of(recording.bees.begin(), recording.bees.end(),
                     [](const io::RecordedBee& bee) { return !bee.velocities.empty(); });
}

// When the input was written, where it says so, as that is what its reader sees as now: the last
// positions of all may be old, too. Otherwise, and where one comes later, that of the last fix of
// all. Error: where the input says nothing of the present.
Result<double> present_time(const io::Recording& recording) {
  double time_s = recording.written_s.value_or(-std::numeric_limits<double>::infinity());
  for (const io::RecordedBee& bee : recording.bees) {
    if (bee.path || recording.show) {
      return of_bee({ErrorCode::kUnsupportedFormat,
                     "this is a show, which says where drones go; ask 'beespace replay' about it",
                     {}},
                    bee);
    }
    if (!bee.fixes.empty()) time_s = std::max(time_s, bee.fixes.back().time_s);
  }
  return time_s;
}

// Whether it has landed, as it said no longer ago than that. Records without a place that came
// later are of who may have taken off again.
bool is_on_ground(const io::RecordedBee& bee, double now_s, double max_age_s) {
  if (!bee.on_ground_heard_s || now_s - *bee.on_ground_heard_s > max_age_s) return false;
  return bee.unplaced_until_s.value_or(*bee.on_ground_heard_s) <= *bee.on_ground_heard_s;
}

std::optional<double> passed_over_since(const io::Recording& recording, double now_s) {
  if (!recording.flies_on) return std::nullopt;
  std::vector<double> created_s;
  for (const io::RecordedBee& bee : recording.bees) {
    if (!bee.fixes.empty() && bee.fixes.front().time_s < now_s) {
      created_s.push_back(bee.fixes.front().time_s);
    }
  }
  if (created_s.size() < 2) return std::nullopt;
  std::nth_element(created_s.begin(), created_s.begin() + 1, created_s.end());
  return created_s[1];
}

}  // namespace

bool flies_round_the_earth(const io::Recording& recording, const io::RecordedBee& bee) {
  return recording.frame == io::Frame::kWgs84 && flies_on(recording, bee);
}

Result<FlownOn> flown_on(const io::Recording& recording, const io::RecordedBee& bee,
                         Geometry geometry, double by_s) {
  const auto state = state_flown_on(recording, bee, geometry, by_s);
  if (!state) return state.error();
  return FlownOn{state->mover.position, state->height_m};
}

MoversView Snapshot::view() const {
  if (heights_m.empty()) return movers;
  const MoversView positions(movers);
  return {positions.positions(), positions.velocities(), heights_m, climbs_mps};
}

Snapshot Snapshot::present() const {
  Snapshot all;
  all.time_s = time_s;
  all.with_heights = with_heights;
  all.movers = movers;
  all.heights_m = heights_m;
  all.climbs_mps = climbs_mps;
  all.bees = bees;
  for (const Placed& placed : unmoving) {
    all.movers.push_back({placed.position, {}});
    all.bees.push_back(placed.bee);
    if (!with_heights) continue;
    all.heights_m.push_back(placed.height_m);
    all.climbs_mps.push_back(0.0);
  }
  return all;
}

Result<Snapshot> snapshot_of(const io::Recording& recording, Geometry geometry, double max_age_s,
                             Wanted wanted) {
  const auto now = present_time(recording);
  if (!now) return now.error();
  Snapshot snapshot;
  snapshot.time_s = *now;
  snapshot.with_heights = geometry != Geometry::kSpace;
  snapshot.passed_over_since_s = passed_over_since(recording, *now);
  std::optional<Error> no_velocity;
  for (std::size_t i = 0; i < recording.bees.size(); ++i) {
    const io::RecordedBee& bee = recording.bees[i];
    if (bee.fixes.empty()) continue;
    if (is_on_ground(bee, *now, max_age_s)) {
      ++snapshot.on_ground;
      continue;
    }
    const double age = *now - bee.fixes.back().time_s;
    if (age > max_age_s && !flies_on(recording, bee)) {
      ++snapshot.stale;
      continue;
    }
    const bool flown = age > 0.0 && flies_round_the_earth(recording, bee);
    auto state = flown ? state_flown_on(recording, bee, geometry, age)
                 : wanted == Wanted::kPlaces && age == 0.0
                     ? given_state(bee.fixes.back(), Velocity{}, recording.frame, geometry,
                                   stated_height(recording, bee, bee.fixes.size() - 1))
                     : last_state(recording, bee, geometry, max_age_s);
    if (!state && state.error().code == ErrorCode::kMissingColumn) {
      const std::size_t last = bee.fixes.size() - 1;
      const auto at = in_metres(bee.fixes[last].position, std::nullopt, recording.frame, geometry,
                                stated_height(recording, bee, last));
      if (!at) return of_bee(at.error(), bee);
      snapshot.unmoving.push_back({static_cast<std::uint32_t>(i), at->position, at->height_m, age});
      if (!no_two_fixes(bee, max_age_s)) {
        ++snapshot.climbless;
      } else if (!bee.velocities.empty() && known_over_ground(bee.velocities[last])) {
        ++snapshot.level_only;
      }
      no_velocity = of_bee(std::move(state).error(), bee);
      continue;
    }
    if (!state) return of_bee(std::move(state).error(), bee);
    if (age > 0.0) {
      if (!flown) bring_forward(*state, age);
      ++snapshot.brought_forward;
      snapshot.oldest_s = std::max(snapshot.oldest_s, age);
    }
    if (state->estimated) ++snapshot.estimated;
    if (state->climb_from) ++snapshot.climbs.of(*state->climb_from);
    snapshot.movers.push_back(state->mover);
    snapshot.bees.push_back(static_cast<std::uint32_t>(i));
    if (geometry == Geometry::kSpace) continue;
    snapshot.heights_m.push_back(state->height_m);
    snapshot.climbs_mps.push_back(state->climb_mps);
  }
  const bool now_will_do = wanted != Wanted::kMotion && has_velocities(recording);
  if (snapshot.movers.empty() && no_velocity && !now_will_do) return *std::move(no_velocity);
  return snapshot;
}

std::string passed_over_text(const Snapshot& snapshot, const io::Recording& recording) {
  if (!snapshot.passed_over_since_s) return {};
  return "from " + io::moment_text(*snapshot.passed_over_since_s, recording) + " to " +
         io::moment_text(snapshot.time_s, recording) + " not looked at";
}

}  // namespace beespace::analysis
