#include "analysis/recorded/chords.hpp"

#include "io/bytes/number_text.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <algorithm>
#include <cmath>

namespace beespace::analysis {
namespace {

// More in one interval is no arc but a corner, of which nothing is known between.
constexpr double kMostTurned = 2.1;  // 120 degrees

struct Way {
  double x;
  double y;
  double z;
  double length_m;
};

Way way_between(const Fix& from, const Fix& to) {
  const Point& a = from.position;
  const Point& b = to.position;
  const double x = b.x - a.x;
  const double y = b.y - a.y;
  const double z = b.z - a.z;
  return {x, y, z, std::sqrt(x * x + y * y + z * z)};
}

// The angle between two ways one after the other.
double turned(const Way& before, const Way& after) {
  const double lengths = before.length_m * after.length_m;
  if (!(lengths > 0.0)) return 0.0;
  const double cosine = (before.x * after.x + before.y * after.y + before.z * after.z) / lengths;
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

bool tells_velocities(const io::RecordedBee& bee) {
  return std::any_of(bee.velocities.begin(), bee.velocities.end(), [](const Velocity& velocity) {
    return std::isfinite(velocity.x) && std::isfinite(velocity.y);
  });
}

// The sagitta of the arc over that chord: half of it times the tangent of a quarter of the angle.
double off_at(const Track& track, double time_s) {
  const auto& fixes = track.fixes;
  const auto behind =
      std::upper_bound(fixes.begin(), fixes.end(), time_s,
                       [](double time, const Fix& fix) { return time < fix.time_s; });
  const auto to = static_cast<std::size_t>(behind - fixes.begin());
  if (to == 0 || to == fixes.size() || fixes[to - 1].time_s == time_s) return 0.0;
  const Way here = way_between(fixes[to - 1], fixes[to]);
  double angle = 0.0;
  if (to >= 2) angle = turned(way_between(fixes[to - 2], fixes[to - 1]), here);
  if (to + 1 < fixes.size()) {
    angle = std::max(angle, turned(here, way_between(fixes[to], fixes[to + 1])));
  }
  return here.length_m / 2.0 * std::tan(std::min(angle, kMostTurned) / 4.0);
}

}  // namespace

Chords doubt_chords(const io::Recording& recording, const std::vector<Track>& tracks,
                    const ConflictOptions& options, std::vector<Conflict>& conflicts) {
  constexpr double kSeen = 0.01;  // of the threshold
  Chords chords;
  if (!recording.of_aircraft || recording.flies_on || options.vertical_m) return chords;
  const auto off_m = [&](PointId bee, double time_s) {
    return tells_velocities(recording.bees[bee]) ? 0.0 : off_at(tracks[bee], time_s);
  };
  for (Conflict& conflict : conflicts) {
    const double both_m =
        off_m(conflict.first, conflict.closest_s) + off_m(conflict.second, conflict.closest_s);
    if (!(both_m > kSeen * options.threshold_m) ||
        !(conflict.closest_m + both_m >= options.threshold_m)) {
      continue;
    }
    conflict.certain = false;
    chords.most_off_m = std::max(chords.most_off_m, both_m);
    ++chords.possible;
  }
  return chords;
}

std::string chords_text(const Chords& chords) {
  if (chords.possible == 0) return {};
  return io::counted(chords.possible, "conflict is", "conflicts are") +
         " possible, not certain: where the two turn, straight lines between fixes may be off by "
         "up to " +
         io::length(chords.most_off_m);
}

}  // namespace beespace::analysis
