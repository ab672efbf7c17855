#include "analysis/recorded/take_off_offset.hpp"

#include <algorithm>

namespace beespace::analysis {
namespace {

constexpr double kMostSpread_s = 1.0;

// When it is first kTakenOff_m above its first fix, straight on between two.
std::optional<double> taken_off_s(const std::vector<Fix>& fixes) {
  for (std::size_t i = 1; i < fixes.size(); ++i) {
    const double wanted_m = fixes.front().position.z + kTakenOff_m;
    const Fix& from = fixes[i - 1];
    const Fix& to = fixes[i];
    if (!(to.position.z >= wanted_m)) continue;
    const double share = (wanted_m - from.position.z) / (to.position.z - from.position.z);
    return from.time_s + share * (to.time_s - from.time_s);
  }
  return std::nullopt;
}

}  // namespace

std::optional<TakeOffOffset> take_off_offset(const std::vector<SetAndFlownFixes>& bees) {
  std::vector<double> offsets;
  for (const SetAndFlownFixes& bee : bees) {
    const auto set_s = taken_off_s(bee.set);
    const auto flown_s = taken_off_s(bee.flown);
    if (set_s && flown_s) offsets.push_back(*flown_s - *set_s);
  }
  if (offsets.empty()) return std::nullopt;
  std::sort(offsets.begin(), offsets.end());
  const std::size_t last = offsets.size() - 1;
  if (offsets[last - last / 4] - offsets[last / 4] > kMostSpread_s) return std::nullopt;
  return TakeOffOffset{offsets[last / 2], offsets.size()};
}

}  // namespace beespace::analysis
