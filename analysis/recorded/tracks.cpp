#include "analysis/recorded/tracks.hpp"

#include <beespace/bezier_path.hpp>

#include <cstddef>
#include <optional>
#include <utility>

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

}  // namespace

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
