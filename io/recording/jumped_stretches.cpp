#include "io/recording/jumped_stretches.hpp"

#include "io/recording/excursions.hpp"
#include "io/recording/jumps.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace beespace::io {
namespace {

constexpr double kLongestSpike_s = 60.0;

const Velocity* velocity_at(const RecordedBee& bee, std::size_t fix) {
  return bee.velocities.empty() ? nullptr : &bee.velocities[fix];
}

// To which of its fixes it jumps.
std::vector<std::size_t> jumps_of(const RecordedBee& bee, Frame frame) {
  std::vector<std::size_t> found;
  Jumps jumps(bee.fixes, bee.velocities, frame);
  for (std::size_t i = 0; i < bee.fixes.size(); ++i) {
    if (jumps.take(bee.fixes[i], velocity_at(bee, i), frame)) found.push_back(i);
  }
  return found;
}

// With which of the next jumps it comes back to where it can have got from before jump `out`.
// `out` itself where there is none.
std::size_t way_back(const RecordedBee& bee, Frame frame, const std::vector<std::size_t>& jumps,
                     std::size_t out) {
  constexpr std::size_t kMostBetween = 8;
  const std::size_t before = jumps[out] - 1;
  Jumps from(bee.fixes, bee.velocities, frame);
  from.take(bee.fixes[before], velocity_at(bee, before), frame);
  const std::size_t end = std::min(jumps.size(), out + 1 + kMostBetween);
  for (std::size_t i = out + 1; i < end; ++i) {
    const std::size_t fix = jumps[i];
    if (!from.jumps_to(bee.fixes[fix], velocity_at(bee, fix), frame)) return i;
  }
  return out;
}

std::vector<Excursion> excursions_of(const RecordedBee& bee, const JumpsOf& of) {
  return of.aircraft ? std::vector<Excursion>() : excursions(bee.fixes, of.frame);
}

// Those that begin within another one are part of it.
std::vector<JumpedStretch> joined(std::vector<JumpedStretch> some) {
  std::sort(some.begin(), some.end(), [](const JumpedStretch& a, const JumpedStretch& b) {
    return std::tie(a.before, b.behind) < std::tie(b.before, a.behind);
  });
  std::vector<JumpedStretch> joined;
  for (const JumpedStretch& stretch : some) {
    if (joined.empty() || stretch.before >= joined.back().behind) {
      joined.push_back(stretch);
      continue;
    }
    if (stretch.behind <= joined.back().behind) continue;
    joined.back().behind = stretch.behind;
    joined.back().comes_back = joined.back().comes_back && stretch.comes_back;
  }
  return joined;
}

}  // namespace

std::vector<JumpedStretch> jumped_stretches(const RecordedBee& bee, const JumpsOf& of) {
  const std::vector<std::size_t> jumps = jumps_of(bee, of.frame);
  std::vector<JumpedStretch> stretches;
  for (std::size_t i = 0; i < jumps.size(); ++i) {
    const std::size_t back = way_back(bee, of.frame, jumps, i);
    stretches.push_back({jumps[i] - 1, jumps[back], back > i});
    i = back;
  }
  const std::vector<Excursion> away = excursions_of(bee, of);
  if (away.empty()) return stretches;
  for (const Excursion& excursion : away) {
    stretches.push_back({excursion.before, excursion.behind, true});
  }
  return joined(std::move(stretches));
}

std::optional<std::size_t> first_jump(const RecordedBee& bee, const JumpsOf& of) {
  const std::vector<std::size_t> jumps = jumps_of(bee, of.frame);
  const std::vector<Excursion> away = excursions_of(bee, of);
  std::optional<std::size_t> first;
  if (!jumps.empty()) first = jumps.front();
  if (!away.empty()) first = std::min(first.value_or(bee.fixes.size()), away.front().before + 1);
  return first;
}

std::vector<TimeSpan> jumping_legs(const RecordedBee& bee, const JumpsOf& of) {
  std::vector<std::size_t> jumps = jumps_of(bee, of.frame);
  for (const Excursion& excursion : excursions_of(bee, of)) {
    jumps.insert(jumps.end(), excursion.leaps.begin(), excursion.leaps.end());
  }
  std::sort(jumps.begin(), jumps.end());
  jumps.erase(std::unique(jumps.begin(), jumps.end()), jumps.end());
  std::vector<TimeSpan> legs;
  legs.reserve(jumps.size());
  for (const std::size_t to : jumps) {
    legs.push_back({bee.fixes[to - 1].time_s, bee.fixes[to].time_s});
  }
  return legs;
}

bool is_spike(const RecordedBee& bee, const JumpedStretch& stretch) {
  return stretch.comes_back &&
         bee.fixes[stretch.behind].time_s - bee.fixes[stretch.before].time_s <= kLongestSpike_s;
}

std::vector<bool> fixes_in_spikes(const RecordedBee& bee, const JumpsOf& of) {
  std::vector<bool> in_spikes;
  for (const JumpedStretch& stretch : jumped_stretches(bee, of)) {
    if (!is_spike(bee, stretch)) continue;
    in_spikes.resize(bee.fixes.size(), false);
    for (std::size_t i = stretch.before + 1; i < stretch.behind; ++i) in_spikes[i] = true;
  }
  return in_spikes;
}

}  // namespace beespace::io
