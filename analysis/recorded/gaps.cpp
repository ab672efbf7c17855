#include "analysis/recorded/gaps.hpp"

#include "analysis/recorded/own_gaps.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

namespace beespace::analysis {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// Of an even number the lower one of the two in the middle. Reorders the numbers, of which there
// are some.
double lower_median(std::vector<double>& numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>((numbers.size() - 1) / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

std::optional<double> typical_interval(const std::vector<BeeInterval>& bees) {
  std::vector<double> of_bees;
  std::vector<double> of_bees_that_can_tell;
  for (const BeeInterval& bee : bees) {
    if (bee.fixes < 2) continue;
    of_bees.push_back(bee.median_s);
    if (bee.fixes >= kFixesToTell) of_bees_that_can_tell.push_back(bee.median_s);
  }
  if (!of_bees_that_can_tell.empty()) return lower_median(of_bees_that_can_tell);
  if (of_bees.empty()) return std::nullopt;
  return lower_median(of_bees);
}

double with_three_digits(double value) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, 2);
  double rounded = value;
  std::from_chars(text, end.ptr, rounded);
  return rounded;
}

}  // namespace

BeeInterval interval_of(const io::RecordedBee& bee) {
  if (bee.fixes.size() < 2) return {bee.fixes.size(), 0.0};
  std::vector<double> intervals;
  intervals.reserve(bee.fixes.size() - 1);
  for (std::size_t i = 1; i < bee.fixes.size(); ++i) {
    intervals.push_back(bee.fixes[i].time_s - bee.fixes[i - 1].time_s);
  }
  return {bee.fixes.size(), lower_median(intervals)};
}

double max_gap_for(double interval_s) {
  return with_three_digits(kGapFactor * interval_s);
}

double max_gap_just_for(double interval_s) {
  constexpr double kMore = 1.1;
  constexpr double kLong_s = 20.0;
  const double step_s = interval_s > kLong_s ? 5.0 : 1.0;
  return std::ceil(kMore * interval_s / step_s) * step_s;
}

MaxGap max_gap_of(const io::Recording& recording, const std::optional<double>& asked) {
  std::vector<BeeInterval> intervals;
  intervals.reserve(recording.bees.size());
  for (const io::RecordedBee& bee : recording.bees) {
    // How often each of two reports is not told by the times of both.
    intervals.push_back(bee.shared ? BeeInterval{} : interval_of(bee));
  }
  const bool known =
      std::any_of(intervals.begin(), intervals.end(), [](const auto& of) { return of.fixes > 1; });
  if (!known) {
    std::transform(recording.bees.begin(), recording.bees.end(), intervals.begin(), interval_of);
  }
  return max_gap_of(intervals, asked);
}

MaxGap max_gap_of(const std::vector<BeeInterval>& bees, const std::optional<double>& asked) {
  const auto typical_s = typical_interval(bees);
  const double interval_s = typical_s ? with_three_digits(*typical_s) : 0.0;
  if (asked) return {*asked, std::nullopt, true, interval_s};
  if (!typical_s) return {kNever, std::nullopt};
  return {max_gap_for(*typical_s), interval_s, false, interval_s};
}

std::optional<Gap> longest_bridged(const io::Recording& recording, const MaxGap& max_gap) {
  constexpr double kUnusual = 2.0;
  if (recording.show || recording.reach) return std::nullopt;
  const double usual_s =
      max_gap.typical_s.value_or(max_gap_of(recording, std::nullopt).typical_s.value_or(0.0));
  std::optional<Gap> longest;
  double longest_s = kUnusual * usual_s;
  for (PointId bee = 0; bee < recording.bees.size(); ++bee) {
    const io::RecordedBee& of = recording.bees[bee];
    std::optional<Gap> of_this;
    double of_this_s = longest_s;
    const double joined_s = own_max_gap_s(recording, bee, max_gap).value_or(max_gap.seconds);
    for (std::size_t i = 1; i < of.fixes.size(); ++i) {
      const double from_s = of.fixes[i - 1].time_s;
      const double to_s = of.fixes[i].time_s;
      if (!(to_s - from_s > of_this_s) || to_s - from_s > joined_s) continue;
      const bool lost = std::any_of(of.lost.begin(), of.lost.end(), [&](const TimeSpan& span) {
        return span.begins_s < to_s && from_s < span.ends_s;
      });
      if (lost && !max_gap.asked) continue;
      of_this = Gap{bee, from_s, to_s};
      of_this_s = to_s - from_s;
    }
    if (!of_this || !(of_this_s > kUnusual * interval_of(of).median_s)) continue;
    longest = of_this;
    longest_s = of_this_s;
  }
  return longest;
}

std::string max_gap_text(const MaxGap& max_gap) {
  if (!std::isfinite(max_gap.seconds)) return max_gap.asked ? "never (--max-gap)" : "never";
  std::string text = io::exact(max_gap.seconds) + " s";
  if (max_gap.typical_s) {
    text += ", " + io::exact(kGapFactor) + " times the typical interval of " +
            io::exact(*max_gap.typical_s) + " s";
  }
  return text + " (--max-gap)";
}

}  // namespace beespace::analysis
