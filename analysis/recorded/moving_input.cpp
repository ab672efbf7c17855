#include "analysis/recorded/moving_input.hpp"

#include "io/bytes/number_text.hpp"

#include <beespace/bezier_path.hpp>
#include <beespace/geodesy.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace beespace::analysis {
namespace {

GeographicPosition geographic(const Point& p) {
  return {p.x, p.y, p.z};
}

Error of_bee(Error error, const io::RecordedBee& bee) {
  error.message.insert(0, "bee '" + bee.id + "': ");
  error.place.record.reset();
  return error;
}

// A fix of the input in metres, with its height where that is kept apart.
struct Placed {
  Fix fix;
  double height_m = 0.0;
};

Result<Placed> placed(const Fix& fix, io::Frame frame, Geometry geometry,
                      const StatedHeight& stated) {
  const bool as_stated = geometry == Geometry::kGroundAndStatedHeight;
  const double height = as_stated ? stated.value : fix.position.z;
  if (frame == io::Frame::kMetres) {
    if (geometry == Geometry::kSpace) return Placed{fix, 0.0};
    return Placed{{fix.time_s, {fix.position.x, fix.position.y, 0.0}}, height};
  }
  GeographicPosition place = geographic(fix.position);
  // Checked as it is given; what lies below it at height 0 is as good.
  auto ecef = to_ecef(place);
  if (!ecef) return ecef.error();
  if (geometry == Geometry::kSpace) return Placed{{fix.time_s, *ecef}, 0.0};
  place.height_m = 0.0;
  return Placed{{fix.time_s, *to_ecef(place)}, height};
}

// What is computed may be too small for the motion domain; nobody sees the difference to 0.
double told(double value) {
  return std::abs(value) < kSmallestInMotion ? 0.0 : value;
}

// How fast somebody climbs, in the unit of the heights that are compared.
double climb_of(const Velocity& v, Geometry geometry, const StatedHeight& stated) {
  if (geometry == Geometry::kSpace) return 0.0;
  return geometry == Geometry::kGroundAndHeight ? v.z : told(io::from_metric(v.z, stated.unit));
}

// The height of a fix as the input states it.
StatedHeight stated_height(const io::Recording& recording, const io::RecordedBee& bee,
                           std::size_t fix) {
  if (fix >= bee.stated_heights.size()) return {};
  return {bee.stated_heights[fix], recording.height_unit};
}

Result<Track> track_of(const io::Recording& recording, const io::RecordedBee& bee,
                       Geometry geometry, double tolerance_m) {
  if (bee.path) return to_track(*bee.path, tolerance_m);
  Track track;
  track.fixes.reserve(bee.fixes.size());
  for (std::size_t i = 0; i < bee.fixes.size(); ++i) {
    const auto at =
        placed(bee.fixes[i], recording.frame, geometry, stated_height(recording, bee, i));
    if (!at) return at.error();
    track.fixes.push_back(at->fix);
    if (heights_apart(geometry)) track.heights_m.push_back(at->height_m);
  }
  return track;
}

bool is_known(const Velocity& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Where somebody was last heard of, and how fast it went.
struct LastState {
  Mover mover;
  double height_m = 0.0;
  double climb_mps = 0.0;
  bool estimated = false;  // the velocity is that of the last two fixes
};

Result<LastState> given_state(const Fix& fix, const Velocity& v, io::Frame frame, Geometry geometry,
                              const StatedHeight& stated) {
  const auto at = placed(fix, frame, geometry, stated);
  if (!at) return at.error();
  const bool apart = heights_apart(geometry);
  const double climb = climb_of(v, geometry, stated);
  if (frame == io::Frame::kMetres) {
    return LastState{{at->fix.position, {v.x, v.y, apart ? 0.0 : v.z}}, at->height_m, climb};
  }
  const auto ecef = to_ecef_velocity(geographic(fix.position), {v.x, v.y, apart ? 0.0 : v.z});
  if (!ecef) return ecef.error();
  return LastState{{at->fix.position, *ecef}, at->height_m, climb};
}

Result<LastState> last_state(const io::Recording& recording, const io::RecordedBee& bee,
                             Geometry geometry, double max_age_s) {
  const io::Frame frame = recording.frame;
  const Fix& last = bee.fixes.back();
  const std::size_t index = bee.fixes.size() - 1;
  if (!bee.velocities.empty() && is_known(bee.velocities.back())) {
    return given_state(last, bee.velocities.back(), frame, geometry,
                       stated_height(recording, bee, index));
  }
  if (bee.fixes.size() < 2) {
    return Error{ErrorCode::kMissingColumn,
                 "there is no velocity, and only one fix to tell it from; give velocities (columns "
                 "vx, vy, vz; or ve, vn, vu beside degrees)",
                 {}};
  }
  const double lasts = last.time_s - bee.fixes[bee.fixes.size() - 2].time_s;
  if (lasts > max_age_s) {
    return Error{ErrorCode::kMissingColumn,
                 "there is no velocity, and its last two fixes are " + io::exact(lasts) +
                     " s apart, too far to tell it from; give velocities (columns vx, vy, vz; or "
                     "ve, vn, vu beside degrees), or raise --max-age",
                 {}};
  }
  const auto before =
      placed(bee.fixes[index - 1], frame, geometry, stated_height(recording, bee, index - 1));
  if (!before) return before.error();
  const auto now = placed(last, frame, geometry, stated_height(recording, bee, index));
  if (!now) return now.error();
  const Point& p = before->fix.position;
  const Point& q = now->fix.position;
  return LastState{
      {q, {told((q.x - p.x) / lasts), told((q.y - p.y) / lasts), told((q.z - p.z) / lasts)}},
      now->height_m,
      told((now->height_m - before->height_m) / lasts),
      true};
}

void bring_forward(LastState& state, double by_s) {
  Point& p = state.mover.position;
  const Velocity& v = state.mover.velocity;
  p = {told(p.x + v.x * by_s), told(p.y + v.y * by_s), told(p.z + v.z * by_s)};
  state.height_m = told(state.height_m + state.climb_mps * by_s);
}

// Of the last fix of all. Error: where the input says nothing of the present.
Result<double> last_time(const io::Recording& recording) {
  double time_s = -std::numeric_limits<double>::infinity();
  for (const io::RecordedBee& bee : recording.bees) {
    if (bee.path) {
      return of_bee({ErrorCode::kUnsupportedFormat,
                     "this is a show, which says where drones go; ask 'beespace replay' about it",
                     {}},
                    bee);
    }
    if (!bee.fixes.empty()) time_s = std::max(time_s, bee.fixes.back().time_s);
  }
  return time_s;
}

}  // namespace

Geometry geometry_for(io::Frame frame, io::Unit height_unit,
                      const std::optional<io::StatedLength>& vertical) {
  if (compares_as_stated(vertical, height_unit)) return Geometry::kGroundAndStatedHeight;
  return vertical && frame == io::Frame::kWgs84 ? Geometry::kGroundAndHeight : Geometry::kSpace;
}

Geometry geometry_for(const io::Recording& recording,
                      const std::optional<io::StatedLength>& vertical) {
  return geometry_for(recording.frame, recording.height_unit, vertical);
}

std::optional<double> vertical_in(Geometry geometry,
                                  const std::optional<io::StatedLength>& vertical) {
  if (!vertical) return std::nullopt;
  return geometry == Geometry::kGroundAndStatedHeight ? vertical->value : vertical->metric;
}

double height_unit_m(Geometry geometry, io::Unit height_unit) {
  return geometry == Geometry::kGroundAndStatedHeight ? io::in_metric(1.0, height_unit) : 1.0;
}

MoversView Snapshot::view() const {
  if (heights_m.empty()) return movers;
  const MoversView positions(movers);
  return {positions.positions(), positions.velocities(), heights_m, climbs_mps};
}

Snapshot Snapshot::present() const {
  Snapshot all;
  all.time_s = time_s;
  all.movers = movers;
  all.heights_m = heights_m;
  all.climbs_mps = climbs_mps;
  all.bees = bees;
  for (const Placed& placed : unmoving) {
    all.movers.push_back({placed.position, {}});
    all.bees.push_back(placed.bee);
    if (heights_m.empty()) continue;
    all.heights_m.push_back(placed.height_m);
    all.climbs_mps.push_back(0.0);
  }
  return all;
}

Result<std::vector<Track>> tracks_of(const io::Recording& recording, Geometry geometry,
                                     double tolerance_m) {
  std::vector<Track> tracks;
  tracks.reserve(recording.bees.size());
  for (const io::RecordedBee& bee : recording.bees) {
    auto track = track_of(recording, bee, geometry, tolerance_m);
    if (!track) return of_bee(std::move(track).error(), bee);
    tracks.push_back(*std::move(track));
  }
  return tracks;
}

Result<InMetres> in_metres(const Point& position, const std::optional<Velocity>& velocity,
                           io::Frame frame, Geometry geometry, const StatedHeight& stated) {
  const Fix fix{0.0, position};
  if (velocity && is_known(*velocity)) {
    const auto state = given_state(fix, *velocity, frame, geometry, stated);
    if (!state) return state.error();
    return InMetres{state->mover.position, state->mover.velocity, state->height_m,
                    state->climb_mps};
  }
  const auto at = placed(fix, frame, geometry, stated);
  if (!at) return at.error();
  return InMetres{at->fix.position, std::nullopt, at->height_m, 0.0};
}

Result<InMetres> in_metres(const io::Recording& recording, std::size_t bee, std::size_t fix,
                           Geometry geometry) {
  const io::RecordedBee& of = recording.bees[bee];
  std::optional<Velocity> velocity;
  if (of.velocities.size() > fix) velocity = of.velocities[fix];
  return in_metres(of.fixes[fix].position, velocity, recording.frame, geometry,
                   stated_height(recording, of, fix));
}

Result<Snapshot> snapshot_of(const io::Recording& recording, Geometry geometry, double max_age_s,
                             Wanted wanted) {
  const auto now = last_time(recording);
  if (!now) return now.error();
  Snapshot snapshot;
  snapshot.time_s = *now;
  std::optional<Error> no_velocity;
  for (std::size_t i = 0; i < recording.bees.size(); ++i) {
    const io::RecordedBee& bee = recording.bees[i];
    if (bee.fixes.empty()) continue;
    const double age = *now - bee.fixes.back().time_s;
    if (age > max_age_s) {
      ++snapshot.stale;
      continue;
    }
    auto state = wanted == Wanted::kPlaces && age == 0.0
                     ? given_state(bee.fixes.back(), Velocity{}, recording.frame, geometry,
                                   stated_height(recording, bee, bee.fixes.size() - 1))
                     : last_state(recording, bee, geometry, max_age_s);
    if (!state && state.error().code == ErrorCode::kMissingColumn) {
      const std::size_t last = bee.fixes.size() - 1;
      const auto at =
          placed(bee.fixes[last], recording.frame, geometry, stated_height(recording, bee, last));
      if (!at) return of_bee(at.error(), bee);
      snapshot.unmoving.push_back({static_cast<std::uint32_t>(i), at->fix.position, at->height_m});
      no_velocity = of_bee(std::move(state).error(), bee);
      continue;
    }
    if (!state) return of_bee(std::move(state).error(), bee);
    if (age > 0.0) {
      bring_forward(*state, age);
      ++snapshot.brought_forward;
      snapshot.oldest_s = std::max(snapshot.oldest_s, age);
    }
    if (state->estimated) ++snapshot.estimated;
    snapshot.movers.push_back(state->mover);
    snapshot.bees.push_back(static_cast<std::uint32_t>(i));
    if (geometry == Geometry::kSpace) continue;
    snapshot.heights_m.push_back(state->height_m);
    snapshot.climbs_mps.push_back(state->climb_mps);
  }
  if (snapshot.movers.empty() && no_velocity) return *std::move(no_velocity);
  return snapshot;
}

}  // namespace beespace::analysis
