#include "io/recording/overlapping_files.hpp"

#include "io/recording/flat_distance.hpp"

#include <beespace/point.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::size_t kMostBetween = 16;  // fixes of one file between two of another one
constexpr double kReceivers_m = 20.0;     // so far apart are places of two receivers at one place
constexpr double kTimesAsFar = 2.0;

double apart_m(const Fix& a, const Fix& b, Frame frame) {
  return flat_distance_m(a.position, b.position, frame);
}

// How far it goes from one fix of a file to the next one, as half of them do at least.
double typical_step_m(std::span<const Fix> fixes,
                      const std::function<std::uint32_t(std::size_t)>& file_of, Frame frame) {
  struct Last {
    std::uint32_t file = 0;
    std::size_t fix = 0;
  };
  std::vector<Last> last;
  std::vector<double> steps;
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    const auto known = std::find_if(last.begin(), last.end(),
                                    [&](const Last& one) { return one.file == file_of(i); });
    if (known == last.end()) {
      if (last.size() < kMostBetween) last.push_back({file_of(i), i});
      continue;
    }
    steps.push_back(apart_m(fixes[known->fix], fixes[i], frame));
    known->fix = i;
  }
  if (steps.empty()) return 0.0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

// Where a straight line from one fix to another one is at that time.
Point between(const Fix& from, const Fix& to, double time_s) {
  const double all_s = to.time_s - from.time_s;
  const double part = all_s > 0.0 ? (time_s - from.time_s) / all_s : 0.0;
  const auto along = [part](double a, double b) { return a + part * (b - a); };
  return {along(from.position.x, to.position.x), along(from.position.y, to.position.y),
          along(from.position.z, to.position.z)};
}

}  // namespace

std::optional<FilesContradict> find_contradiction(
    std::span<const Fix> fixes, const std::function<std::uint32_t(std::size_t)>& file_of,
    Frame frame) {
  const double typical_m = typical_step_m(fixes, file_of, frame);
  const double least_m = frame == Frame::kWgs84 ? kReceivers_m : 0.0;
  std::size_t in_turn = 0;
  std::size_t apart = 0;
  std::optional<FilesContradict> first;
  for (std::size_t i = 1; i + 1 < fixes.size(); ++i) {
    const std::uint32_t other = file_of(i - 1);
    if (other == file_of(i)) continue;
    std::size_t next = i + 1;
    const std::size_t end = std::min(fixes.size(), i + kMostBetween);
    while (next < end && file_of(next) != other) ++next;
    if (next >= end) continue;
    ++in_turn;
    const Fix& before = fixes[i - 1];
    const Fix& after = fixes[next];
    const Fix expected{fixes[i].time_s, between(before, after, fixes[i].time_s)};
    const double off_m = apart_m(expected, fixes[i], frame);
    const double step_m = std::max(apart_m(before, after, frame), typical_m);
    if (off_m <= least_m || off_m <= kTimesAsFar * step_m) continue;
    ++apart;
    if (!first) first = FilesContradict{i - 1, i};
  }
  return 2 * apart >= in_turn ? first : std::nullopt;
}

}  // namespace beespace::io
