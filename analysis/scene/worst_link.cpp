#include "analysis/scene/worst_link.hpp"

#include "analysis/recorded/findings.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace beespace::analysis {
namespace {

std::string bees_in_link(PointId first, PointId second) {
  return "bees=" + std::to_string(first) + "," + std::to_string(second);
}

std::string link_of(const report::SnapshotFacts& facts) {
  if (facts.pairs.empty()) return {};
  return "#" + bees_in_link(facts.pairs.front().first, facts.pairs.front().second);
}

std::string link_of(const report::RecordingFacts& facts) {
  const auto time = time_of(facts.tracks);
  if (facts.conflicts.empty() || !time) return {};
  // Of two in the air, if there is one, as other answers have it.
  const auto& standing = facts.with_standing;
  const auto in_the_air = standing.empty()
                              ? facts.conflicts.begin()
                              : std::find_if(facts.conflicts.begin(), facts.conflicts.end(),
                                             [&standing](const Conflict& conflict) {
                                               return std::find(standing.begin(), standing.end(),
                                                                conflict) == standing.end();
                                             });
  const Conflict& worst =
      in_the_air == facts.conflicts.end() ? facts.conflicts.front() : *in_the_air;
  // To the millisecond, as the page itself writes it.
  const double since_s = std::round((worst.closest_s - time->begins_s) * 1e3) / 1e3;
  return "#t=" + io::exact(since_s) + "&" + bees_in_link(worst.first, worst.second);
}

}  // namespace

std::string worst_link(const Scene& scene) {
  return std::visit([](const auto& facts) { return link_of(facts); }, scene);
}

}  // namespace beespace::analysis
