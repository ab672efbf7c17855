#include "motion/track_segments.hpp"

namespace beespace::motion {

TrackSegments cut_at_gaps(std::span<const Track> tracks, double max_gap_s) {
  TrackSegments cut;
  for (std::size_t id = 0; id < tracks.size(); ++id) {
    const Track& track = tracks[id];
    const auto add = [&](std::size_t begin, std::size_t end) {
      TrackSegment segment{static_cast<PointId>(id),
                           track.tolerance_m,
                           std::span(track.fixes).subspan(begin, end - begin),
                           {},
                           true};
      if (!track.heights_m.empty()) {
        segment.heights_m = std::span(track.heights_m).subspan(begin, end - begin);
      }
      cut.segments.push_back(segment);
    };
    std::size_t begin = 0;
    for (std::size_t i = 1; i < track.fixes.size(); ++i) {
      const double before = track.fixes[i - 1].time_s;
      const double after = track.fixes[i].time_s;
      if (after - before <= max_gap_s) continue;
      add(begin, i);
      cut.gaps.push_back({static_cast<PointId>(id), before, after});
      begin = i;
    }
    if (!track.fixes.empty()) add(begin, track.fixes.size());
  }
  return cut;
}

}  // namespace beespace::motion
