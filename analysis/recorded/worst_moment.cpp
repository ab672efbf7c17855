#include "analysis/recorded/worst_moment.hpp"

#include "analysis/recorded/apart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

namespace beespace::analysis {
namespace {

// The way from one to the other.
struct Offset {
  Point across = {};
  double up_m = 0.0;
};

using OffsetAt = std::function<std::optional<Offset>(const Conflict&, double time_s)>;

Offset offset_of(const Point& a, const Point& b) {
  return {{b.x - a.x, b.y - a.y, 0.0}, b.z - a.z};
}

// Heights stand beside places, all of whose axes are horizontal.
Offset offset_of(const Point& a, double height_a, const Point& b, double height_b,
                 double height_unit_m) {
  return {{b.x - a.x, b.y - a.y, b.z - a.z}, (height_b - height_a) * height_unit_m};
}

double dot_of(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// While the way between two changes evenly. Its length over the ground and that in height are
// convex then, and so is the greater of their shares: it is least at an end, where one of them is,
// or where they are equal.
class EvenPiece {
 public:
  EvenPiece(const TimeSpan& span, const Offset& from, const Offset& to, const Minima& minima)
      : span_(span),
        from_(from),
        change_{
            {to.across.x - from.across.x, to.across.y - from.across.y, to.across.z - from.across.z},
            to.up_m - from.up_m},
        minima_(minima) {}

  template <class Take>
  void each_candidate(const Take& take) const {
    take(at(0.0));
    take(at(1.0));
    const double across = dot_of(change_.across, change_.across);
    within(-dot_of(from_.across, change_.across) / across, take);
    within(-from_.up_m / change_.up_m, take);
    for (const double part : where_equal()) within(part, take);
  }

 private:
  [[nodiscard]] WorstMoment at(double part) const {
    const Point across{from_.across.x + part * change_.across.x,
                       from_.across.y + part * change_.across.y,
                       from_.across.z + part * change_.across.z};
    const double up_m = std::abs(from_.up_m + part * change_.up_m);
    // What rounding leaves of nothing is nothing.
    constexpr double kNothing = 1e-12;
    const bool level = up_m < kNothing * (std::abs(from_.up_m) + std::abs(change_.up_m));
    const Apart apart{std::hypot(across.x, across.y, across.z), level ? 0.0 : up_m};
    return {
        span_.begins_s + part * (span_.ends_s - span_.begins_s),
        std::max(apart.horizontal_m / minima_.threshold_m, apart.vertical_m / minima_.vertical_m),
        apart};
  }

  // What does not change has no such part, which is not a number or endless then.
  template <class Take>
  void within(double part, const Take& take) const {
    if (part > 0.0 && part < 1.0) take(at(part));
  }

  // The roots of the difference of the squares of both shares.
  [[nodiscard]] std::array<double, 2> where_equal() const {
    const double across = 1.0 / minima_.threshold_m;
    const double up = 1.0 / minima_.vertical_m;
    const auto difference = [&](double of_across, double of_up) {
      return of_across * across * across - of_up * up * up;
    };
    const double a =
        difference(dot_of(change_.across, change_.across), change_.up_m * change_.up_m);
    const double b = difference(dot_of(from_.across, change_.across), from_.up_m * change_.up_m);
    const double c = difference(dot_of(from_.across, from_.across), from_.up_m * from_.up_m);
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const double square = b * b - a * c;
    if (!(square >= 0.0)) return {kNone, kNone};
    const double q = -(b + std::copysign(std::sqrt(square), b));
    return {q / a, c / q};
  }

  TimeSpan span_;
  Offset from_;
  Offset change_;
  Minima minima_;
};

// The lesser share of both thresholds.
double lesser_share(const WorstMoment& moment, const Minima& minima) {
  return std::min(moment.apart.horizontal_m / minima.threshold_m,
                  moment.apart.vertical_m / minima.vertical_m);
}

// Of moments that are as bad but for the rounding of places the one at which the other share is
// least: of two that fly side by side, and of which one climbs through the level of the other, that
// in which it does. Shares that differ by a rounding of numbers are equal.
std::optional<WorstMoment> worst_among(const std::vector<WorstMoment>& moments,
                                       const Minima& minima) {
  constexpr double kRounding = 1e-9;
  double least = std::numeric_limits<double>::infinity();
  for (const WorstMoment& moment : moments) least = std::min(least, moment.share);
  std::optional<WorstMoment> worst;
  for (const WorstMoment& moment : moments) {
    if (!(moment.share <= least + kAsBad)) continue;
    if (!worst) {
      worst = moment;
      continue;
    }
    const double less = lesser_share(*worst, minima) - lesser_share(moment, minima);
    if (std::abs(less) > kRounding ? less > 0.0 : moment.share < worst->share - kRounding) {
      worst = moment;
    }
  }
  return worst;
}

// Between two of these times, ascending, both fly straight.
std::optional<WorstMoment> worst_along(const Conflict& conflict, const std::vector<double>& times_s,
                                       const OffsetAt& offset_at, const Minima& minima) {
  std::vector<WorstMoment> moments;
  const auto take = [&moments](const WorstMoment& moment) { moments.push_back(moment); };
  std::optional<Offset> from = offset_at(conflict, times_s.front());
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    const std::optional<Offset> to = offset_at(conflict, times_s[i]);
    if (from && to) {
      EvenPiece({times_s[i - 1], times_s[i]}, *from, *to, minima).each_candidate(take);
    }
    from = to;
  }
  return worst_among(moments, minima);
}

void add_fix_times(const Track& track, const Conflict& conflict, std::vector<double>& times_s) {
  const auto after = [](double time_s, const Fix& fix) { return time_s < fix.time_s; };
  auto fix = std::upper_bound(track.fixes.begin(), track.fixes.end(), conflict.begins_s, after);
  for (; fix != track.fixes.end() && fix->time_s < conflict.ends_s; ++fix) {
    times_s.push_back(fix->time_s);
  }
}

Point flown_place(const Mover& mover, double seconds) {
  const Point& p = mover.position;
  const Velocity& v = mover.velocity;
  return {p.x + v.x * seconds, p.y + v.y * seconds, p.z + v.z * seconds};
}

}  // namespace

WorstOf worst_of(const std::vector<Track>& tracks, double height_unit_m, const Minima& minima) {
  OffsetAt offset_at = [&tracks, height_unit_m](const Conflict& conflict,
                                                double time_s) -> std::optional<Offset> {
    const Track& first = tracks[conflict.first];
    const Track& second = tracks[conflict.second];
    const auto instant_s = common_instant(first, second, time_s);
    if (!instant_s) return std::nullopt;
    const auto one = whereabouts_at(first, *instant_s);
    const auto other = whereabouts_at(second, *instant_s);
    if (!one || !other) return std::nullopt;
    if (!one->height || !other->height) return offset_of(one->place, other->place);
    return offset_of(one->place, *one->height, other->place, *other->height, height_unit_m);
  };
  return [&tracks, offset_at = std::move(offset_at), minima](const Conflict& conflict) {
    std::vector<double> times_s = {conflict.begins_s, conflict.ends_s};
    add_fix_times(tracks[conflict.first], conflict, times_s);
    add_fix_times(tracks[conflict.second], conflict, times_s);
    std::sort(times_s.begin(), times_s.end());
    return worst_along(conflict, times_s, offset_at, minima);
  };
}

WorstOf worst_of(const Snapshot& snapshot, double height_unit_m, const Minima& minima) {
  std::unordered_map<std::uint32_t, std::size_t> places;
  Snapshot all = snapshot.present();
  for (std::size_t i = 0; i < all.bees.size(); ++i) places.emplace(all.bees[i], i);
  OffsetAt offset_at = [all = std::move(all), places = std::move(places), height_unit_m](
                           const Conflict& conflict, double time_s) -> std::optional<Offset> {
    const auto first = places.find(conflict.first);
    const auto second = places.find(conflict.second);
    if (first == places.end() || second == places.end()) return std::nullopt;
    const std::size_t a = first->second;
    const std::size_t b = second->second;
    const double seconds = time_s - all.time_s;
    const Point one = flown_place(all.movers[a], seconds);
    const Point other = flown_place(all.movers[b], seconds);
    if (all.heights_m.empty()) return offset_of(one, other);
    return offset_of(one, all.heights_m[a] + all.climbs_mps[a] * seconds, other,
                     all.heights_m[b] + all.climbs_mps[b] * seconds, height_unit_m);
  };
  return [offset_at = std::move(offset_at), minima](const Conflict& conflict) {
    return worst_along(conflict, {conflict.begins_s, conflict.ends_s}, offset_at, minima);
  };
}

double rank_of(const Conflict& conflict, const WorstOf& worst) {
  if (!worst) return conflict.closest_m;
  const auto moment = worst(conflict);
  return moment ? moment->share : std::numeric_limits<double>::infinity();
}

void sort_worst_first(const WorstOf& worst, std::vector<Conflict>& conflicts) {
  std::vector<std::pair<double, Conflict>> ranked;
  ranked.reserve(conflicts.size());
  for (const Conflict& conflict : conflicts) {
    ranked.emplace_back(rank_of(conflict, worst), conflict);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < ranked.size(); ++i) conflicts[i] = ranked[i].second;
}

}  // namespace beespace::analysis
