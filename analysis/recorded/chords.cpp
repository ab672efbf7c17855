#include "analysis/recorded/chords.hpp"

#include "analysis/recorded/apart.hpp"
#include "analysis/recorded/worst_moment.hpp"
#include "io/bytes/number_text.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

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

// The chord between two fixes around a time, and which part of it is over then.
struct Chord {
  double sagitta_m =
      0.0;  // of the arc over it: half of it times the tangent of a quarter of the angle
  double part = 0.0;
};

Chord chord_at(const Track& track, double time_s) {
  const auto& fixes = track.fixes;
  const auto behind =
      std::upper_bound(fixes.begin(), fixes.end(), time_s,
                       [](double time, const Fix& fix) { return time < fix.time_s; });
  const auto to = static_cast<std::size_t>(behind - fixes.begin());
  if (to == 0 || to == fixes.size() || fixes[to - 1].time_s == time_s) return {};
  const Way here = way_between(fixes[to - 1], fixes[to]);
  double angle = 0.0;
  if (to >= 2) angle = turned(way_between(fixes[to - 2], fixes[to - 1]), here);
  if (to + 1 < fixes.size()) {
    angle = std::max(angle, turned(here, way_between(fixes[to], fixes[to + 1])));
  }
  const double from_s = fixes[to - 1].time_s;
  return {here.length_m / 2.0 * std::tan(std::min(angle, kMostTurned) / 4.0),
          (time_s - from_s) / (fixes[to].time_s - from_s)};
}

double off_at(const Track& track, double time_s) {
  return chord_at(track, time_s).sagitta_m;
}

// How far the arc is from its chord just then.
double bow_at(const Track& track, double time_s) {
  const Chord chord = chord_at(track, time_s);
  return chord.sagitta_m * 4.0 * chord.part * (1.0 - chord.part);
}

struct Turning {
  const Track& track;
  bool tells_velocities;

  [[nodiscard]] double bow_m(double time_s) const {
    return tells_velocities ? 0.0 : bow_at(track, time_s);
  }
};

void add_fixes_between(const Track& track, const TimeSpan& span, std::vector<double>& times_s) {
  const auto after = [](double time_s, const Fix& fix) { return time_s < fix.time_s; };
  auto fix = std::upper_bound(track.fixes.begin(), track.fixes.end(), span.begins_s, after);
  for (; fix != track.fixes.end() && fix->time_s < span.ends_s; ++fix) {
    times_s.push_back(fix->time_s);
  }
}

// Whether the two may be closer than the threshold all the time from one conflict to the next:
// nowhere do their arcs bow out too little for that. Looked at in instants; what is missed between
// makes a conflict longer, not shorter.
bool may_stay_closer(const Turning& one, const Turning& other, const TimeSpan& between,
                     const ConflictOptions& options) {
  constexpr int kInstants = 8;  // of a piece
  std::vector<double> times_s = {between.begins_s, between.ends_s};
  add_fixes_between(one.track, between, times_s);
  add_fixes_between(other.track, between, times_s);
  std::sort(times_s.begin(), times_s.end());
  const auto is_closer = [&](double time_s) {
    if (!position_at(one.track, time_s, options.max_gap_s) ||
        !position_at(other.track, time_s, options.max_gap_s)) {
      return false;
    }
    const auto apart = apart_at(one.track, other.track, time_s, options.height_unit_m);
    if (!apart) return false;
    const double bows_m = one.bow_m(time_s) + other.bow_m(time_s);
    if (!options.vertical_m) {
      return std::hypot(apart->horizontal_m, apart->vertical_m) - bows_m < options.threshold_m;
    }
    return apart->horizontal_m - bows_m < options.threshold_m &&
           apart->vertical_m < *options.vertical_m * options.height_unit_m;
  };
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    const double step_s = (times_s[i] - times_s[i - 1]) / kInstants;
    for (int k = 1; k < kInstants; ++k) {
      if (!is_closer(times_s[i - 1] + k * step_s)) return false;
    }
    if (i + 1 < times_s.size() && !is_closer(times_s[i])) return false;
  }
  return true;
}

void join_next(Conflict& one, const Conflict& next) {
  one.ends_s = next.ends_s;
  one.certain = one.certain || next.certain;
  if (next.closest_m >= one.closest_m) return;
  one.closest_m = next.closest_m;
  one.closest_s = next.closest_s;
}

}  // namespace

Chords doubt_chords(const io::Recording& recording, const std::vector<Track>& tracks,
                    const ConflictOptions& options, std::vector<Conflict>& conflicts) {
  constexpr double kSeen = 0.01;  // of the threshold
  Chords chords;
  if (!recording.of_aircraft || recording.flies_on) return chords;
  // With a vertical threshold what counts is how close the two are across when they are worst.
  WorstOf worst;
  if (options.vertical_m) {
    worst = worst_of(tracks, options.height_unit_m,
                     {options.threshold_m, *options.vertical_m * options.height_unit_m});
  }
  const auto off_m = [&](PointId bee, double time_s) {
    return tells_velocities(recording.bees[bee]) ? 0.0 : off_at(tracks[bee], time_s);
  };
  const auto both_tell = [&](const Conflict& conflict) {
    return tells_velocities(recording.bees[conflict.first]) &&
           tells_velocities(recording.bees[conflict.second]);
  };
  for (Conflict& conflict : conflicts) {
    if (both_tell(conflict)) continue;
    const auto moment = worst ? worst(conflict) : std::nullopt;
    const double at_s = moment ? moment->time_s : conflict.closest_s;
    const double closest_m = moment ? moment->apart.horizontal_m : conflict.closest_m;
    const double both_m = off_m(conflict.first, at_s) + off_m(conflict.second, at_s);
    if (!(both_m > kSeen * options.threshold_m)) continue;
    chords.most_off_m = std::max(chords.most_off_m, both_m);
    if (closest_m + both_m >= options.threshold_m) conflict.certain = false;
  }
  const auto turning = [&](PointId bee) {
    return Turning{tracks[bee], tells_velocities(recording.bees[bee])};
  };
  std::vector<Conflict> told;  // those of a pair stand together, in the order of time
  for (const Conflict& next : conflicts) {
    const bool same =
        !told.empty() && told.back().first == next.first && told.back().second == next.second;
    if (same && told.back().ends_s <= next.begins_s &&
        may_stay_closer(turning(next.first), turning(next.second),
                        {told.back().ends_s, next.begins_s}, options)) {
      join_next(told.back(), next);
      ++chords.joined;
    } else {
      told.push_back(next);
    }
  }
  conflicts = std::move(told);
  chords.possible = static_cast<std::size_t>(std::count_if(
      conflicts.begin(), conflicts.end(),
      [&](const Conflict& conflict) { return !conflict.certain && !both_tell(conflict); }));
  return chords;
}

std::string chords_text(const Chords& chords) {
  if (!(chords.most_off_m > 0.0)) return {};
  std::string text =
      "where two in conflict turn, straight lines between fixes may be off by up to ";
  text += io::length(chords.most_off_m);
  text += ", and so may how close they come";
  if (chords.possible > 0) {
    text += "; " + io::counted(chords.possible, "conflict is", "conflicts are");
    text += " possible, not certain";
  }
  if (chords.joined > 0) {
    text += "; stretches between which the two may have stayed closer are told as one conflict";
  }
  return text;
}

}  // namespace beespace::analysis
