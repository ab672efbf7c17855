#include "report/map/map_words.hpp"

#include "report/map/map_time.hpp"
#include "report/number_label.hpp"
#include "report/xml_text.hpp"

#include <cstdint>

namespace beespace::report {
namespace {

std::string closest_of(std::uint64_t all, std::uint64_t kept, const char* what) {
  if (kept >= all) return {};
  return "of " + count_label(all) + what + ", the closest " + count_label(kept) +
         " are in the file";
}

std::string with_unknown(std::string words, const std::string& unknown) {
  if (unknown.empty()) return words;
  if (!words.empty()) words += "; ";
  return words + "conflicts are those of the bees and times that are known: " + unknown;
}

}  // namespace

std::string pair_name(const Names& names, PointId first, PointId second) {
  return names.of(first) + " \u2013 " + names.of(second);
}

std::string nearest_words(const Nearest& nearest, const SwarmFacts& swarm) {
  if (nearest.id == Nearest::kNone) return {};
  return length_label_below(swarm.threshold_m, nearest.distance_m) + " from " +
         xml_text(swarm.names.of(nearest.id));
}

std::string conflict_words(const Conflict& conflict, const SwarmFacts& swarm) {
  return length_label_below(swarm.threshold_m, conflict.closest_m) + " apart at " +
         map_instant(conflict.closest_s) + (conflict.certain ? "" : "; possible, not certain");
}

std::string kept_words(const SnapshotFacts& facts) {
  return with_unknown(closest_of(facts.pair_count, facts.pairs.size(), " pairs"), facts.unknown);
}

std::string kept_words(const RecordingFacts& facts) {
  return with_unknown(closest_of(facts.conflict_count, facts.conflicts.size(), " conflicts"),
                      facts.unknown);
}

std::string document_words(const SwarmFacts& swarm, const std::string& kept,
                           const std::vector<std::string>& notes) {
  std::string html =
      swarm.flat ? "The input has no heights: all are shown at height 0."
                 : "Heights are those of the input, taken as metres above the WGS84 ellipsoid. "
                   "Globes that "
                   "count "
                   "altitudes from mean sea level show bees some tens of metres higher or lower.";
  if (!kept.empty()) html += "<br/>" + xml_text(kept);
  for (const std::string& note : notes) html += "<br/>" + xml_text(note);
  return html;
}

}  // namespace beespace::report
