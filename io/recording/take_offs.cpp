#include "io/recording/take_offs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace beespace::io {

void TakeOffs::take(std::string_view id, double time_s, const TakeOffSaid& said) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const auto [at, added] =
      told_.try_emplace(std::string(id), Told{time_s, said.ground_m, kNone, -kNone});
  Told& told = at->second;
  if (time_s < told.first_s) {
    told.first_s = time_s;
    told.ground_m = said.ground_m;
  }
  told.flies = told.flies || said.flies;
  if (!said.ground_m) return;
  told.least_m = std::min(told.least_m, *said.ground_m);
  told.greatest_m = std::max(told.greatest_m, *said.ground_m);
}

bool TakeOffs::is_believed(const Told& told) {
  return told.ground_m && told.greatest_m - told.least_m <= kTakeOffWavers_m;
}

// The middle of those that have flown.
std::optional<double> TakeOffs::usual_m() const {
  std::vector<double> grounds;
  for (const auto& [id, told] : told_) {
    if (told.flies && is_believed(told)) grounds.push_back(*told.ground_m);
  }
  if (grounds.empty()) return std::nullopt;
  const auto middle = grounds.begin() + static_cast<std::ptrdiff_t>(grounds.size() / 2);
  std::nth_element(grounds.begin(), middle, grounds.end());
  return *middle;
}

std::optional<double> TakeOffs::of(const std::string& id) const {
  const auto found = told_.find(id);
  if (found == told_.end() || !is_believed(found->second)) return std::nullopt;
  if (found->second.flies) return found->second.ground_m;
  const auto usual = usual_m();
  const bool among_them = usual && std::abs(*found->second.ground_m - *usual) <= kTakeOffWavers_m;
  return among_them ? found->second.ground_m : std::nullopt;
}

}  // namespace beespace::io
