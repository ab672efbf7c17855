#include "analysis/recorded/take_off_offset.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace beespace::analysis {
namespace {

constexpr double kMostSpread_s = 1.0;
// Who is that low has landed; who stays a little higher for long has, too, as heights by pressure
// wander.
constexpr double kLanded_m = 1.0;
constexpr double kNearlyLanded_m = 3.0;
constexpr double kLandedFor_s = 10.0;
constexpr double kNever_s = std::numeric_limits<double>::infinity();

// When it takes off, straight on between two fixes, and again after each landing.
std::vector<double> take_offs_of(std::span<const Fix> fixes) {
  std::vector<double> take_offs;
  if (fixes.empty()) return take_offs;
  double ground_m = fixes.front().position.z;
  bool flies = false;
  double low_since_s = kNever_s;
  for (std::size_t i = 1; i < fixes.size(); ++i) {
    const Fix& from = fixes[i - 1];
    const Fix& to = fixes[i];
    const double above_m = to.position.z - ground_m;
    if (!flies) {
      if (above_m >= kTakenOff_m) {
        const double wanted_m = ground_m + kTakenOff_m;
        const double share = (wanted_m - from.position.z) / (to.position.z - from.position.z);
        take_offs.push_back(from.time_s + share * (to.time_s - from.time_s));
        flies = true;
      } else if (!take_offs.empty()) {
        ground_m = std::min(ground_m, to.position.z);
      }
      continue;
    }
    if (above_m >= kNearlyLanded_m) {
      low_since_s = kNever_s;
      continue;
    }
    low_since_s = std::min(low_since_s, to.time_s);
    // The beginning of a slow climb is no landing: it has been high before.
    const bool was_high = to.time_s - take_offs.back() > kLandedFor_s;
    if (was_high && (above_m < kLanded_m || to.time_s - low_since_s > kLandedFor_s)) {
      flies = false;
      low_since_s = kNever_s;
      ground_m = to.position.z;
    }
  }
  return take_offs;
}

// What the take-offs of one bee say, but for those that were set beside the first one.
void add_offsets(const SetAndFlownFixes& bee, std::vector<double>& offsets) {
  const std::vector<double> set_s = take_offs_of(bee.set);
  if (set_s.empty()) return;
  std::optional<double> flight_s;
  for (const double flown_s : take_offs_of(bee.flown)) {
    const bool was_set = flight_s && std::any_of(set_s.begin(), set_s.end(), [&](double one_s) {
                           return std::abs(flown_s - (*flight_s + one_s)) <= 2.0 * kMostSpread_s;
                         });
    if (was_set) continue;
    flight_s = flown_s - set_s.front();
    offsets.push_back(*flight_s);
  }
}

// The middle of some in ascending order, where the middle half of them agree.
std::optional<TakeOffOffset> middle_of(std::span<const double> offsets) {
  const std::size_t last = offsets.size() - 1;
  if (offsets[last - last / 4] - offsets[last / 4] > kMostSpread_s) return std::nullopt;
  return TakeOffOffset{offsets[last / 2], offsets.size()};
}

}  // namespace

std::optional<double> first_take_off_s(std::span<const Fix> fixes) {
  const std::vector<double> take_offs = take_offs_of(fixes);
  return take_offs.empty() ? std::nullopt : std::optional(take_offs.front());
}

std::vector<TakeOffOffset> take_off_offsets(const std::vector<SetAndFlownFixes>& bees) {
  std::vector<double> offsets;
  for (const SetAndFlownFixes& bee : bees) {
    if (bee.from_ground) add_offsets(bee, offsets);
  }
  std::sort(offsets.begin(), offsets.end());
  std::vector<TakeOffOffset> flights;
  for (std::size_t from = 0; from < offsets.size();) {
    std::size_t to = from + 1;
    while (to < offsets.size() && offsets[to] - offsets[to - 1] <= kMostSpread_s) ++to;
    const auto flight = middle_of(std::span(offsets).subspan(from, to - from));
    if (flight && 2 * flight->bees > bees.size()) flights.push_back(*flight);
    from = to;
  }
  return flights;
}

}  // namespace beespace::analysis
