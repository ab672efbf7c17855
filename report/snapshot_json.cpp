#include "report/snapshot_json.hpp"

#include "report/ahead_words.hpp"
#include "report/quantised.hpp"
#include "report/swarm_json.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::report {
namespace {

// Beyond so many bees a page would be too large with all the bits.
constexpr std::size_t kMany = 250'000;

void write_at_risk(io::JsonWriter& json, const SnapshotFacts& facts, Columns& columns) {
  std::vector<std::uint8_t> bits((facts.positions.size() + 7) / 8);
  for (const PointId bee : facts.at_risk) {
    bits[bee / 8] = static_cast<std::uint8_t>(bits[bee / 8] | (1u << (bee % 8)));
  }
  columns.add(json, "at_risk", bits);
}

// Distances over many powers of ten, each as exact as the others.
void write_nearest(io::JsonWriter& json, const std::vector<Nearest>& nearest, Columns& columns) {
  double least_m = std::numeric_limits<double>::infinity();
  double most_m = 0.0;
  for (const Nearest& to : nearest) {
    if (to.distance_m > 0.0) least_m = std::min(least_m, to.distance_m);
    most_m = std::max(most_m, to.distance_m);
  }
  if (!(most_m > 0.0)) least_m = most_m = 1.0;
  const double steps = nearest.size() > kMany ? 4094.0 : 65534.0;
  const double logarithm = std::log(most_m / least_m) / steps;
  std::vector<std::uint16_t> codes;
  codes.reserve(nearest.size());
  for (const Nearest& to : nearest) {
    const double code = logarithm > 0.0 ? std::log(to.distance_m / least_m) / logarithm : 0.0;
    codes.push_back(to.distance_m > 0.0
                        ? static_cast<std::uint16_t>(1.0 + std::round(std::min(code, steps)))
                        : std::uint16_t{0});
  }
  json.begin_object("nearest");
  columns.add(json, "code", codes);
  json.member("least_m", least_m).member("ratio", std::exp(logarithm));
  json.end();
}

void write_closest(io::JsonWriter& json, const ClosestPair& closest,
                   const std::optional<Apart>& apart) {
  json.begin_object("closest").member("first", closest.first).member("second", closest.second);
  json.member("distance_m", closest.distance_m);
  if (apart) write_apart(json, *apart);
  json.end();
}

void write_risk(io::JsonWriter& json, const SnapshotFacts& facts) {
  json.begin_object("risk").member("at_risk", facts.at_risk.size());
  json.member("pairs", facts.pair_count).member("groups", facts.group_count);
  json.member("largest_group", facts.largest_group);
  if (!facts.unknown.empty()) json.member("unknown", facts.unknown);
  if (!facts.moment.empty()) {
    json.member("ahead", ahead_words(facts));
    json.member("ahead_count", facts.ahead ? facts.ahead->count : std::uint64_t{0});
  }
  if (facts.closest) write_closest(json, *facts.closest, facts.closest_apart);
  json.end();
}

// A few as exact as they are; of many, each to a sixteen-millionth of the largest.
void write_distances(io::JsonWriter& json, const std::vector<double>& distances_m,
                     Columns& columns) {
  constexpr std::size_t kFew = 10'000;
  constexpr double kSteps = 16'777'215.0;
  if (distances_m.size() <= kFew) return columns.add(json, "distance_m", distances_m);
  const double most_m = *std::max_element(distances_m.begin(), distances_m.end());
  const double step_m = most_m > 0.0 ? most_m / kSteps : 1.0;
  std::vector<std::uint32_t> codes;
  codes.reserve(distances_m.size());
  for (const double d : distances_m) {
    codes.push_back(static_cast<std::uint32_t>(std::min(kSteps, std::round(d / step_m))));
  }
  columns.add(json, "distance_m", codes, Differences::kFirst, {step_m, 0.0});
}

void write_pairs(io::JsonWriter& json, const SnapshotFacts& facts, Columns& columns) {
  std::vector<std::uint32_t> firsts;
  std::vector<std::uint32_t> seconds;
  for (const Pair& pair : facts.pairs) {
    firsts.push_back(pair.first);
    seconds.push_back(pair.second);
  }
  json.begin_object("pairs");
  columns.add(json, "first", firsts);
  columns.add(json, "second", seconds);
  write_distances(json, facts.distances_m, columns);
  write_apart(json, facts.apart, columns);
  json.end();
}

}  // namespace

void write_swarm(io::JsonWriter& json, const SnapshotFacts& facts, Columns& columns) {
  const std::size_t count = facts.positions.size();
  json.begin_object().member("kind", "snapshot");
  if (!facts.moment.empty()) json.member("moment", facts.moment);
  write_facts(json, facts.swarm, count, columns);
  const Quantised positions = quantised(facts.positions, count > kMany ? 15 : 16);
  json.member("position_error_m", positions.error_m);
  json.begin_object("positions");
  write_positions(json, positions, Differences::kNone, columns);
  json.end();
  write_at_risk(json, facts, columns);
  if (count > 1) write_nearest(json, facts.nearest, columns);
  write_risk(json, facts);
  write_pairs(json, facts, columns);
  json.end();
}

}  // namespace beespace::report
