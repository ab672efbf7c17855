// Whether a domain is crowded enough for searches that take whole boxes of points at once, or whole
// rows of pairs.
#pragma once

#include "search/search_domain.hpp"
#include "search/tuning_overrides.hpp"

#include <algorithm>

namespace beespace::search {

// Whether a cube of the threshold holds more than `enough` others, seen from a point's place.
inline bool is_crowded(const SearchDomain& domain, double threshold_m, double enough,
                       const TuningOverrides& tuning) {
  if (domain.points().empty() || domain.others().empty()) return false;
  if (tuning.crowds != TuningOverrides::Crowds::kAutomatic) {
    return tuning.crowds == TuningOverrides::Crowds::kAlways;
  }
  return domain.expected_neighbors(threshold_m) > enough;
}

// Whether points share their places so often that it pays to look at each place once.
inline bool has_duplicates(const SearchDomain& domain, double threshold_m) {
  constexpr double kTwinCells = 0x1p-40;  // of all that matters: so close are only twins
  const double widest = domain.widest() > 0.0 ? domain.widest() : threshold_m;
  return domain.expected_neighbors(std::min(widest, threshold_m) * kTwinCells) > 1.0;
}

}  // namespace beespace::search
