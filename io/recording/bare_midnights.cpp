#include "io/recording/bare_midnights.hpp"

#include <beespace/track.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace beespace::io {
namespace {

// How long after each other most fixes come; 0 where there are too few to tell.
double usual_step_s(const std::vector<Fix>& fixes) {
  constexpr std::size_t kFewestFixes = 3;
  if (fixes.size() < kFewestFixes) return 0.0;
  std::vector<double> steps;
  steps.reserve(fixes.size() - 1);
  for (std::size_t i = 1; i < fixes.size(); ++i) {
    steps.push_back(fixes[i].time_s - fixes[i - 1].time_s);
  }
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

// Whether the fix of that time comes a usual step after the one before, or before the next one.
bool is_in_step(const std::vector<Fix>& fixes, double step_s, double time_s) {
  constexpr double kDiffers = 0.02;   // receivers need some time to find their place
  constexpr double kAtLeast_s = 1.0;  // times are rounded
  const auto at =
      std::lower_bound(fixes.begin(), fixes.end(), time_s,
                       [](const Fix& fix, double wanted_s) { return fix.time_s < wanted_s; });
  if (at == fixes.end() || at->time_s != time_s) return true;  // it is left out
  const auto is_step = [&](double seconds) {
    return std::abs(seconds - step_s) <= std::max(kDiffers * step_s, kAtLeast_s);
  };
  return (at != fixes.begin() && is_step(time_s - std::prev(at)->time_s)) ||
         (std::next(at) != fixes.end() && is_step(std::next(at)->time_s - time_s));
}

}  // namespace

std::optional<BareMidnights::Doubt> BareMidnights::doubt(const TrackGathering& tracks) const {
  if (taken_.empty()) return std::nullopt;
  if (written_) return Doubt{taken_.front().origin, "other midnights are written as 00:00:00"};
  struct Bee {
    std::size_t number;
    double step_s;
  };
  std::unordered_map<std::string_view, Bee> bees;
  for (std::size_t i = 0; i < tracks.size(); ++i) bees.try_emplace(tracks.id(i), Bee{i, -1.0});
  for (const Taken& taken : taken_) {
    const auto found = bees.find(taken.id);
    if (found == bees.end()) continue;
    Bee& bee = found->second;
    const std::vector<Fix>& fixes = tracks.recorded(bee.number).fixes;
    if (bee.step_s < 0.0) bee.step_s = usual_step_s(fixes);
    if (bee.step_s > 0.0 && is_in_step(fixes, bee.step_s, taken.time_s)) continue;
    return Doubt{taken.origin, "at midnight it would not come in step with the records beside it"};
  }
  return std::nullopt;
}

}  // namespace beespace::io
