#include "analysis/recorded/tracks.hpp"

#include <beespace/bezier_path.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

Result<Track> track_of(const io::Recording& recording, const io::RecordedBee& bee,
                       Geometry geometry, double tolerance_m) {
  if (bee.path) return to_track(*bee.path, tolerance_m);
  Track track;
  track.fixes.reserve(bee.fixes.size());
  for (std::size_t i = 0; i < bee.fixes.size(); ++i) {
    const Fix& fix = bee.fixes[i];
    const auto at = in_metres(fix.position, std::nullopt, recording.frame, geometry,
                              stated_height(recording, bee, i));
    if (!at) return at.error();
    track.fixes.push_back({fix.time_s, at->position});
    if (heights_apart(geometry)) track.heights_m.push_back(at->height_m);
  }
  return track;
}

Point between(const Point& from, const Point& to, double share) {
  return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
          from.z + share * (to.z - from.z)};
}

// Straight on between two fixes, in steps that are a little shorter than `step_s`.
void divide(Track& track, double step_s) {
  constexpr double kMostSteps = 1e6;
  std::vector<Fix> fixes;
  for (std::size_t i = 0; i < track.fixes.size(); ++i) {
    const Fix& to = track.fixes[i];
    const Fix& from = track.fixes[i > 0 ? i - 1 : 0];
    const double lasts_s = to.time_s - from.time_s;
    const double steps = std::min(std::floor(lasts_s / step_s) + 2.0, kMostSteps);
    for (double k = 1.0; lasts_s > step_s && k < steps; ++k) {
      const double share = k / steps;
      const double time_s = from.time_s + share * lasts_s;
      if (!(time_s > fixes.back().time_s) || !(time_s < to.time_s)) continue;
      fixes.push_back({time_s, between(from.position, to.position, share)});
    }
    fixes.push_back(to);
  }
  track.fixes = std::move(fixes);
}

}  // namespace

void keep_paths_whole(const io::Recording& recording, double max_gap_s,
                      std::vector<Track>& tracks) {
  if (!(max_gap_s > 0.0)) return;
  for (std::size_t bee = 0; bee < tracks.size(); ++bee) {
    if (recording.bees[bee].path) divide(tracks[bee], max_gap_s);
  }
}

Error of_bee(Error error, const io::RecordedBee& bee) {
  error.message.insert(0, "bee '" + bee.id + "': ");
  error.location.record.reset();
  return error;
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

}  // namespace beespace::analysis
