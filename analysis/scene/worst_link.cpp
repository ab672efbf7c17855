#include "analysis/scene/worst_link.hpp"

#include "analysis/recorded/findings.hpp"
#include "io/bytes/number_text.hpp"

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
  const Conflict& worst = facts.conflicts.front();
  // To the millisecond, as the page itself writes it.
  const double since_s = std::round((worst.closest_s - time->begins_s) * 1e3) / 1e3;
  return "#t=" + io::exact(since_s) + "&" + bees_in_link(worst.first, worst.second);
}

}  // namespace

std::string worst_link(const Scene& scene) {
  return std::visit([](const auto& facts) { return link_of(facts); }, scene);
}

}  // namespace beespace::analysis
