#include "analysis/recorded/least_height.hpp"

#include <algorithm>
#include <cstddef>

namespace beespace::analysis {
namespace {

// At `time_s` instead of where they are closest.
std::optional<LeastHeight> at(const Conflict& conflict, double time_s, const ApartOf& apart_of) {
  Conflict moved = conflict;
  moved.closest_s = time_s;
  const auto apart = apart_of(moved);
  if (!apart) return std::nullopt;
  return LeastHeight{time_s, *apart};
}

void take_less(std::optional<LeastHeight>& least, const std::optional<LeastHeight>& other) {
  if (!other) return;
  if (!least || other->apart.vertical_m < least->apart.vertical_m) least = other;
}

// While both fly straight: at an end, or where one passes the height of the other, which the
// middle shows, as there the difference is less than half way between those at the ends.
std::optional<LeastHeight> least_of_piece(const Conflict& conflict, double from_s, double until_s,
                                          const ApartOf& apart_of) {
  const auto first = at(conflict, from_s, apart_of);
  const auto last = at(conflict, until_s, apart_of);
  auto least = first;
  take_less(least, last);
  if (!first || !last) return least;
  const double sum_m = first->apart.vertical_m + last->apart.vertical_m;
  if (!(sum_m > 0.0)) return least;
  const double share = first->apart.vertical_m / sum_m;
  take_less(least, at(conflict, from_s + share * (until_s - from_s), apart_of));
  return least;
}

void add_times(const Track& track, const Conflict& conflict, std::vector<double>& times_s) {
  const auto after = [](double time_s, const Fix& fix) { return time_s < fix.time_s; };
  auto fix = std::upper_bound(track.fixes.begin(), track.fixes.end(), conflict.begins_s, after);
  for (; fix != track.fixes.end() && fix->time_s < conflict.ends_s; ++fix) {
    times_s.push_back(fix->time_s);
  }
}

}  // namespace

LeastHeightOf least_height_of(const std::vector<Track>& tracks, double height_unit_m) {
  return [&tracks, apart = apart_of(tracks, height_unit_m)](const Conflict& conflict) {
    std::vector<double> times_s = {conflict.begins_s, conflict.ends_s};
    add_times(tracks[conflict.first], conflict, times_s);
    add_times(tracks[conflict.second], conflict, times_s);
    std::sort(times_s.begin(), times_s.end());
    std::optional<LeastHeight> least;
    for (std::size_t i = 1; i < times_s.size(); ++i) {
      take_less(least, least_of_piece(conflict, times_s[i - 1], times_s[i], apart));
    }
    return least;
  };
}

}  // namespace beespace::analysis
