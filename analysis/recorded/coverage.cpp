#include "analysis/recorded/coverage.hpp"

#include "analysis/text/bee_name.hpp"
#include "analysis/text/moment_text.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace beespace::analysis {
namespace {

// From the first fix of all to the last one.
std::pair<double, double> whole_time(const io::Recording& recording) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::pair<double, double> time{kInfinity, -kInfinity};
  for (const io::RecordedBee& bee : recording.bees) {
    if (bee.fixes.empty()) continue;
    time.first = std::min(time.first, bee.fixes.front().time_s);
    time.second = std::max(time.second, bee.fixes.back().time_s);
  }
  return time;
}

// Before its first fix and after its last one; of a show's drone, which stands then, none.
double outside_s(const io::Recording& recording, const io::RecordedBee& bee,
                 const std::pair<double, double>& whole) {
  if (bee.fixes.empty() || recording.show) return 0.0;
  return (bee.fixes.front().time_s - whole.first) + (whole.second - bee.fixes.back().time_s);
}

}  // namespace

std::vector<double> unknown_times_s(const io::Recording& recording, const std::vector<Gap>& gaps) {
  const auto whole = whole_time(recording);
  std::vector<double> unknown_s;
  for (const io::RecordedBee& bee : recording.bees)
    unknown_s.push_back(outside_s(recording, bee, whole));
  for (const Gap& gap : gaps) unknown_s[gap.track] += length_of(gap);
  return unknown_s;
}

Coverage coverage_of(const io::Recording& recording, const std::vector<Gap>& gaps,
                     const MaxGap& max_gap) {
  Coverage coverage;
  coverage.max_gap = max_gap;
  coverage.gaps = gaps.size();
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    coverage.in_gaps_s += length_of(gaps[i]);
    if (i == 0 || gaps[i - 1].track != gaps[i].track) ++coverage.bees_with_gaps;
  }
  coverage.longest = gaps;
  const auto named = coverage.longest.begin() +
                     static_cast<std::ptrdiff_t>(std::min(Coverage::kMostNamed, gaps.size()));
  std::partial_sort(coverage.longest.begin(), named, coverage.longest.end(),
                    [](const Gap& a, const Gap& b) {
                      if (length_of(a) != length_of(b)) return length_of(a) > length_of(b);
                      return a.track != b.track ? a.track < b.track : a.begins_s < b.begins_s;
                    });
  coverage.longest.erase(named, coverage.longest.end());
  const auto whole = whole_time(recording);
  for (const io::RecordedBee& bee : recording.bees) {
    const double missing_s = outside_s(recording, bee, whole);
    coverage.outside_s += missing_s;
    if (missing_s > 0.0) ++coverage.bees_partly;
  }
  coverage.missing = recording.missing;
  return coverage;
}

std::string unknown_text(const Coverage& coverage) {
  std::string text;
  const auto append = [&text](const std::string& more) {
    if (!text.empty() && !more.empty()) text += ", ";
    text += more;
  };
  if (coverage.gaps > 0) {
    append(io::counted(coverage.bees_with_gaps, "bee", "bees") + " unknown for " +
           io::time_span(coverage.in_gaps_s) + " in all");
  }
  if (coverage.bees_partly > 0) {
    append(io::counted(coverage.bees_partly, "bee", "bees") +
           " known for a part of the recording only");
  }
  append(missing_text(coverage.missing));
  return text;
}

std::string missing_text(const io::MissingRecords& missing) {
  if (missing.count == 0) return {};
  std::string text;
  if (missing.nowhere > 0) {
    text = io::grouped(missing.nowhere) +
           (missing.nowhere == 1 ? " bee is known nowhere, " : " bees are known nowhere, ");
  }
  return text + io::counted(missing.count, "record", "records") +
         (missing.count == 1 ? " was" : " were") + " left out";
}

std::string gap_text(const Gap& gap, const io::Recording& recording) {
  return text_of(name_of(gap.track, recording)) + " from " + moment_text(gap.begins_s, recording) +
         " for " + io::time_span(length_of(gap));
}

}  // namespace beespace::analysis
