// A flock that is advised step after step, with all checks of what advice promises.
#pragma once

#include "scenes/random_stream.hpp"
#include "scenes/random_velocity.hpp"
#include "tests/avoidance/long_vector.hpp"

#include <beespace/advise.hpp>
#include <beespace/verify.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace beespace::test {

inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

inline double length_of(const Velocity& v) {
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}
inline double length_of_change(const Velocity& v, const Velocity& w) {
  return length_of({w.x - v.x, w.y - v.y, w.z - v.z});
}
inline double distance_of(const Point& p, const Point& q) {
  return length_of({p.x - q.x, p.y - q.y, p.z - q.z});
}
inline Velocity scaled(const Velocity& v, double by) {
  return {v.x * by, v.y * by, v.z * by};
}
inline Velocity towards(const Point& from, const Point& to, double speed) {
  const double far = distance_of(from, to);
  const double share = far > 1e-9 * speed ? speed / far : 0.0;
  return {(to.x - from.x) * share, (to.y - from.y) * share, (to.z - from.z) * share};
}

struct Flock {
  std::vector<Mover> movers;
  std::vector<FlightLimits> limits;  // of each
  AdviseOptions options{.threshold_m = 5.0, .clearance_m = 1.0};

  [[nodiscard]] std::size_t size() const { return movers.size(); }
  [[nodiscard]] bool at_once(std::size_t bee) const {
    return std::isinf(limits[bee].max_acceleration_mps2);
  }
  // From a bee's position to its latest stopping point, by the formula of docs/prevention.md.
  [[nodiscard]] LongSegment stopping_segment(std::size_t bee) const {
    const auto& [p, v] = movers[bee];
    if (at_once(bee)) return {long_of(p), {}};
    const long double speed = length(long_of(v));
    const long double lasts_s =
        0.5L * (speed / static_cast<long double>(limits[bee].max_acceleration_mps2) +
                static_cast<long double>(options.step_s));
    return {long_of(p), long_of(v) * lasts_s};
  }
  [[nodiscard]] long double ways_apart(std::size_t bee, std::size_t other) const {
    return distance_between(stopping_segment(bee), stopping_segment(other));
  }
  [[nodiscard]] long double least_ways_apart() const {
    long double least = std::numeric_limits<long double>::infinity();
    for (std::size_t i = 0; i < size(); ++i) {
      for (std::size_t j = i + 1; j < size(); ++j) least = std::min(least, ways_apart(i, j));
    }
    return least;
  }
};

// A bee's position after a step, flown as the header says.
inline Mover flown(const Mover& mover, const Velocity& next, bool at_once, double step_s) {
  const auto& [p, v] = mover;
  const Velocity mean =
      at_once ? next : Velocity{0.5 * (v.x + next.x), 0.5 * (v.y + next.y), 0.5 * (v.z + next.z)};
  return {{p.x + mean.x * step_s, p.y + mean.y * step_s, p.z + mean.z * step_s}, next};
}

// An upper limit of what flushing small values to zero may change of a velocity.
inline constexpr double kFlushed_mps = 4.0 * kSmallestInMotion;

// No bee is faster or turns harder than its limits allow.
inline void expect_within_limits(const Flock& flock, const std::vector<Advice>& advice) {
  constexpr double kRounded = 1.0 + 1e-12;
  for (std::size_t bee = 0; bee < flock.size(); ++bee) {
    const Velocity& before = flock.movers[bee].velocity;
    const Velocity& next = advice[bee].velocity;
    const FlightLimits& limits = flock.limits[bee];
    ASSERT_TRUE(std::isfinite(length_of(next))) << "bee " << bee;
    const double fastest = flock.at_once(bee) ? limits.max_speed_mps
                                              : std::max(limits.max_speed_mps, length_of(before));
    ASSERT_LE(length_of(next), fastest * kRounded) << "bee " << bee;
    if (flock.at_once(bee)) continue;
    const double change = limits.max_acceleration_mps2 * flock.options.step_s;
    ASSERT_LE(length_of_change(before, next),
              change * kRounded + 1e-15 * length_of(before) + kFlushed_mps)
        << "bee " << bee;
  }
}

// The verdict of an independent Verifier on one step of all bees. A bee without a limit of
// acceleration flies straight: a curve with the same velocity at both ends.
inline Verdict verdict_of_step(const Flock& flock, const std::vector<Mover>& after) {
  VerifyOptions options;
  options.threshold_m = flock.options.threshold_m;
  options.obstacles = flock.options.obstacles;
  options.clearance_m = flock.options.clearance_m;
  options.max_speed_mps = 0.0;
  options.max_acceleration_mps2 = 0.0;
  std::vector<Mover> before = flock.movers;
  for (std::size_t bee = 0; bee < flock.size(); ++bee) {
    if (flock.at_once(bee)) before[bee].velocity = after[bee].velocity;
    const FlightLimits& limits = flock.limits[bee];
    options.max_speed_mps = std::max(
        {options.max_speed_mps, limits.max_speed_mps, length_of(flock.movers[bee].velocity)});
    if (flock.at_once(bee)) continue;
    options.max_acceleration_mps2 =
        std::max(options.max_acceleration_mps2, limits.max_acceleration_mps2);
  }
  options.max_speed_mps += kFlushed_mps;
  options.max_acceleration_mps2 += kFlushed_mps / flock.options.step_s;
  Verifier verifier(options);
  EXPECT_TRUE(verifier.add(0.0, before));
  EXPECT_TRUE(verifier.add(flock.options.step_s, after));
  EXPECT_EQ(verifier.verdict().breaches, 0U);
  return verifier.verdict();
}

// Flies a step as advised. No limit is broken.
inline Verdict fly_a_step(Flock& flock, Adviser& adviser, const std::vector<Velocity>& wishes,
                          Advised& advised) {
  const Status status = adviser.advise(flock.movers, wishes, flock.limits, flock.options, advised);
  EXPECT_TRUE(status) << status.error().message;
  if (!status) return {};
  expect_within_limits(flock, advised.advice);
  std::vector<Mover> after;
  for (std::size_t bee = 0; bee < flock.size(); ++bee) {
    after.push_back(flown(flock.movers[bee], advised.advice[bee].velocity, flock.at_once(bee),
                          flock.options.step_s));
  }
  const Verdict verdict = verdict_of_step(flock, after);
  flock.movers = after;
  return verdict;
}

inline std::vector<Pair> pairs_of(const std::vector<TooClose>& too_close) {
  std::vector<Pair> pairs;
  for (const TooClose& close : too_close) pairs.push_back(close.pair);
  return pairs;
}

// Advice to a bee without any conflict.
inline Advice certified(const Velocity& velocity, AdviceKind kind = AdviceKind::kAsPreferred) {
  Advice advice{velocity, kind, true, true, true};
  advice.clear_of_unknown_s = kNoLimit;
  advice.clear_of_unknown = true;
  return advice;
}

// Concerns the bees that are advised, and obstacles; no intruders.
inline bool all_keep_apart(const Advised& advised) {
  return advised.too_close.empty() && advised.near_obstacle.empty() &&
         std::all_of(advised.advice.begin(), advised.advice.end(),
                     [](const Advice& advice) { return advice.keeps_apart; });
}

inline bool all_certified(const Advised& advised) {
  return advised.too_close.empty() && advised.near_obstacle.empty() &&
         std::all_of(advised.advice.begin(), advised.advice.end(),
                     [](const Advice& advice) { return advice.certified; });
}

inline double log_uniform(scenes::RandomStream& random, double low, double high) {
  return low * std::exp(random.uniform() * std::log(high / low));
}

inline Velocity random_velocity(scenes::RandomStream& random, double most) {
  const auto [x, y, z] = scenes::random_direction(random);
  const double speed = random.uniform(0.0, most);
  return {x * speed, y * speed, z * speed};
}

// Adds a bee at a random place in a cube where its stopping segment is `spacing_m` from those of
// all others; with a velocity if there is one for which that holds.
inline bool add_bee(Flock& flock, const FlightLimits& limits, double side_m, double spacing_m,
                    const Point& offset, scenes::RandomStream& random) {
  const auto at = [&](double middle) { return middle + random.uniform(-0.5, 0.5) * side_m; };
  const std::size_t bee = flock.size();
  flock.movers.push_back({{at(offset.x), at(offset.y), at(offset.z)}, {}});
  flock.limits.push_back(limits);
  const auto is_clear = [&] {
    for (std::size_t other = 0; other < bee; ++other) {
      if (flock.ways_apart(bee, other) < static_cast<long double>(spacing_m)) return false;
    }
    return true;
  };
  if (!is_clear()) {
    flock.movers.pop_back();
    flock.limits.pop_back();
    return false;
  }
  const Velocity wish = random_velocity(random, limits.max_speed_mps);
  for (const double share : {1.0, 0.5, 0.2, 0.05}) {
    flock.movers[bee].velocity = scaled(wish, share);
    if (is_clear()) return true;
  }
  flock.movers[bee].velocity = {};
  return true;
}

// A random flock that keeps the invariant. Lengths are of the order of the threshold, so that all
// bees hinder each other.
inline Flock random_flock(std::size_t most, std::uint64_t seed) {
  scenes::RandomStream random(seed);
  Flock flock;
  const double threshold_m = log_uniform(random, 0.01, 1000.0);
  flock.options.threshold_m = threshold_m;
  flock.options.step_s = log_uniform(random, 0.01, 1.0);
  const double spacing_m = threshold_m * random.uniform(1.05, 3.0);
  const double side_m = spacing_m * std::cbrt(2.0 * static_cast<double>(most));
  const double usual_speed = log_uniform(random, 0.02, 5.0) * threshold_m / flock.options.step_s;
  const bool is_mixed = random.index(3) == 0;
  const bool at_once = random.index(3) == 0;
  const double stop_steps = log_uniform(random, 0.5, 20.0);
  Point offset;
  if (random.index(2) == 0) {
    offset = {random.uniform(-1e6, 1e6), random.uniform(-1e6, 1e6), random.uniform(-1e6, 1e6)};
  }
  for (std::size_t tries = 0; tries < 20 * most && flock.size() < most; ++tries) {
    FlightLimits limits{usual_speed,
                        at_once ? kNoLimit : usual_speed / (flock.options.step_s * stop_steps)};
    if (is_mixed) {
      limits.max_speed_mps *= random.uniform(0.1, 1.0);
      limits.max_acceleration_mps2 =
          random.index(4) == 0
              ? kNoLimit
              : limits.max_speed_mps / (flock.options.step_s * log_uniform(random, 0.5, 20.0));
    }
    add_bee(flock, limits, side_m, spacing_m, offset, random);
  }
  return flock;
}

}  // namespace beespace::test
