// Generated recordings: what a logger would have written down of bees that fly.
//
// The same arguments give the same doubles on every machine. Values are returned; nothing is kept.
// Units: metres, seconds, metres per second. Cost: some 10 nanoseconds a fix.
#pragma once

#include "scenes/moving_scenes.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace beespace::scenes {

// When fixes are taken: at 0, at duration_s, and in between about every interval_s. Both are above
// zero. Irregular ones are each up to 3/8 of the interval early or late, every bee's otherwise.
// Two fixes of a bee are never closer than a quarter of the interval, unless the duration is
// shorter than that, and never farther apart than two intervals.
struct FixTimes {
  double duration_s;
  double interval_s;
  bool regular = false;
};

// The track of bee number `bee`, and those of all: from where they are at time 0 straight on. Each
// fix is computed from there, so that no errors add up. What the seed changes is the fix times.
Track fly(const Mover& mover, PointId bee, const FixTimes& times, std::uint64_t seed = 1);
std::vector<Track> fly(const std::vector<Mover>& movers, const FixTimes& times,
                       std::uint64_t seed = 1);

// Bees that are uniform in the box from the origin to `size` at time 0, and take another random
// direction and speed at every fix. They may leave the box.
std::vector<Track> random_turns(std::size_t count, const Point& size, const Speeds& speeds,
                                const FixTimes& times, std::uint64_t seed);

}  // namespace beespace::scenes
