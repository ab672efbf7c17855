#include "tests/differential/mover_oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace beespace::differential {

namespace {

using Doubles = std::array<double, 4>;

Doubles place_of(const Flight& f) {
  return {f.mover.position.x, f.mover.position.y, f.mover.position.z, f.height};
}
Doubles velocity_of(const Flight& f) {
  return {f.mover.velocity.x, f.mover.velocity.y, f.mover.velocity.z, f.climb};
}

// Two movers in units in which everything is whole: lengths, times, and one by the other.
class Encounter {
 public:
  Encounter(const Flight& a, const Flight& b, const PredictOptions& options, bool apart)
      : Encounter(a, b, options, apart, {}) {}
  // At these times too.
  Encounter(const Flight& a, const Flight& b, const PredictOptions& options, bool apart,
            const std::vector<double>& times)
      : passage_({}, {}, {}) {
    Unit lengths;
    Unit speeds;
    Unit seconds;
    for (const Flight* flight : {&a, &b}) {
      for (const double value : place_of(*flight)) lengths.include(value);
      for (const double value : velocity_of(*flight)) speeds.include(value);
    }
    lengths.include(options.threshold_m);
    lengths.include(options.vertical_m.value_or(0.0));
    seconds.include(options.horizon_s);
    for (const double time : times) seconds.include(time);
    second_ = seconds.exponent();
    metre_ = std::min(lengths.exponent(), speeds.exponent() + second_);
    Axes r;
    Axes w;
    for (std::size_t axis = 0; axis < 4; ++axis) {
      r[axis] = whole(place_of(b)[axis], metre_) - whole(place_of(a)[axis], metre_);
      w[axis] = whole(velocity_of(b)[axis], metre_ - second_) -
                whole(velocity_of(a)[axis], metre_ - second_);
    }
    Limits limits{whole(options.threshold_m, metre_), {}, options.inclusive, apart ? 3U : 2U};
    if (options.vertical_m) limits.vertical = whole(*options.vertical_m, metre_);
    passage_ = Passage(r, w, limits);
    end_ = whole(options.horizon_s, second_);
  }

  [[nodiscard]] bool in_conflict() const { return passage_.in_conflict_within({0, 1}, {end_, 1}); }
  [[nodiscard]] const Passage& passage() const { return passage_; }
  [[nodiscard]] Fraction time(double seconds) const { return {whole(seconds, second_), 1}; }

 private:
  int metre_ = 0;   // the exponent of the unit of lengths
  int second_ = 0;  // of times
  Passage passage_;
  Whole end_;
};

// The options with thresholds changed by the slacks; nothing where one is used up.
std::optional<PredictOptions> changed(PredictOptions options, double level, double height) {
  options.threshold_m += level;
  if (options.vertical_m) *options.vertical_m += height;
  options.inclusive = true;
  if (!(options.threshold_m > 0.0) || !(options.vertical_m.value_or(1.0) > 0.0)) {
    return std::nullopt;
  }
  return options;
}

}  // namespace

bool in_conflict(const Flight& a, const Flight& b, const PredictOptions& options, bool apart) {
  return Encounter(a, b, options, apart).in_conflict();
}

std::vector<Pair> pairs_in_conflict(const std::vector<Flight>& flights,
                                    const PredictOptions& options, bool apart) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < flights.size(); ++i) {
    for (std::size_t j = i + 1; j < flights.size(); ++j) {
      if (!in_conflict(flights[i], flights[j], options, apart)) continue;
      pairs.push_back({static_cast<PointId>(i), static_cast<PointId>(j)});
    }
  }
  return pairs;
}

std::string fault_of(const Conflict& c, const Flight& a, const Flight& b,
                     const PredictOptions& options, bool apart) {
  if (!(0.0 <= c.begins_s && c.begins_s <= c.closest_s && c.closest_s <= c.ends_s &&
        c.ends_s <= options.horizon_s)) {
    return "its times are out of order";
  }
  // How far apart they begin; a little more than rounding makes of it.
  double level = 0.0;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    level = std::hypot(level, place_of(b)[axis] - place_of(a)[axis]);
  }
  constexpr double kShare = 0x1.01p-48;
  const double level_slack = kShare * (level + options.threshold_m);
  const double height_slack = kShare * (level + options.vertical_m.value_or(0.0));
  const std::vector<double> times = {c.begins_s, c.closest_s, c.ends_s};
  if (const auto wide = changed(options, level_slack, height_slack)) {
    const Encounter outer(a, b, *wide, apart, times);
    for (const double time : times) {
      if (!outer.passage().in_conflict_at(outer.time(time)))
        return "not in conflict at " + std::to_string(time);
    }
  }
  if (const auto narrow = changed(options, -level_slack, -height_slack)) {
    const Encounter inner(a, b, *narrow, apart, times);
    if (c.begins_s > 0.0 && inner.passage().in_conflict_at(inner.time(c.begins_s))) {
      return "it begins earlier";
    }
    if (c.ends_s < options.horizon_s && inner.passage().in_conflict_at(inner.time(c.ends_s))) {
      return "it ends later";
    }
  }
  // How close: by thresholds around the distance that is reported.
  const double slack = level_slack + height_slack;
  PredictOptions by_distance = options;
  by_distance.vertical_m.reset();
  by_distance.inclusive = true;
  by_distance.threshold_m = c.closest_m + slack;
  const Encounter within(a, b, by_distance, apart, times);
  if (!within.passage().in_conflict_at(within.time(c.closest_s))) return "never so close";
  if (c.closest_m - slack <= 0.0) return "";
  by_distance.threshold_m = c.closest_m - slack;
  const Encounter closer(a, b, by_distance, apart, times);
  if (closer.passage().in_conflict_within(closer.time(c.begins_s), closer.time(c.ends_s))) {
    return "once closer";
  }
  return "";
}

}  // namespace beespace::differential
