#include "report/map/map_words.hpp"

#include "io/bytes/number_text.hpp"
#include "report/calendar_words.hpp"
#include "report/number_label.hpp"
#include "report/separation_words.hpp"
#include "report/xml_text.hpp"

#include <cmath>
#include <cstdint>
#include <utility>

namespace beespace::report {
namespace {

// As its recording tells times: of a show, the seconds since it began, and no day of 1970.
std::string instant_words(double time_s, const io::Calendar& calendar) {
  const std::string date = date_time_label(time_s, calendar);
  return date.empty() ? io::grouped(time_s, 2) + " s" : date;
}

std::string closest_of(std::uint64_t all, std::uint64_t kept, const char* what) {
  if (kept >= all) return {};
  return "of " + count_label(all) + what + ", the closest " + count_label(kept) +
         " are in the file";
}

std::string with_unknown(std::string words, const SwarmFacts& swarm, const std::string& unknown) {
  if (unknown.empty()) return words;
  words += words.empty() ? "C" : "; c";
  words += "onflicts are those of the " + swarm.noun.several;
  return words + " and times that are known: " + unknown;
}

// `apart` is that of each, or empty.
std::string separation_words(const SwarmFacts& swarm, double metres,
                             const std::vector<Apart>& apart, std::size_t number) {
  const bool in_height =
      swarm.vertical_m && number < apart.size() && std::isfinite(apart[number].horizontal_m);
  if (!in_height) return distance_words(swarm, metres) + " apart";
  return apart_words(swarm, metres, apart[number]);
}

std::string height_reference(const SwarmFacts& swarm) {
  if (swarm.flat) return "The input has no heights: all are shown at height 0.";
  if (counts_from_unknown_ground(swarm)) {
    std::string words =
        "Heights are those above the place of take-off, of which the input does not say how "
        "high it is: in KML they are above the ground, elsewhere as if it were at height 0.";
    if (swarm.placed) words += " --origin lon,lat,height,heading says how high it is.";
    return words;
  }
  if (swarm.heights.by_pressure) {
    return "Heights are those by pressure of the standard atmosphere, as the input has them: as "
           "heights over the ground they are wrong by as much as the weather differs from it.";
  }
  if (swarm.heights.above_sea || (swarm.placed && swarm.placed->above_sea)) {
    return "Heights are metres above mean sea level, as the input has them. Globes that count from "
           "the WGS84 ellipsoid show them some tens of metres higher or lower.";
  }
  return "Heights are those of the input, taken as metres above the WGS84 ellipsoid. Globes that "
         "count altitudes from mean sea level show them some tens of metres higher or lower.";
}

}  // namespace

bool counts_from_unknown_ground(const SwarmFacts& swarm) {
  return swarm.placed ? !swarm.placed->height_known : swarm.heights.above_home;
}

std::string pair_name(const Names& names, PointId first, PointId second) {
  return names.of(first) + " \u2013 " + names.of(second);
}

std::string pair_name(const Names& names, const Conflict& conflict) {
  return names.at(conflict.closest_s, conflict.first) + " \u2013 " +
         names.at(conflict.closest_s, conflict.second);
}

std::string nearest_words(const Nearest& nearest, const SwarmFacts& swarm) {
  if (nearest.id == Nearest::kNone) return {};
  return distance_words(swarm, nearest.distance_m) + " from " +
         xml_text(swarm.names.of(nearest.id));
}

std::string pair_words(const SnapshotFacts& facts, std::size_t pair) {
  return separation_words(facts.swarm, facts.distances_m[pair], facts.apart, pair);
}

std::string conflict_words(const RecordingFacts& facts, std::size_t conflict) {
  const Conflict& c = facts.conflicts[conflict];
  return separation_words(facts.swarm, c.closest_m, facts.conflicts_apart, conflict) + " at " +
         instant_words(c.closest_s, facts.calendar) + (c.certain ? "" : "; possible, not certain");
}

std::string kept_words(const SnapshotFacts& facts) {
  return with_unknown(closest_of(facts.pair_count, facts.pairs.size(), " pairs"), facts.swarm,
                      facts.unknown);
}

std::string kept_words(const RecordingFacts& facts) {
  std::string words = closest_of(facts.conflict_count, facts.conflicts.size(), " conflicts");
  if (facts.low_count > 0) {
    words += (words.empty() ? "" : "; ") + facts.low_text + " are left out";
  }
  return with_unknown(std::move(words), facts.swarm, facts.unknown);
}

std::string document_words(const SwarmFacts& swarm, const std::string& kept,
                           const std::vector<std::string>& notes) {
  std::string html = height_reference(swarm);
  if (!kept.empty()) html += "<br/>" + xml_text(kept);
  for (const std::string& note : notes) html += "<br/>" + xml_text(note);
  return html;
}

}  // namespace beespace::report
