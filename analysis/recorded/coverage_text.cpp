#include "analysis/recorded/airborne.hpp"
#include "analysis/recorded/coverage.hpp"
#include "analysis/text/bee_name.hpp"
#include "io/bytes/number_text.hpp"
#include "io/recording/moment_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace beespace::analysis {
namespace {

constexpr std::size_t kFew = 3;

// "d1, d2 and d3".
std::string listed(const std::vector<PointId>& bees, const io::Recording& recording) {
  std::string names;
  for (const PointId bee : bees) {
    if (!names.empty()) names += bee == bees.back() ? " and " : ", ";
    names += text_of(name_of(bee, recording));
  }
  return names;
}

// ": d1 and d2", where they are few enough to be named.
std::string names_of(const std::vector<PointId>& bees, const io::Recording* recording) {
  if (recording == nullptr || bees.size() > kFew) return {};
  return ": " + listed(bees, *recording);
}

// ": d1 and d2", where all that begin or end in the air are few enough to be named.
std::string names_cut_off(const Coverage& coverage, const io::Recording& recording) {
  std::vector<PointId> bees;
  for (const Gap& gap : coverage.longest_outside) {
    const auto& unseen = coverage.unseen;
    if (std::find(unseen.begin(), unseen.end(), gap.track) != unseen.end()) continue;
    if (std::find(bees.begin(), bees.end(), gap.track) == bees.end()) bees.push_back(gap.track);
  }
  if (bees.size() != coverage.bees_cut_off) return {};
  std::sort(bees.begin(), bees.end());
  return names_of(bees, &recording);
}

// "; its times begin 1 h before those of the others", and what that may mean.
std::string apart_in_time(double later_s, bool one, const io::Recording& recording) {
  const auto zones_s = zones_apart_s(later_s);
  const double apart_s = std::abs(zones_s.value_or(later_s));
  if (!(apart_s >= 1.0)) return {};
  const std::string whose = one ? "its" : "their";
  std::string text = "; " + whose + " times begin " + (zones_s ? "about " : "") +
                     io::time_span(apart_s) + (later_s < 0.0 ? " before" : " after") +
                     " those of the others";
  if (!zones_s) return text;
  if (recording.clock) {
    return text + ": was the clock in another time zone? Then write the zone behind " + whose +
           " times, as in 2026-05-01 12:00:00+02:00, and say that of the others with --time-zone";
  }
  return text + ": is a clock set to another time zone?";
}

}  // namespace

std::string unknown_text(const Coverage& coverage, const io::Recording* recording,
                         const io::RecordedNoun& noun) {
  std::string text;
  const auto append = [&text](const std::string& more) {
    if (!text.empty() && !more.empty()) text += ", ";
    text += more;
  };
  if (coverage.gaps > 0) {
    append(noun.counted(coverage.bees_with_gaps) + " unknown for " +
           io::time_span(coverage.in_gaps_s) + " in all" +
           (coverage.of_aircraft && coverage.joins_slow_s
                ? " (--max-gap " + io::exact(*coverage.joins_slow_s) +
                      " joins their fixes in cruise by straight lines)"
                : ""));
  }
  if (coverage.sector) {
    if (coverage.bees_unplaced > 0) {
      append(noun.counted(coverage.bees_unplaced) + " there without a place before or after");
    }
    if (!coverage.unseen.empty()) {
      append(noun.counted(coverage.unseen.size()) +
             " known on the ground only, and not while others fly" +
             names_of(coverage.unseen, recording));
    }
  } else if (coverage.bees_partly > 0) {
    append(noun.counted(coverage.bees_partly) + " known for " +
           (coverage.instants_only ? "an instant only, each" : "a part of the recording only"));
    if (coverage.bees_cut_off > 0) {
      const bool one = coverage.bees_cut_off == 1;
      text += " (" + io::grouped(std::uint64_t{coverage.bees_cut_off}) + " of which ";
      if (coverage.in_a_plane) {
        text += one ? "appears or vanishes on its way" : "appear or vanish on their way";
      } else {
        text +=
            std::string(one ? "begins or ends" : "begin or end") + " in the air while others fly";
      }
      if (recording != nullptr) text += names_cut_off(coverage, *recording);
      text += ")";
    }
    if (!coverage.unseen.empty()) {
      const auto count = std::uint64_t{coverage.unseen.size()};
      text += " (" + io::grouped(count) +
              " of which known on the ground only, and not while others fly" +
              names_of(coverage.unseen, recording) + ")";
    }
    if (coverage.bees_unplaced > 0) {
      append(io::grouped(std::uint64_t{coverage.bees_unplaced}) +
             " of them there without a place before or after");
    }
  }
  if (coverage.compared_with_none()) {
    const bool one = coverage.alone.size() == 1;
    const bool named = recording != nullptr && coverage.alone.size() <= kFew;
    append((named ? listed(coverage.alone, *recording) : noun.counted(coverage.alone.size())) +
           (one ? " flies" : " fly") + " while no other is known");
  }
  append(missing_text(coverage.missing, noun));
  if (coverage.coarse > 0) {
    append(noun.counted(coverage.coarse) + (coverage.coarse == 1 ? " has" : " have") +
           (coverage.coarse_by.empty() ? " places written in steps of up to "
                                       : " places that are off by up to ") +
           io::length(coverage.coarse_m));
  }
  append(coverage.heights);
  return text;
}

std::string sector_text(const Coverage& coverage, const io::RecordedNoun& noun) {
  if (!coverage.sector || coverage.bees_partly == 0) return {};
  return noun.counted(coverage.bees_partly) + (coverage.bees_partly == 1 ? " is" : " are") +
         " outside the sector before the first or after the last fix (--sector)";
}

std::string missing_text(const io::MissingRecords& missing, const io::RecordedNoun& noun) {
  std::string text;
  if (missing.shared > 0) {
    text = io::grouped(missing.shared) +
           (missing.shared == 1 ? " id seems to be of two " : " ids seem to be of two ") +
           noun.several + (missing.shared == 1 ? "" : " each");
  }
  if (missing.files > 0) {
    if (!text.empty()) text += ", ";
    text += io::counted(missing.files, "file or folder was", "files or folders were") + " left out";
  }
  if (missing.jumping > 0) {
    text += (text.empty() ? "" : ", ") + noun.counted(missing.jumping) +
            (missing.jumping == 1 ? " jumps" : " jump");
  }
  if (missing.swapped > 0) {
    if (!text.empty()) text += ", ";
    text += "longitude and latitude of " + noun.counted(missing.swapped) +
            " seem to be the other way round";
  }
  if (missing.untimed > 0) {
    if (!text.empty()) text += ", ";
    text += "when " + io::counted(missing.untimed, "vehicle was", "vehicles were") +
            " where they say is not known";
  }
  if (missing.rough > 0) {
    if (!text.empty()) text += ", ";
    text += noun.counted(missing.rough) + (missing.rough == 1 ? " has" : " have") +
            " places too rough to tell";
  }
  if (missing.count == 0) return text;
  if (!text.empty()) text += ", ";
  if (missing.nowhere > 0) {
    text += noun.counted(missing.nowhere) +
            (missing.nowhere == 1 ? " is known nowhere, " : " are known nowhere, ");
  }
  return text + io::counted(missing.count, "record", "records") +
         (missing.count == 1 ? " was" : " were") + " left out";
}

std::string gap_text(const Gap& gap, const io::Recording& recording) {
  return text_of(name_at(gap.begins_s, gap.track, recording)) + " from " +
         io::moment_text(gap.begins_s, recording) + " for " + io::time_span(length_of(gap));
}

std::string alone_text(const Coverage& coverage, const io::Recording& recording) {
  if (coverage.alone.empty()) return {};
  std::vector<PointId> first = coverage.alone;
  first.resize(std::min(first.size(), kFew));
  const std::size_t more = coverage.alone.size() - first.size();
  std::string names = listed(first, recording);
  if (more > 0) names += " and " + io::grouped(std::uint64_t{more}) + " more";
  const bool one = coverage.alone.size() == 1;
  std::string text = names + (one ? " is" : " are") +
                     (one ? " recorded while no other is: compared with none"
                          : " recorded while none of the others is: compared with none of these");
  if (coverage.compared_with_none() && coverage.alone_begins_s) {
    text += apart_in_time(*coverage.alone_begins_s, one, recording);
  }
  return text;
}

std::string bridged_text(const Coverage& coverage, const io::Recording& recording) {
  return coverage.bridged ? gap_text(*coverage.bridged, recording) : std::string();
}

std::string slow_text(const Coverage& coverage, const io::Recording& recording) {
  if (coverage.slow.empty()) return {};
  std::string names;
  for (std::size_t i = 0; i < std::min(coverage.slow.size(), Coverage::kMostNamed); ++i) {
    names += (i > 0 ? ", " : "") + text_of(name_of(coverage.slow[i], recording));
  }
  const std::size_t more =
      coverage.slow.size() - std::min(coverage.slow.size(), Coverage::kMostNamed);
  if (more > 0) names += " and " + io::grouped(std::uint64_t{more}) + " more";
  const bool one = coverage.slow.size() == 1;
  const std::string has = coverage.bursts ? (one ? " has bursts of fixes as far apart as "
                                                 : " have bursts of fixes as far apart as ")
                          : one           ? " has a fix every "
                                          : " have fixes as far apart as ";
  return names + has + io::time_span(coverage.slowest_interval_s) +
         ", which is more than the max gap, and " + (one ? "is" : "are") +
         (coverage.bursts ? " unknown in between" : " hardly ever known") + ": --max-gap " +
         io::exact(coverage.joins_slow_s.value_or(max_gap_for(coverage.slowest_interval_s))) +
         " joins such fixes by straight lines";
}

}  // namespace beespace::analysis
