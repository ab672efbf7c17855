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
                                                  const Snapshot& snapshot, double horizon_s) {
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
    add(created_s);
    if (horizon_s > created_s) add(horizon_s);
    flights.push_back(std::move(flight));
  }
  return flights;
}

}  // namespace beespace::analysis
