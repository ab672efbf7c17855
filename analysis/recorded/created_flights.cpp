#include "analysis/recorded/created_flights.hpp"

#include "analysis/recorded/tracks.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <cstddef>
#include <utility>

namespace beespace::analysis {
namespace {

Point flown_to(const Mover& mover, double seconds) {
  const Point& p = mover.position;
  const Velocity& v = mover.velocity;
  return {flushed(p.x + v.x * seconds), flushed(p.y + v.y * seconds), flushed(p.z + v.z * seconds)};
}

}  // namespace

std::optional<std::vector<Track>> created_flights(const io::Recording& recording,
                                                  const Snapshot& snapshot, Geometry geometry,
                                                  double horizon_s) {
  // Chords of a parallel at 70 degrees, 3 km long, leave it by less than a metre.
  constexpr double kChord_s = 10.0;
  if (!snapshot.passed_over_since_s || !snapshot.unmoving.empty()) return std::nullopt;
  std::vector<Track> flights;
  for (std::size_t i = 0; i < snapshot.movers.size(); ++i) {
    const io::RecordedBee& bee = recording.bees[snapshot.bees[i]];
    if (bee.fixes.size() != 1) return std::nullopt;
    Track flight;
    const auto add = [&](double seconds) {
      flight.fixes.push_back({seconds, flown_to(snapshot.movers[i], seconds)});
      if (snapshot.heights_m.empty()) return;
      flight.heights_m.push_back(flushed(snapshot.heights_m[i] + snapshot.climbs_mps[i] * seconds));
    };
    const double created_s = bee.fixes.front().time_s - snapshot.time_s;
    const bool round_the_earth = created_s < 0.0 && flies_round_the_earth(recording, bee);
    if (round_the_earth) {
      for (int chord = 0; chord * kChord_s < -created_s; ++chord) {
        const double by_s = chord * kChord_s;
        const auto at = flown_on(recording, bee, geometry, by_s);
        if (!at) return std::nullopt;
        flight.fixes.push_back({created_s + by_s, at->position});
        if (!snapshot.heights_m.empty()) flight.heights_m.push_back(at->height_m);
      }
    }
    add(round_the_earth ? 0.0 : created_s);
    if (horizon_s > created_s) add(horizon_s);
    flights.push_back(std::move(flight));
  }
  return flights;
}

}  // namespace beespace::analysis
