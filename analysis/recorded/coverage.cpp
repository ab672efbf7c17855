#include "analysis/recorded/coverage.hpp"

#include "analysis/text/bee_name.hpp"
#include "analysis/text/moment_text.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace beespace::analysis {
namespace {

// Where and when a bee is first, and last.
struct Ends {
  Fix first;
  Fix last;
};

std::optional<Ends> ends_of(const io::RecordedBee& bee) {
  if (bee.path) {
    const BezierPath& path = *bee.path;
    const Fix first{path.begins_s, path.begin};
    if (path.pieces.empty()) return Ends{first, first};
    return Ends{first, {path.pieces.back().ends_s, path.pieces.back().end}};
  }
  if (bee.fixes.empty()) return std::nullopt;
  return Ends{bee.fixes.front(), bee.fixes.back()};
}

// A drone of a show that begins and ends here stands there before and after.
constexpr double kGroundTolerance_m = 0.1;
// Shows count heights from the ground: a table of which all begins and ends are higher than this
// is no whole show.
constexpr double kHighestGround_m = 1.0;

// Where the ground of a show is: where it says, or the lowest place at which a drone begins or
// ends.
double ground_of(const io::Recording& recording) {
  double lowest_m = recording.show->ground_m.value_or(std::numeric_limits<double>::infinity());
  for (const io::RecordedBee& bee : recording.bees) {
    const auto ends = ends_of(bee);
    if (ends) lowest_m = std::min({lowest_m, ends->first.position.z, ends->last.position.z});
  }
  return lowest_m <= kHighestGround_m ? lowest_m : 0.0;
}

// From the first fix of all to the last one.
std::pair<double, double> whole_time(const io::Recording& recording) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::pair<double, double> time{kInfinity, -kInfinity};
  for (const io::RecordedBee& bee : recording.bees) {
    const auto ends = ends_of(bee);
    if (!ends) continue;
    time.first = std::min(time.first, ends->first.time_s);
    time.second = std::max(time.second, ends->last.time_s);
  }
  return time;
}

// How long each bee is not known before its first fix and after its last one: a drone of a show not
// while it stands on the ground.
std::vector<double> outside_s(const io::Recording& recording) {
  const auto whole = whole_time(recording);
  const double ground_m = recording.show ? ground_of(recording) : 0.0;
  const auto stands = [&](const Fix& fix) {
    return recording.show && fix.position.z - ground_m <= kGroundTolerance_m;
  };
  std::vector<double> outside;
  for (const io::RecordedBee& bee : recording.bees) {
    double seconds = 0.0;
    if (const auto ends = ends_of(bee)) {
      if (!stands(ends->first)) seconds += ends->first.time_s - whole.first;
      if (!stands(ends->last)) seconds += whole.second - ends->last.time_s;
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
    if (missing_s > 0.0 && recording.show) ++coverage.bees_in_the_air;
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
           " known for a part of the recording only" +
           (coverage.bees_in_the_air > 0 ? " (beginning or ending in the air)" : ""));
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
