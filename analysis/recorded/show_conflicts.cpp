#include "analysis/recorded/show_conflicts.hpp"

#include "analysis/recorded/along_curves.hpp"
#include "analysis/recorded/ends.hpp"
#include "analysis/recorded/findings.hpp"
#include "analysis/recorded/flights.hpp"
#include "analysis/recorded/tracks.hpp"

#include <beespace/bezier_path.hpp>
#include <beespace/index.hpp>
#include <beespace/verify_path.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace beespace::analysis {
namespace {

// Who stands so near to a way, and at such a time, that the two have to be looked at.
class Neighbours {
 public:
  // Errors: those of Index::build().
  static Result<Neighbours> of(std::vector<Standing> standing, const ConflictOptions& options) {
    std::vector<Point> places;
    places.reserve(standing.size());
    for (const Standing& one : standing) places.push_back(one.at);
    auto index = Index::build(places, {options.threads, options.stop});
    if (!index) return std::move(index).error();
    return Neighbours(std::move(standing), *std::move(index), options);
  }

  // By their places in standing(), each once. Errors: those of Index::find_around().
  [[nodiscard]] Result<std::vector<std::size_t>> of(PointId bee, const Track& track) const {
    std::vector<std::size_t> found;
    std::vector<PointId> around;
    for (std::size_t i = 0; i < track.fixes.size(); ++i) {
      const Fix& from = track.fixes[i];
      const Fix& to = track.fixes[std::min(i + 1, track.fixes.size() - 1)];
      const Status looked =
          index_.find_around(middle_of(from.position, to.position),
                             radius_of(from, to, track.tolerance_m), true, around);
      if (!looked) return looked.error();
      for (const PointId place : around) {
        const Standing& one = standing_[place];
        if (one.bee != bee && is_near(one, from, to, track.tolerance_m)) found.push_back(place);
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  [[nodiscard]] const std::vector<Standing>& standing() const { return standing_; }

 private:
  Neighbours(std::vector<Standing> standing, Index index, const ConflictOptions& options)
      : standing_(std::move(standing)),
        index_(std::move(index)),
        across_m_(options.threshold_m),
        up_m_(std::max(options.threshold_m, options.vertical_m.value_or(0.0))) {}

  static Point middle_of(const Point& a, const Point& b) {
    return {a.x + (b.x - a.x) * 0.5, a.y + (b.y - a.y) * 0.5, a.z + (b.z - a.z) * 0.5};
  }

  // Of a ball around the middle that holds all that is_near() may take, with some room for
  // rounding.
  [[nodiscard]] double radius_of(const Fix& from, const Fix& to, double tolerance_m) const {
    constexpr double kRoom = 1.001;
    const Point& a = from.position;
    const Point& b = to.position;
    const double across_m = across_m_ + tolerance_m;
    const double corner_m = std::hypot(across_m, across_m, up_m_ + tolerance_m);
    return kRoom * (0.5 * std::hypot(b.x - a.x, b.y - a.y, b.z - a.z) + corner_m);
  }

  [[nodiscard]] bool is_near(const Standing& one, const Fix& from, const Fix& to,
                             double tolerance_m) const {
    const auto within = [&](double value, double a, double b, double margin_m) {
      return value >= std::min(a, b) - margin_m - tolerance_m &&
             value <= std::max(a, b) + margin_m + tolerance_m;
    };
    return one.span.begins_s <= to.time_s && one.span.ends_s >= from.time_s &&
           within(one.at.x, from.position.x, to.position.x, across_m_) &&
           within(one.at.y, from.position.y, to.position.y, across_m_) &&
           within(one.at.z, from.position.z, to.position.z, up_m_);
  }

  std::vector<Standing> standing_;
  Index index_;  // of their places
  double across_m_;
  double up_m_;
};

BezierPath path_of(const Standing& standing) {
  return {standing.span.begins_s, standing.at, {{standing.span.ends_s, standing.at, {}, 0}}};
}

// Whether the curves have no more to say: where it is asked for more than being closer.
bool is_settled(const ConflictOptions& options) {
  return options.inclusive || options.vertical_m;
}

// As along_curves(), but how close the two come as the search has it where that is certain: along
// straight lines it is exact.
Result<std::vector<Conflict>> settle(const Conflict& conflict, const Flight& first,
                                     const Flight& second, double threshold_m) {
  auto settled = along_curves(conflict, first, second, threshold_m);
  if (!settled || !conflict.certain) return settled;
  for (Conflict& one : *settled) {
    if (one.begins_s > conflict.closest_s || one.ends_s < conflict.closest_s) continue;
    one.closest_s = conflict.closest_s;
    one.closest_m = conflict.closest_m;
  }
  return settled;
}

std::tuple<PointId, PointId, double> order_of(const Conflict& conflict) {
  return {conflict.first, conflict.second, conflict.begins_s};
}

// Of one drone in the air and one that stands.
Result<std::vector<Conflict>> conflicts_of(PointId bee, const io::Recording& recording,
                                           const Track& track, const Standing& standing,
                                           ConflictOptions options) {
  const BezierPath still = path_of(standing);
  Track other{{{standing.span.begins_s, standing.at}, {standing.span.ends_s, standing.at}}};
  if (!track.heights_m.empty()) other.heights_m = {standing.at.z, standing.at.z};
  options.max_gap_s = std::numeric_limits<double>::infinity();
  options.threads = 1;
  auto found = find_conflicts(std::vector<Track>{track, std::move(other)}, options);
  if (!found) return of_bee(std::move(found).error(), recording.bees[bee]);
  std::vector<Conflict> kept;
  for (const Conflict& conflict : found->conflicts) {
    std::vector<Conflict> settled = {conflict};
    const auto& path = recording.bees[bee].path;
    if (path && !is_settled(options)) {
      auto along = settle(conflict, Flight{*path}, Flight{still}, options.threshold_m);
      if (!along) return of_bee(std::move(along).error(), recording.bees[bee]);
      settled = *std::move(along);
    }
    for (Conflict& one : settled) {
      one.first = std::min(bee, standing.bee);
      one.second = std::max(bee, standing.bee);
      kept.push_back(one);
    }
  }
  return kept;
}

}  // namespace

std::vector<Standing> standing_in(const io::Recording& recording) {
  constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  TimeSpan whole{kUnbounded, -kUnbounded};
  std::vector<std::optional<Ends>> ends;
  for (const io::RecordedBee& bee : recording.bees) {
    const auto& last = ends.emplace_back(ends_of(bee));
    if (!last) continue;
    whole = {std::min(whole.begins_s, last->first.time_s),
             std::max(whole.ends_s, last->last.time_s)};
  }
  const double ground_m = ground_of(recording);
  std::vector<Standing> standing;
  if (!recording.show) return standing;
  const auto add = [&](std::size_t bee, const TimeSpan& span, const Point& at) {
    if (span.begins_s < span.ends_s && at.z - ground_m <= kStandsWithin_m) {
      standing.push_back({static_cast<PointId>(bee), span, at});
    }
  };
  for (std::size_t bee = 0; bee < ends.size(); ++bee) {
    if (const auto& stands = recording.bees[bee].stands; stands && whole.begins_s < whole.ends_s) {
      standing.push_back({static_cast<PointId>(bee), whole, *stands});
    }
    if (!ends[bee]) continue;
    const Ends& of = *ends[bee];
    add(bee, {whole.begins_s, of.first.time_s}, of.first.position);
    add(bee, {of.last.time_s, whole.ends_s}, of.last.position);
  }
  return standing;
}

namespace {

// At the instant at which it takes off or lands it flies, too: both do then, and are compared so.
void leave_out_ends(const Track& of_standing, std::vector<Conflict>& conflicts) {
  std::erase_if(conflicts, [&of_standing](const Conflict& conflict) {
    return conflict.begins_s == conflict.ends_s &&
           std::any_of(of_standing.fixes.begin(), of_standing.fixes.end(),
                       [&conflict](const Fix& fix) { return fix.time_s == conflict.begins_s; });
  });
}

}  // namespace

Result<std::vector<Conflict>> conflicts_with_standing(const io::Recording& recording,
                                                      const std::vector<Track>& tracks,
                                                      const ConflictOptions& options) {
  std::vector<Conflict> conflicts;
  auto standing = standing_in(recording);
  if (standing.empty()) return conflicts;
  const auto neighbours = Neighbours::of(std::move(standing), options);
  if (!neighbours) return neighbours.error();
  for (PointId bee = 0; bee < tracks.size(); ++bee) {
    const auto places = neighbours->of(bee, tracks[bee]);
    if (!places) return of_bee(places.error(), recording.bees[bee]);
    for (const std::size_t place : *places) {
      auto found =
          conflicts_of(bee, recording, tracks[bee], neighbours->standing()[place], options);
      if (!found) return found;
      leave_out_ends(tracks[neighbours->standing()[place].bee], *found);
      conflicts.insert(conflicts.end(), found->begin(), found->end());
    }
  }
  std::sort(conflicts.begin(), conflicts.end(),
            [](const Conflict& a, const Conflict& b) { return order_of(a) < order_of(b); });
  return conflicts;
}

void stand_in_tracks(const io::Recording& recording, std::vector<Track>& tracks) {
  for (const Standing& one : standing_in(recording)) {
    if (!recording.bees[one.bee].stands) continue;
    tracks[one.bee].fixes = {{one.span.begins_s, one.at}, {one.span.ends_s, one.at}};
  }
}

std::vector<Track> with_standing(std::vector<Track> tracks, const io::Recording& recording,
                                 const std::vector<PointId>& bees) {
  std::vector<bool> wanted(tracks.size());
  for (const PointId bee : bees) wanted[bee] = true;
  for (const Standing& one : standing_in(recording)) {
    auto& fixes = tracks[one.bee].fixes;
    if (!wanted[one.bee] || fixes.empty()) continue;  // one that never takes off: stand_in_tracks()
    if (one.span.begins_s < fixes.front().time_s) {
      fixes.insert(fixes.begin(), {one.span.begins_s, one.at});
    }
    if (one.span.ends_s > fixes.back().time_s) fixes.push_back({one.span.ends_s, one.at});
  }
  return tracks;
}

Result<std::vector<Conflict>> settled_conflicts(const io::Recording& recording,
                                                const ConflictOptions& options,
                                                std::vector<Conflict> conflicts) {
  if (!recording.show || is_settled(options) || conflicts.empty()) return conflicts;
  const std::vector<Flight> flights = flights_of(recording, false, options.max_gap_s);
  std::vector<Conflict> all;
  for (const Conflict& conflict : conflicts) {
    const auto settled =
        settle(conflict, flights[conflict.first], flights[conflict.second], options.threshold_m);
    if (!settled) return of_bee(settled.error(), recording.bees[conflict.first]);
    all.insert(all.end(), settled->begin(), settled->end());
  }
  return all;
}

Result<ShowConflicts> conflicts_of_show(const io::Recording& recording,
                                        const std::vector<Track>& tracks,
                                        const ConflictOptions& options,
                                        std::vector<Conflict> conflicts) {
  auto settled = settled_conflicts(recording, options, std::move(conflicts));
  if (!settled) return settled.error();
  const auto standing = conflicts_with_standing(recording, tracks, options);
  if (!standing) return standing.error();
  return ShowConflicts{merged(*std::move(settled), *standing), *standing};
}

}  // namespace beespace::analysis
