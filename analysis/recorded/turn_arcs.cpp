#include "analysis/recorded/turn_arcs.hpp"

#include "analysis/recorded/apart.hpp"
#include "analysis/recorded/jump_spans.hpp"
#include "analysis/recorded/tracks.hpp"
#include "analysis/recorded/worst_moment.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace beespace::analysis {
namespace {

// What an arc turns between two fixes at most, by those beside it: more is a corner, of which
// nothing is known between. By velocities at both ends it may be half a circle, and a little more.
constexpr double kMostByFixes = 2.1;  // 120 degrees
constexpr double kMostByVelocities = 3.5;
// Velocities are of an arc where their speed suffices to fly it.
constexpr double kFasterThanTold = 1.2;
// Of the threshold: what is less is not seen.
constexpr double kLittle = 0.01;

struct Way3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  [[nodiscard]] double length() const { return std::sqrt(x * x + y * y + z * z); }
  [[nodiscard]] Way3 times(double factor) const { return {x * factor, y * factor, z * factor}; }
  [[nodiscard]] Way3 plus(const Way3& other) const {
    return {x + other.x, y + other.y, z + other.z};
  }
  [[nodiscard]] double dot(const Way3& other) const {
    return x * other.x + y * other.y + z * other.z;
  }
};

Way3 between(const Point& from, const Point& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

// How far the arc over a chord turns, and to which side of the chord it is.
struct Arc {
  double turns = 0.0;
  Way3 outward = {};

  // Half of the chord times the tangent of a quarter of the angle.
  [[nodiscard]] double sagitta_m(double chord_m) const {
    return chord_m / 2.0 * std::tan(turns / 4.0);
  }
};

// Of a direction that leads away from the chord at its beginning by half of what the arc turns, or
// by another share of it.
Arc arc_of(const Way3& direction, const Way3& chord, double share, double most) {
  const double lengths = direction.length() * chord.length();
  if (!(lengths > 0.0) || !std::isfinite(lengths)) return {};
  const Way3 ahead = chord.times(1.0 / chord.length());
  const Way3 unit = direction.times(1.0 / direction.length());
  const double along = unit.dot(ahead);
  const Way3 aside = unit.plus(ahead.times(-along));
  const double off = aside.length();
  if (!(off > 0.0)) return {};
  return {std::min(std::atan2(off, along) / share, most), aside.times(1.0 / off)};
}

Arc turned_round(Arc arc) {
  arc.outward = arc.outward.times(-1.0);
  return arc;
}

// What a bee flies from one fix to the next: an arc, or of two that turn to different sides first
// the one and then the other.
struct Bow {
  Arc first;
  Arc second;
  bool to_both_sides = false;

  [[nodiscard]] double sagitta_m(double chord_m) const {
    return std::max(first.sagitta_m(chord_m), second.sagitta_m(chord_m));
  }

  // How far it is from the place on the chord, at this part of the time.
  [[nodiscard]] Way3 offset(const Way3& chord, double part) const {
    const double length = chord.length();
    if (to_both_sides) {
      const double bulge = 4.0 * part * (1.0 - part);
      return first.outward.times(bulge * (1.0 - part) * first.sagitta_m(length))
          .plus(second.outward.times(bulge * part * second.sagitta_m(length)));
    }
    const double radius = length / (2.0 * std::sin(first.turns / 2.0));
    const double angle = first.turns * (part - 0.5);
    const double along = radius * std::sin(angle) - length * (part - 0.5);
    const double out = radius * (std::cos(angle) - std::cos(first.turns / 2.0));
    return chord.times(along / length).plus(first.outward.times(out));
  }
};

class TurnFollowing {
 public:
  TurnFollowing(const io::Recording& recording, const std::vector<Track>& tracks, Geometry geometry,
                const ConflictOptions& options, bool with_velocities)
      : recording_(recording),
        tracks_(tracks),
        geometry_(geometry),
        options_(options),
        with_velocities_(with_velocities),
        jumps_(jump_spans(recording)) {}

  Result<TurnArcs> operator()(const std::vector<Conflict>& known) {
    TurnArcs found;
    found.tracks = tracks_;
    for (PointId bee = 0; bee < tracks_.size(); ++bee) {
      if (auto error = bend(bee, found.tracks[bee])) return *std::move(error);
    }
    if (!bent_) return TurnArcs{};
    ConflictOptions all = options_;
    all.max_results = ConflictOptions{}.max_results;
    auto recorded = find_conflicts(found.tracks, all);
    if (!recorded) return std::move(recorded).error();
    for (Conflict& conflict : recorded->conflicts) {
      if (is_known(conflict, known)) continue;
      const double nearer_m = nearer(conflict, found.tracks);
      if (!(nearer_m > kLittle * options_.threshold_m)) continue;
      found.most_nearer_m = std::max(found.most_nearer_m, nearer_m);
      conflict.certain = false;
      found.conflicts.push_back(conflict);
    }
    if (found.conflicts.empty()) return TurnArcs{};
    leave_out_jumps(recording_, found.conflicts);
    if (found.conflicts.size() + known.size() > options_.max_results) {
      return Error{ErrorCode::kTooManyResults, "there are too many conflicts", {}};
    }
    return found;
  }

 private:
  // The way from one fix to the next; nothing where it is not known.
  [[nodiscard]] std::optional<Way3> way(PointId bee, std::size_t i) const {
    const auto& fixes = tracks_[bee].fixes;
    if (i + 1 >= fixes.size()) return std::nullopt;
    const double lasts_s = fixes[i + 1].time_s - fixes[i].time_s;
    if (lasts_s > options_.max_gap_s) return std::nullopt;
    if (is_within(jumps_, bee, fixes[i].time_s + 0.5 * lasts_s)) return std::nullopt;
    return between(fixes[i].position, fixes[i + 1].position);
  }

  // Puts the arcs into a track where they are more than little.
  std::optional<Error> bend(PointId bee, Track& track) {
    const Track& lines = tracks_[bee];
    const io::RecordedBee& of = recording_.bees[bee];
    if (of.path || of.fixes.size() != lines.fixes.size()) return std::nullopt;
    Track bent;
    for (std::size_t i = 0; i < lines.fixes.size(); ++i) {
      add_fix(lines, i, bent);
      const auto chord = way(bee, i);
      if (!chord) continue;
      auto bow = bow_over(bee, i, *chord);
      if (!bow) return of_bee(std::move(bow).error(), of);
      cut(lines, i, *chord, *bow, bent);
    }
    if (bent.fixes.size() == lines.fixes.size()) return std::nullopt;
    bent_ = true;
    track.fixes = std::move(bent.fixes);
    track.heights_m = std::move(bent.heights_m);
    return std::nullopt;
  }

  static void add_fix(const Track& lines, std::size_t i, Track& bent) {
    bent.fixes.push_back(lines.fixes[i]);
    if (!lines.heights_m.empty()) bent.heights_m.push_back(lines.heights_m[i]);
  }

  [[nodiscard]] Result<Bow> bow_over(PointId bee, std::size_t i, const Way3& chord) const {
    const io::RecordedBee& of = recording_.bees[bee];
    const auto told = [&of](std::size_t at) {
      return at < of.velocities.size() && std::isfinite(of.velocities[at].x) &&
             std::isfinite(of.velocities[at].y);
    };
    if (told(i) && told(i + 1)) {
      return with_velocities_ ? bow_by_velocities(bee, i, chord) : Result<Bow>(Bow{});
    }
    return bow_by_fixes(bee, i, chord);
  }

  [[nodiscard]] Bow bow_by_fixes(PointId bee, std::size_t i, const Way3& chord) const {
    const auto& fixes = tracks_[bee].fixes;
    const double lasts_s = fixes[i + 1].time_s - fixes[i].time_s;
    // From the middle of one way to that of the next.
    const auto share = [lasts_s](double other_s) { return (lasts_s + other_s) / (2.0 * lasts_s); };
    Arc before;
    Arc after;
    if (const auto way_before = i > 0 ? way(bee, i - 1) : std::nullopt) {
      before =
          arc_of(*way_before, chord, share(fixes[i].time_s - fixes[i - 1].time_s), kMostByFixes);
    }
    if (const auto way_after = way(bee, i + 1)) {
      after = turned_round(arc_of(*way_after, chord,
                                  share(fixes[i + 2].time_s - fixes[i + 1].time_s), kMostByFixes));
    }
    const bool to_both_sides =
        before.turns > 0.0 && after.turns > 0.0 && before.outward.dot(after.outward) <= 0.0;
    if (to_both_sides) return {before, after, true};
    const Arc& greater = before.turns >= after.turns ? before : after;
    return {greater, greater, false};
  }

  // Nothing where they are of no arc: velocity_curves.hpp looks at these.
  [[nodiscard]] Result<Bow> bow_by_velocities(PointId bee, std::size_t i, const Way3& chord) const {
    constexpr double kOneSide = 0.5;
    const auto from = velocity_at(bee, i, i);
    if (!from) return from.error();
    const auto to = velocity_at(bee, i + 1, i);
    if (!to) return to.error();
    const Arc before = arc_of(*from, chord, 0.5, kMostByVelocities);
    const Arc after = turned_round(arc_of(*to, chord, 0.5, kMostByVelocities));
    if (!(before.outward.dot(after.outward) > kOneSide)) return Bow{};
    const Arc& less = before.turns <= after.turns ? before : after;
    const auto& fixes = tracks_[bee].fixes;
    const double told_m =
        0.5 * (from->length() + to->length()) * (fixes[i + 1].time_s - fixes[i].time_s);
    const double half = less.turns / 2.0;
    const bool flown = chord.length() * half / std::sin(half) <= kFasterThanTold * told_m;
    return flown ? Bow{less, less, false} : Bow{};
  }

  // How fast it climbs is that of the piece that begins there where it does not tell it.
  [[nodiscard]] Result<Way3> velocity_at(PointId bee, std::size_t at, std::size_t piece) const {
    const io::RecordedBee& of = recording_.bees[bee];
    Velocity velocity = of.velocities[at];
    if (!std::isfinite(velocity.z)) {
      const Fix& before = of.fixes[piece];
      const Fix& behind = of.fixes[piece + 1];
      velocity.z =
          flushed((behind.position.z - before.position.z) / (behind.time_s - before.time_s));
    }
    const auto metres = in_metres(of.fixes[at].position, velocity, recording_.frame, geometry_,
                                  stated_height(recording_, of, at));
    if (!metres) return metres.error();
    if (!metres->velocity) return Way3{};
    return Way3{metres->velocity->x, metres->velocity->y, metres->velocity->z};
  }

  // All but its ends, on the arc.
  void cut(const Track& lines, std::size_t i, const Way3& chord, const Bow& bow,
           Track& bent) const {
    constexpr double kSeen = 0.5 * kLittle;
    constexpr double kFine = 1e-3;  // of the threshold
    constexpr double kMostLines = 32.0;
    constexpr double kShortest_s = 1e-4;
    const double sagitta_m = bow.sagitta_m(chord.length());
    if (!(sagitta_m > kSeen * options_.threshold_m)) return;
    const Fix& from = lines.fixes[i];
    const double lasts_s = lines.fixes[i + 1].time_s - from.time_s;
    const double count = std::min(
        kMostLines, std::ceil(std::sqrt(sagitta_m / (kFine * options_.threshold_m))) + 1.0);
    if (lasts_s < kShortest_s * count) return;
    for (std::uint32_t k = 1; k < static_cast<std::uint32_t>(count); ++k) {
      const double part = k / count;
      const Way3 off = chord.times(part).plus(bow.offset(chord, part));
      bent.fixes.push_back({from.time_s + lasts_s * part,
                            {flushed(from.position.x + off.x), flushed(from.position.y + off.y),
                             flushed(from.position.z + off.z)}});
      if (lines.heights_m.empty()) continue;
      bent.heights_m.push_back(
          flushed(lines.heights_m[i] + part * (lines.heights_m[i + 1] - lines.heights_m[i])));
    }
  }

  // By how much the two are nearer than on straight lines, when they are worst.
  [[nodiscard]] double nearer(const Conflict& conflict, const std::vector<Track>& arcs) const {
    const double unit_m = options_.height_unit_m;
    double at_s = conflict.closest_s;
    if (options_.vertical_m) {
      const auto worst =
          worst_of(arcs, unit_m, {options_.threshold_m, *options_.vertical_m * unit_m})(conflict);
      if (worst) at_s = worst->time_s;
    }
    const auto on_arcs = apart_at(arcs[conflict.first], arcs[conflict.second], at_s, unit_m);
    const auto on_lines = apart_at(tracks_[conflict.first], tracks_[conflict.second], at_s, unit_m);
    if (!on_arcs || !on_lines) return 0.0;
    if (options_.vertical_m) return on_lines->horizontal_m - on_arcs->horizontal_m;
    return std::hypot(on_lines->horizontal_m, on_lines->vertical_m) -
           std::hypot(on_arcs->horizontal_m, on_arcs->vertical_m);
  }

  static bool is_known(const Conflict& conflict, const std::vector<Conflict>& known) {
    const auto by_pair = [](const Conflict& a, const Conflict& b) {
      return std::pair(a.first, a.second) < std::pair(b.first, b.second);
    };
    const auto [from, to] = std::equal_range(known.begin(), known.end(), conflict, by_pair);
    return std::any_of(from, to, [&](const Conflict& one) {
      return one.begins_s <= conflict.ends_s && one.ends_s >= conflict.begins_s;
    });
  }

  const io::Recording& recording_;
  const std::vector<Track>& tracks_;
  Geometry geometry_;
  const ConflictOptions& options_;
  bool with_velocities_;
  std::vector<Gap> jumps_;
  bool bent_ = false;
};

}  // namespace

Result<TurnArcs> follow_turns(const io::Recording& recording, const std::vector<Track>& tracks,
                              Geometry geometry, const ConflictOptions& options,
                              bool with_velocities, const std::vector<Conflict>& known) {
  if (!recording.of_aircraft || recording.flies_on || recording.show ||
      recording.bees.size() != tracks.size()) {
    return TurnArcs{};
  }
  return TurnFollowing(recording, tracks, geometry, options, with_velocities)(known);
}

std::string turn_arcs_text(const TurnArcs& arcs) {
  if (arcs.conflicts.empty()) return {};
  std::string text = io::counted(arcs.conflicts.size(), "conflict is", "conflicts are");
  text += " possible, not certain: on the arcs on which they turn between fixes two are up to ";
  text += io::length(arcs.most_nearer_m);
  text += " nearer than on straight lines";
  return text;
}

}  // namespace beespace::analysis
