#include "analysis/recorded/coverage.hpp"

#include "analysis/text/bee_name.hpp"
#include "analysis/text/moment_text.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cmath>
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

// A drone of a show that begins and ends here stands there before and after. Logs are less exact.
constexpr double kGroundTolerance_m = 0.1;
constexpr double kLoggedTolerance_m = 1.0;
// Whoever takes off or lands goes up and down.
constexpr double kMostAtRest_mps = 0.5;

// The lowest height at which a bee begins or ends.
double ground_of(const io::Recording& recording) {
  double lowest_m = std::numeric_limits<double>::infinity();
  for (const io::RecordedBee& bee : recording.bees) {
    if (bee.fixes.empty()) continue;
    lowest_m = std::min({lowest_m, bee.fixes.front().position.z, bee.fixes.back().position.z});
  }
  return lowest_m;
}

// Drones in metres take off and land where others do. What is seen from afar, or in a plane, comes
// and goes.
bool may_be_cut_off(const io::Recording& recording) {
  if (recording.show) return true;
  if (recording.frame != io::Frame::kMetres || recording.flat) return false;
  return std::any_of(recording.bees.begin(), recording.bees.end(), [](const auto& bee) {
    return !bee.fixes.empty() &&
           (bee.fixes.front().position.z != 0.0 || bee.fixes.back().position.z != 0.0);
  });
}

// Whether it goes nowhere over ground from one fix to the next, or the other way round.
bool rests(const Fix& from, const Fix& to) {
  const double apart_m =
      std::hypot(to.position.x - from.position.x, to.position.y - from.position.y);
  return apart_m <= kMostAtRest_mps * std::abs(to.time_s - from.time_s);
}

// How long a bee is not known before its first fix and after its last one, and whether it was in
// the air then.
struct Outside {
  double seconds = 0.0;
  bool cut_off = false;
};

// A drone of a show is known while it stands on the ground.
std::vector<Outside> outside_of(const io::Recording& recording) {
  const auto whole = whole_time(recording);
  const double ground_m = ground_of(recording);
  const bool flies = may_be_cut_off(recording);
  std::vector<Outside> outside(recording.bees.size());
  const auto add = [&](Outside& of, double seconds, const Fix& end, const Fix& beside) {
    if (!(seconds > 0.0)) return;
    const double height_m = end.position.z - ground_m;
    if (recording.show && height_m <= kGroundTolerance_m) return;
    of.seconds += seconds;
    const bool stands = height_m <= kLoggedTolerance_m && rests(end, beside);
    of.cut_off = of.cut_off || recording.show || (flies && !stands);
  };
  for (std::size_t i = 0; i < outside.size(); ++i) {
    const std::vector<Fix>& fixes = recording.bees[i].fixes;
    if (fixes.empty()) continue;
    const std::size_t last = fixes.size() - 1;
    add(outside[i], fixes.front().time_s - whole.first, fixes.front(),
        fixes[std::min<std::size_t>(1, last)]);
    add(outside[i], whole.second - fixes.back().time_s, fixes.back(),
        fixes[last > 0 ? last - 1 : 0]);
  }
  return outside;
}

}  // namespace

std::vector<double> unknown_times_s(const io::Recording& recording, const std::vector<Gap>& gaps) {
  std::vector<double> unknown_s;
  for (const Outside& outside : outside_of(recording)) unknown_s.push_back(outside.seconds);
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
  for (const Outside& outside : outside_of(recording)) {
    coverage.outside_s += outside.seconds;
    if (outside.seconds > 0.0) ++coverage.bees_partly;
    if (outside.cut_off) ++coverage.bees_cut_off;
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
    if (coverage.bees_cut_off > 0) {
      text += " (" + io::grouped(std::uint64_t{coverage.bees_cut_off}) +
              " of which begin or end in the air while others fly)";
    }
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
