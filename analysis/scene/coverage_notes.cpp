#include "analysis/scene/coverage_notes.hpp"

#include "analysis/recorded/begins_in_air.hpp"

#include <utility>

namespace beespace::analysis {

void note_coverage(const Coverage& coverage, const io::Recording& recording,
                   const std::string& unknown, report::SwarmFacts& swarm) {
  const auto note = [&swarm](std::string text) {
    if (!text.empty()) swarm.notes.push_back(std::move(text));
  };
  if (!coverage.complete()) note("what is said of conflicts is of the known time: " + unknown);
  if (coverage.compared_with_none()) note(alone_text(coverage, recording));
  note(begins_in_air_text(coverage.begins_in_air));
  note(coverage.whole_seconds);
  note(sector_text(coverage, swarm.noun));
  if (coverage.bridged) {
    note("shorter gaps are bridged by straight lines; the longest of these: " +
         bridged_text(coverage, recording));
  }
  if (coverage.gaps > 0) {
    note(swarm.noun.several +
         " are unknown between two fixes that are farther apart in time than " +
         max_gap_text(coverage.max_gap) +
         "; the longest such gap: " + gap_text(coverage.longest.front(), recording));
  }
  note(slow_text(coverage, recording));
}

}  // namespace beespace::analysis
