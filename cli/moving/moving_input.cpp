#include "cli/moving/moving_input.hpp"

#include <beespace/bezier_path.hpp>
#include <beespace/geodesy.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace beespace::cli {
namespace {

GeographicPosition geographic(const Point& p) {
  return {p.x, p.y, p.z};
}

Error of_bee(Error error, const io::RecordedBee& bee) {
  error.message.insert(0, "bee '" + bee.id + "': ");
  error.place.record.reset();
  return error;
}

Status to_metres(std::vector<Fix>& fixes) {
  for (Fix& fix : fixes) {
    const auto ecef = to_ecef(geographic(fix.position));
    if (!ecef) return ecef.error();
    fix.position = *ecef;
  }
  return std::monostate{};
}

Result<Track> track_of(const io::RecordedBee& bee, io::Frame frame, double tolerance_m) {
  if (bee.path) return to_track(*bee.path, tolerance_m);
  Track track;
  track.fixes = bee.fixes;
  if (frame == io::Frame::kWgs84) {
    const Status done = to_metres(track.fixes);
    if (!done) return done.error();
  }
  return track;
}

bool is_known(const Velocity& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// The last fix in metres, with the velocity that the input gives it, or that of the last two fixes.
Result<Mover> last_state(const io::RecordedBee& bee, io::Frame frame, bool& estimated) {
  std::vector<Fix> last(bee.fixes.end() - std::min<std::ptrdiff_t>(2, std::ssize(bee.fixes)),
                        bee.fixes.end());
  const bool given = !bee.velocities.empty() && is_known(bee.velocities.back());
  const GeographicPosition place = geographic(last.back().position);
  if (frame == io::Frame::kWgs84) {
    const Status done = to_metres(last);
    if (!done) return done.error();
  }
  estimated = !given;
  if (given) {
    const Velocity& v = bee.velocities.back();
    if (frame == io::Frame::kMetres) return Mover{last.back().position, v};
    const auto ecef = to_ecef_velocity(place, {v.x, v.y, v.z});
    if (!ecef) return ecef.error();
    return Mover{last.back().position, *ecef};
  }
  if (last.size() < 2) {
    return Error{ErrorCode::kMissingColumn,
                 "there is no velocity, and only one fix to tell it from; give velocities (columns "
                 "vx, vy, vz; or ve, vn, vu beside degrees)",
                 {}};
  }
  const Point& p = last[0].position;
  const Point& q = last[1].position;
  const double lasts = last[1].time_s - last[0].time_s;
  return Mover{q, {(q.x - p.x) / lasts, (q.y - p.y) / lasts, (q.z - p.z) / lasts}};
}

}  // namespace

Result<std::vector<Track>> tracks_of(const io::Recording& recording, double tolerance_m) {
  std::vector<Track> tracks;
  tracks.reserve(recording.bees.size());
  for (const io::RecordedBee& bee : recording.bees) {
    auto track = track_of(bee, recording.frame, tolerance_m);
    if (!track) return of_bee(std::move(track).error(), bee);
    tracks.push_back(*std::move(track));
  }
  return tracks;
}

Result<Snapshot> snapshot_of(const io::Recording& recording, double max_age_s) {
  Snapshot snapshot;
  snapshot.time_s = -std::numeric_limits<double>::infinity();
  for (const io::RecordedBee& bee : recording.bees) {
    if (bee.path) {
      return of_bee({ErrorCode::kUnsupportedFormat,
                     "this is a show, which says where drones go; ask 'beespace replay' about it",
                     {}},
                    bee);
    }
    if (!bee.fixes.empty()) {
      snapshot.time_s = std::max(snapshot.time_s, bee.fixes.back().time_s);
    }
  }
  for (std::size_t i = 0; i < recording.bees.size(); ++i) {
    const io::RecordedBee& bee = recording.bees[i];
    if (bee.fixes.empty()) continue;
    const double age = snapshot.time_s - bee.fixes.back().time_s;
    if (age > max_age_s) {
      ++snapshot.stale;
      continue;
    }
    bool estimated = false;
    auto mover = last_state(bee, recording.frame, estimated);
    if (!mover) return of_bee(std::move(mover).error(), bee);
    if (age > 0.0) {
      Point& p = mover->position;
      const Velocity& v = mover->velocity;
      p = {p.x + v.x * age, p.y + v.y * age, p.z + v.z * age};
      ++snapshot.brought_forward;
      snapshot.oldest_s = std::max(snapshot.oldest_s, age);
    }
    snapshot.estimated += estimated ? 1 : 0;
    snapshot.movers.push_back(*mover);
    snapshot.bees.push_back(static_cast<std::uint32_t>(i));
  }
  return snapshot;
}

}  // namespace beespace::cli
