#include "analysis/recorded/apart.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>

namespace beespace::analysis {
namespace {

// A height at a time between two fixes; as position_at() has the place.
std::optional<double> height_at(const Track& track, double time_s) {
  const auto after =
      std::lower_bound(track.fixes.begin(), track.fixes.end(), time_s,
                       [](const Fix& fix, double time) { return fix.time_s < time; });
  if (after == track.fixes.end()) return std::nullopt;
  const auto place = static_cast<std::size_t>(after - track.fixes.begin());
  if (after->time_s == time_s) return track.heights_m[place];
  if (place == 0) return std::nullopt;
  const double from_s = track.fixes[place - 1].time_s;
  const double share = (time_s - from_s) / (after->time_s - from_s);
  const double from = track.heights_m[place - 1];
  return from + share * (track.heights_m[place] - from);
}

Point flown(const Mover& mover, double seconds) {
  const Point& p = mover.position;
  const Velocity& v = mover.velocity;
  return {p.x + v.x * seconds, p.y + v.y * seconds, p.z + v.z * seconds};
}

}  // namespace

std::optional<Whereabouts> whereabouts_at(const Track& track, double time_s) {
  const auto place = position_at(track, time_s);
  if (!place) return std::nullopt;
  if (track.heights_m.empty()) return Whereabouts{*place, std::nullopt};
  return Whereabouts{*place, height_at(track, time_s)};
}

Apart apart(const Whereabouts& a, const Whereabouts& b, double height_unit_m) {
  if (!a.height || !b.height) return apart(a.place, b.place);
  return apart(a.place, *a.height, b.place, *b.height, height_unit_m);
}

std::optional<double> common_instant(const Track& a, const Track& b, double time_s) {
  if (a.fixes.empty() || b.fixes.empty()) return std::nullopt;
  const double from_s = std::max(a.fixes.front().time_s, b.fixes.front().time_s);
  const double until_s = std::min(a.fixes.back().time_s, b.fixes.back().time_s);
  if (from_s > until_s) return std::nullopt;
  return std::clamp(time_s, from_s, until_s);
}

std::optional<Apart> apart_at(const Track& a, const Track& b, double time_s, double height_unit_m) {
  const auto instant_s = common_instant(a, b, time_s);
  if (!instant_s) return std::nullopt;
  const auto of_a = whereabouts_at(a, *instant_s);
  const auto of_b = whereabouts_at(b, *instant_s);
  if (!of_a || !of_b) return std::nullopt;
  return apart(*of_a, *of_b, height_unit_m);
}

ApartOf apart_of(const std::vector<Track>& tracks, double height_unit_m) {
  return [&tracks, height_unit_m](const Conflict& conflict) {
    return apart_at(tracks[conflict.first], tracks[conflict.second], conflict.closest_s,
                    height_unit_m);
  };
}

ApartOf apart_of(const Snapshot& snapshot, double height_unit_m) {
  std::unordered_map<std::uint32_t, std::size_t> places;
  Snapshot all = snapshot.present();
  for (std::size_t i = 0; i < all.bees.size(); ++i) places.emplace(all.bees[i], i);
  return [all = std::move(all), places = std::move(places),
          height_unit_m](const Conflict& conflict) -> std::optional<Apart> {
    const auto first = places.find(conflict.first);
    const auto second = places.find(conflict.second);
    if (first == places.end() || second == places.end()) return std::nullopt;
    const std::size_t a = first->second;
    const std::size_t b = second->second;
    const double seconds = conflict.closest_s - all.time_s;
    const Point place_a = flown(all.movers[a], seconds);
    const Point place_b = flown(all.movers[b], seconds);
    if (all.heights_m.empty()) return apart(place_a, place_b);
    return apart(place_a, all.heights_m[a] + all.climbs_mps[a] * seconds, place_b,
                 all.heights_m[b] + all.climbs_mps[b] * seconds, height_unit_m);
  };
}

}  // namespace beespace::analysis
