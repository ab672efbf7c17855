#include "io/recording/restarted_clock.hpp"

#include "io/recording/flat_distance.hpp"

#include <beespace/point.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace beespace::io {
namespace {

using FixSpan = std::span<const Fix>;

constexpr std::ptrdiff_t kFewestOfBoth = 3;  // fixes of either run within the times of both

bool comes_before(const Origin& a, const Origin& b) {
  return a.source != b.source ? a.source < b.source : a.line < b.line;
}

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
  constexpr double kOfAStep = 0.1;
  constexpr double kTwoReceivers_m = 20.0;  // so far apart are places of two receivers at one place
  const double least_m = frame == Frame::kWgs84 ? kTwoReceivers_m : 0.0;
  RunsCompared found;
  for (const Fix& fix : second) {
    const auto after =
        std::lower_bound(first.begin(), first.end(), fix.time_s,
                         [](const Fix& other, double time_s) { return other.time_s < time_s; });
    if (after == first.end()) continue;
    if (*after == fix) {
      ++found.same;
      continue;
    }
    const Fix& to = *after;
    const Fix& from = after == first.begin() ? to : *(after - 1);
    const double lasts_s = to.time_s - from.time_s;
    const double share = lasts_s > 0.0 ? (fix.time_s - from.time_s) / lasts_s : 1.0;
    const auto along = [share](double a, double b) { return a + share * (b - a); };
    const Point led{along(from.position.x, to.position.x), along(from.position.y, to.position.y),
                    along(from.position.z, to.position.z)};
    const double step_m = flat_distance_m(from.position, to.position, frame);
    const double off_m = flat_distance_m(led, fix.position, frame);
    if (off_m > least_m && off_m > kOfAStep * step_m) ++found.apart;
  }
  return found;
}

struct ClockCut {
  std::size_t bee = 0;
  std::size_t at = 0;     // the first fix after it
  bool repeated = false;  // most of it was there before, just the same
  bool apart = false;     // most places after it do not go with those before
};

// Where each run of times begins that does not go back; nothing of a bee that is in no order.
std::vector<std::size_t> runs_of(FixSpan fixes) {
  constexpr std::size_t kLongRuns = 8;  // fixes a run, on average
  std::vector<std::size_t> begins{0};
  for (std::size_t i = 1; i < fixes.size(); ++i) {
    if (fixes[i].time_s < fixes[i - 1].time_s) begins.push_back(i);
  }
  if (kLongRuns * (begins.size() - 1) > fixes.size()) return {};
  return begins;
}

// The first run that goes through times of the one before it.
std::optional<ClockCut> first_cut(std::size_t bee, FixSpan fixes, Frame frame) {
  const std::vector<std::size_t> begins = runs_of(fixes);
  for (std::size_t i = 1; i < begins.size(); ++i) {
    const std::size_t end = i + 1 < begins.size() ? begins[i + 1] : fixes.size();
    const FixSpan first = fixes.subspan(begins[i - 1], begins[i] - begins[i - 1]);
    const FixSpan second = fixes.subspan(begins[i], end - begins[i]);
    const double from_s = std::max(first.front().time_s, second.front().time_s);
    const double until_s = std::min(first.back().time_s, second.back().time_s);
    if (!(from_s < until_s)) continue;
    const FixSpan of_both = within(second, from_s, until_s);
    const auto in_first = static_cast<std::ptrdiff_t>(within(first, from_s, until_s).size());
    const auto in_second = static_cast<std::ptrdiff_t>(of_both.size());
    if (std::min(in_first, in_second) < kFewestOfBoth) continue;
    const RunsCompared places = compare_runs(first, of_both, frame);
    const bool repeated = 2 * places.same > of_both.size();
    return ClockCut{bee, begins[i], repeated, !repeated && 2 * places.apart >= of_both.size()};
  }
  return std::nullopt;
}

}  // namespace

std::optional<RestartedClock> restarted_clock(const std::vector<InInputOrder>& bees, Frame frame) {
  constexpr std::size_t kSeveral = 2;  // one by itself may have been brought into no order
  std::vector<ClockCut> cuts;
  for (std::size_t bee = 0; bee < bees.size(); ++bee) {
    if (const auto cut = first_cut(bee, bees[bee].fixes, frame)) cuts.push_back(*cut);
  }
  if (cuts.size() < kSeveral) return std::nullopt;
  const auto after = [&bees](const ClockCut& cut) { return bees[cut.bee].origins[cut.at]; };
  const auto before = [&bees](const ClockCut& cut) { return bees[cut.bee].origins[cut.at - 1]; };
  const ClockCut& earliest = *std::min_element(
      cuts.begin(), cuts.end(),
      [&after](const ClockCut& a, const ClockCut& b) { return comes_before(after(a), after(b)); });
  const Origin begins = after(earliest);
  RestartedClock found{before(earliest), begins, 0.0, 0.0, 0};
  found.from_s = bees[earliest.bee].fixes[earliest.at - 1].time_s;
  found.to_s = bees[earliest.bee].fixes[earliest.at].time_s;
  std::size_t apart = 0;
  std::size_t repeated = 0;
  for (const ClockCut& cut : cuts) {
    if (!comes_before(before(cut), begins)) continue;
    ++found.bees;
    if (cut.apart) ++apart;
    if (cut.repeated) ++repeated;
    if (comes_before(found.before, before(cut))) found.before = before(cut);
  }
  // All who are there on either side, and not only some.
  const auto both_sides = std::count_if(bees.begin(), bees.end(), [&](const InInputOrder& bee) {
    return !bee.origins.empty() && comes_before(bee.origins.front(), begins) &&
           !comes_before(bee.origins.back(), begins);
  });
  if (found.bees < kSeveral || found.bees < static_cast<std::size_t>(both_sides)) {
    return std::nullopt;
  }
  if (repeated == found.bees) return std::nullopt;  // written twice
  const bool of_two_files = found.before.source != begins.source;
  if (of_two_files && 2 * apart < found.bees - repeated) return std::nullopt;
  return found;
}

}  // namespace beespace::io
