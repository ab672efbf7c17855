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

// A drone of a show that begins and ends here stands there before and after.
constexpr double kGroundTolerance_m = 0.1;

// The lowest height at which a bee begins or ends.
double ground_of(const io::Recording& recording) {
  double lowest_m = std::numeric_limits<double>::infinity();
  for (const io::RecordedBee& bee : recording.bees) {
    if (bee.fixes.empty()) continue;
    lowest_m = std::min({lowest_m, bee.fixes.front().position.z, bee.fixes.back().position.z});
  }
  return lowest_m;
}

// How long each bee is not known before its first fix and after its last one: a drone of a show not
// while it stands on the ground.
std::vector<double> outside_s(const io::Recording& recording) {
  const auto whole = whole_time(recording);
  const double ground_m = ground_of(recording);
  const auto stands = [&](const Fix& fix) {
    return recording.show && fix.position.z - ground_m <= kGroundTolerance_m;
  };
  std::vector<double> outside;
  for (const io::RecordedBee& bee : recording.bees) {
    double seconds = 0.0;
    if (!bee.fixes.empty()) {
      const Fix& first = bee.fixes.front();
      const Fix& last = bee.fixes.back();
      if (!stands(first)) seconds += first.time_s - whole.first;
      if (!stands(last)) seconds += whole.second - last.time_s;
    }
    outside.push_back(seconds);
  }
  return outside;
}

}  // namespace

std::vector<double> unknown_times_s(const io::Recording& recording, const std::vector<Gap>& gaps) {
  std::vector<double> unknown_s = outside_s(recording);
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
  for (const double missing_s : outside_s(recording)) {
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
  std::string text;
  if (missing.shared > 0) {
    text = io::grouped(missing.shared) + (missing.shared == 1 ? " id seems to be of two bees"
                                                              : " ids seem to be of two bees each");
  }
  if (missing.count == 0) return text;
  if (!text.empty()) text += ", ";
  if (missing.nowhere > 0) {
    text += io::grouped(missing.nowhere) +
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
