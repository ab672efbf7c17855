#include "report/snapshot_json.hpp"

#include "io/json/json_object.hpp"
#include "report/quantised.hpp"
#include "report/swarm_json.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace beespace::report {
namespace {

// Beyond so many bees a page would be too large with all the bits.
constexpr std::size_t kMany = 250'000;

std::string at_risk_json(const SnapshotFacts& facts, Columns& columns) {
  std::vector<std::uint8_t> bits((facts.positions.size() + 7) / 8);
  for (const PointId bee : facts.at_risk) {
    bits[bee / 8] = static_cast<std::uint8_t>(bits[bee / 8] | (1u << (bee % 8)));
  }
  return columns.add(std::span<const std::uint8_t>(bits));
}

// Distances over many powers of ten, each as exact as the others.
std::string nearest_json(const std::vector<Nearest>& nearest, Columns& columns) {
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
  io::JsonObject json;
  json.add_json("code", columns.add(std::span<const std::uint16_t>(codes)));
  json.add_number("least_m", least_m);
  json.add_number("ratio", std::exp(logarithm));
  return json.text();
}

std::string closest_json(const ClosestPair& closest) {
  io::JsonObject json;
  json.add_count("first", closest.first);
  json.add_count("second", closest.second);
  json.add_number("distance_m", closest.distance_m);
  return json.text();
}

std::string risk_json(const SnapshotFacts& facts) {
  io::JsonObject json;
  json.add_count("at_risk", facts.at_risk.size());
  json.add_count("pairs", facts.pair_count);
  json.add_count("groups", facts.group_count);
  json.add_count("largest_group", facts.largest_group);
  if (!facts.unknown.empty()) json.add_text("unknown", facts.unknown);
  if (facts.closest) json.add_json("closest", closest_json(*facts.closest));
  return json.text();
}

// A few as exact as they are; of many, each to a sixteen-millionth of the largest.
std::string distances_json(const std::vector<double>& distances_m, Columns& columns) {
  constexpr std::size_t kFew = 10'000;
  constexpr double kSteps = 16'777'215.0;
  if (distances_m.size() <= kFew) return columns.add(std::span<const double>(distances_m));
  const double most_m = *std::max_element(distances_m.begin(), distances_m.end());
  const double step_m = most_m > 0.0 ? most_m / kSteps : 1.0;
  std::vector<std::uint32_t> codes;
  codes.reserve(distances_m.size());
  for (const double d : distances_m) {
    codes.push_back(static_cast<std::uint32_t>(std::min(kSteps, std::round(d / step_m))));
  }
  return columns.add(std::span<const std::uint32_t>(codes), Differences::kFirst, {step_m, 0.0});
}

std::string pairs_json(const SnapshotFacts& facts, Columns& columns) {
  std::vector<std::uint32_t> firsts;
  std::vector<std::uint32_t> seconds;
  for (const Pair& pair : facts.pairs) {
    firsts.push_back(pair.first);
    seconds.push_back(pair.second);
  }
  io::JsonObject json;
  json.add_json("first", columns.add(std::span<const std::uint32_t>(firsts)));
  json.add_json("second", columns.add(std::span<const std::uint32_t>(seconds)));
  json.add_json("distance_m", distances_json(facts.distances_m, columns));
  return json.text();
}

}  // namespace

std::string snapshot_json(const SnapshotFacts& facts, Columns& columns) {
  const std::size_t count = facts.positions.size();
  io::JsonObject json;
  json.add_text("kind", "snapshot");
  add_swarm(json, facts.swarm, count, columns);
  const Quantised positions = quantised(facts.positions, count > kMany ? 15 : 16);
  json.add_number("position_error_m", positions.error_m);
  io::JsonObject places;
  add_positions(places, positions, Differences::kNone, columns);
  json.add_json("positions", places.text());
  json.add_json("at_risk", at_risk_json(facts, columns));
  if (count > 1) json.add_json("nearest", nearest_json(facts.nearest, columns));
  json.add_json("risk", risk_json(facts));
  json.add_json("pairs", pairs_json(facts, columns));
  return json.text();
}

}  // namespace beespace::report
