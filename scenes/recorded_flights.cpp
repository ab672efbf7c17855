#include "scenes/recorded_flights.hpp"

#include "scenes/random_stream.hpp"
#include "scenes/random_velocity.hpp"

#include <utility>

namespace beespace::scenes {
namespace {

// A stream for each bee: what one of them draws changes nothing for the others. Not the stream that
// a scene of the same seed was drawn from.
RandomStream stream_of(PointId bee, std::uint64_t seed) {
  return RandomStream(RandomStream(~seed).bits() + bee);
}

std::vector<double> draw_times(const FixTimes& times, RandomStream& random) {
  constexpr double kMostEarly = 0.375;
  // The last but one leaves some time for the last: the speed between two fixes that are an instant
  // apart would be made of rounding errors.
  const double until_s = times.duration_s - 0.25 * times.interval_s;
  std::vector<double> drawn{0.0};
  for (double count = 1.0;; count += 1.0) {
    const double shift = times.regular ? 0.0 : random.uniform(-kMostEarly, kMostEarly);
    const double time_s = times.interval_s * (count + shift);
    if (time_s > until_s) break;
    drawn.push_back(time_s);
  }
  drawn.push_back(times.duration_s);
  return drawn;
}

Point after(const Point& p, const Velocity& v, double seconds) {
  return {p.x + v.x * seconds, p.y + v.y * seconds, p.z + v.z * seconds};
}

}  // namespace

Track fly(const Mover& mover, PointId bee, const FixTimes& times, std::uint64_t seed) {
  RandomStream random = stream_of(bee, seed);
  Track track;
  for (const double time_s : draw_times(times, random)) {
    track.fixes.push_back({time_s, after(mover.position, mover.velocity, time_s)});
  }
  return track;
}

std::vector<Track> fly(const std::vector<Mover>& movers, const FixTimes& times,
                       std::uint64_t seed) {
  std::vector<Track> tracks;
  tracks.reserve(movers.size());
  for (const Mover& mover : movers) {
    tracks.push_back(fly(mover, static_cast<PointId>(tracks.size()), times, seed));
  }
  return tracks;
}

std::vector<Track> random_turns(std::size_t count, const Point& size, const Speeds& speeds,
                                const FixTimes& times, std::uint64_t seed) {
  const std::vector<Mover> starts = random_flight(count, size, speeds, seed);
  std::vector<Track> tracks;
  tracks.reserve(count);
  for (const Mover& start : starts) {
    RandomStream random = stream_of(static_cast<PointId>(tracks.size()), seed);
    Track track;
    Mover now = start;
    for (const double time_s : draw_times(times, random)) {
      if (!track.fixes.empty()) {
        const double lasts_s = time_s - track.fixes.back().time_s;
        now.position = after(now.position, now.velocity, lasts_s);
        now.velocity = random_velocity(speeds, random);
      }
      track.fixes.push_back({time_s, now.position});
    }
    tracks.push_back(std::move(track));
  }
  return tracks;
}

}  // namespace beespace::scenes
