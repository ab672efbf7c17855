// Where the times of one bee go back, of fixes that are all there.
#include "io/recording/flat_distance.hpp"
#include "io/recording/restarted_clock.hpp"

#include <beespace/point.hpp>

#include <algorithm>

namespace beespace::io {
namespace {

using FixSpan = std::span<const Fix>;

// Of fixes in the order of time, those from one time to another.
FixSpan within(FixSpan fixes, double from_s, double until_s) {
  const auto begin =
      std::lower_bound(fixes.begin(), fixes.end(), from_s,
                       [](const Fix& fix, double time_s) { return fix.time_s < time_s; });
  const auto end = std::upper_bound(begin, fixes.end(), until_s, [](double time_s, const Fix& fix) {
    return time_s < fix.time_s;
  });
  return {begin, end};
}

// How many of the second are not where the first leads, and how many are there just the same.
struct RunsCompared {
  std::size_t apart = 0;
  std::size_t same = 0;
};

RunsCompared compare_runs(FixSpan first, FixSpan second, Frame frame) {
  RunsCompared found;
  for (const Fix& fix : second) {
    const auto after =
        std::lower_bound(first.begin(), first.end(), fix.time_s,
                         [](const Fix& other, double time_s) { return other.time_s < time_s; });
    if (after == first.end()) continue;
    const GoesWithRun goes =
        goes_with(after == first.begin() ? *after : *(after - 1), *after, fix, frame);
    if (goes == GoesWithRun::kIsTheSame) ++found.same;
    if (goes == GoesWithRun::kIsApart) ++found.apart;
  }
  return found;
}

// Where each run of times begins that does not go back; nothing of a bee that is in no order.
std::vector<std::size_t> runs_of(FixSpan fixes) {
  std::vector<std::size_t> begins{0};
  for (std::size_t i = 1; i < fixes.size(); ++i) {
    if (fixes[i].time_s < fixes[i - 1].time_s) begins.push_back(i);
  }
  if (kLongRuns * (begins.size() - 1) > fixes.size()) return {};
  return begins;
}

// The first run that goes through times of the one before it.
std::optional<ClockCut> first_cut(FixSpan fixes, std::span<const Origin> origins, Frame frame) {
  const std::vector<std::size_t> begins = runs_of(fixes);
  for (std::size_t i = 1; i < begins.size(); ++i) {
    const std::size_t at = begins[i];
    const std::size_t end = i + 1 < begins.size() ? begins[i + 1] : fixes.size();
    const FixSpan first = fixes.subspan(begins[i - 1], at - begins[i - 1]);
    const FixSpan second = fixes.subspan(at, end - at);
    const double from_s = std::max(first.front().time_s, second.front().time_s);
    const double until_s = std::min(first.back().time_s, second.back().time_s);
    if (!(from_s < until_s)) continue;
    const FixSpan of_both = within(second, from_s, until_s);
    const std::size_t in_first = within(first, from_s, until_s).size();
    if (std::min(in_first, of_both.size()) < kFewestOfBothRuns) continue;
    const RunsCompared places = compare_runs(first, of_both, frame);
    const bool repeated = 2 * places.same > of_both.size();
    return ClockCut{origins[at - 1],  origins[at], fixes[at - 1].time_s,
                    fixes[at].time_s, repeated,    !repeated && 2 * places.apart >= of_both.size()};
  }
  return std::nullopt;
}

}  // namespace

GoesWithRun goes_with(const Fix& from, const Fix& to, const Fix& fix, Frame frame) {
  constexpr double kOfAStep = 0.1;
  constexpr double kTwoReceivers_m = 20.0;  // so far apart are places of two receivers at one place
  const double least_m = frame == Frame::kWgs84 ? kTwoReceivers_m : 0.0;
  if (to == fix) return GoesWithRun::kIsTheSame;
  const double lasts_s = to.time_s - from.time_s;
  const double share = lasts_s > 0.0 ? (fix.time_s - from.time_s) / lasts_s : 1.0;
  const auto along = [share](double a, double b) { return a + share * (b - a); };
  const Point led{along(from.position.x, to.position.x), along(from.position.y, to.position.y),
                  along(from.position.z, to.position.z)};
  const double step_m = flat_distance_m(from.position, to.position, frame);
  const double off_m = flat_distance_m(led, fix.position, frame);
  const bool apart = off_m > least_m && off_m > kOfAStep * step_m;
  return apart ? GoesWithRun::kIsApart : GoesWithRun::kIsNear;
}

BeeClock clock_of(FixSpan fixes, std::span<const Origin> origins, Frame frame) {
  return {origins.front(), origins.back(), fixes.size(), first_cut(fixes, origins, frame)};
}

}  // namespace beespace::io
