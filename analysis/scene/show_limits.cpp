#include "analysis/scene/show_limits.hpp"

#include "analysis/recorded/flights.hpp"
#include "analysis/recorded/limits_beside.hpp"
#include "analysis/recorded/tracks.hpp"
#include "analysis/recorded/verify_paths.hpp"
#include "io/bytes/number_text.hpp"

#include <beespace/verify_path.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

constexpr std::size_t kMostExcesses = 2000;
constexpr double kNoGaps = std::numeric_limits<double>::infinity();

struct Named {
  PathLimit limit;
  const char* name;
};
// Those that a show can declare.
constexpr std::array<Named, 4> kDeclarable = {{{PathLimit::kHorizontalSpeed, "horizontal"},
                                               {PathLimit::kClimb, "climb"},
                                               {PathLimit::kDescent, "descent"},
                                               {PathLimit::kHeight, "height"}}};

// By limit, the greatest first.
void keep_greatest(report::RecordingFacts& facts) {
  auto& excesses = facts.excesses;
  facts.excess_count = excesses.size();
  std::stable_sort(excesses.begin(), excesses.end(), [](const auto& a, const auto& b) {
    return a.limit != b.limit ? a.limit < b.limit : a.greatest > b.greatest;
  });
  if (excesses.size() <= kMostExcesses) return;
  const std::size_t each = kMostExcesses / facts.declared.size();
  std::vector<std::size_t> kept(facts.declared.size());
  std::erase_if(excesses,
                [&](const report::LimitExcess& excess) { return ++kept[excess.limit] > each; });
  facts.swarm.notes.push_back("of " + io::grouped(facts.excess_count) +
                              " stretches beyond limits of the show, the worst " +
                              io::grouped(std::uint64_t{excesses.size()}) + " are kept");
}

void take(const PathCheck& checked, PointId bee, const std::vector<PathLimit>& limits,
          report::RecordingFacts& facts) {
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const PathPeak& peak = checked.peaks[static_cast<std::size_t>(limits[i])];
    report::DeclaredLimit& declared = facts.declared[i];
    if (std::isnan(declared.greatest) || peak.value > declared.greatest) {
      declared.greatest = peak.value;
      declared.bee = bee;
      declared.time_s = peak.at_s;
    }
  }
  for (const PathExcess& excess : checked.excesses) {
    const auto at = std::find(limits.begin(), limits.end(), excess.limit) - limits.begin();
    facts.excesses.push_back({static_cast<std::uint32_t>(at),
                              bee,
                              {excess.begins_s, excess.ends_s},
                              excess.peak.value,
                              excess.peak.at_s});
  }
}

const char* name_of(io::ShowAcceleration::Direction direction) {
  using Direction = io::ShowAcceleration::Direction;
  if (direction == Direction::kHorizontal) return "horizontal_acceleration";
  return direction == Direction::kVertical ? "vertical_acceleration" : "acceleration";
}

void take_acceleration(const AccelerationCheck& check, report::RecordingFacts& facts) {
  if (!check.greatest) return;
  const auto limit = static_cast<std::uint32_t>(facts.declared.size());
  facts.declared.push_back({name_of(check.declared.direction), check.declared.most_mps2,
                            check.greatest->peak.value, check.greatest->bee,
                            check.greatest->peak.at_s});
  for (const BeeExcess& broken : check.excesses) {
    const PathExcess& excess = broken.excess;
    facts.excesses.push_back(
        {limit, broken.bee, {excess.begins_s, excess.ends_s}, excess.peak.value, excess.peak.at_s});
  }
}

}  // namespace

Status take_show_limits(const io::Recording& recording, report::RecordingFacts& facts) {
  if (!recording.show || recording.frame != io::Frame::kMetres) return std::monostate{};
  PathLimits most;
  std::vector<PathLimit> limits;
  for (const Named& named : kDeclarable) {
    const auto declared = declared_limit(*recording.show, named.limit);
    if (!declared) continue;
    most[named.limit] = *declared;
    limits.push_back(named.limit);
    facts.declared.push_back(
        {named.name, *declared, std::numeric_limits<double>::quiet_NaN(), 0, 0.0});
  }
  const std::vector<Flight> flights = flights_of(recording, false, kNoGaps);
  for (std::size_t bee = 0; bee < flights.size() && !limits.empty(); ++bee) {
    for (const BezierPath& path : flights[bee]) {
      const auto checked = check_path(path, most);
      if (!checked) return of_bee(checked.error(), recording.bees[bee]);
      take(*checked, static_cast<PointId>(bee), limits, facts);
    }
  }
  auto beside = check_limits_beside(recording, flights);
  if (!beside) return beside.error();
  for (const AccelerationCheck& check : beside->accelerations) take_acceleration(check, facts);
  for (const NavigationCheck& check : beside->navigation) {
    if (!check.kept())
      facts.swarm.notes.push_back(check.name + " is not kept: " + low_move_text(check));
  }
  facts.not_looked_at = std::move(beside->not_known);
  std::erase_if(facts.declared, [](const auto& limit) { return std::isnan(limit.greatest); });
  // Down is no climb, and up no descent.
  for (auto& limit : facts.declared) {
    if (limit.name != "height") limit.greatest = std::max(0.0, limit.greatest);
  }
  keep_greatest(facts);
  return std::monostate{};
}

}  // namespace beespace::analysis
