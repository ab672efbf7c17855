// What `beespace simulate` can fly, by name.
#pragma once

#include "scenes/missions.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::cli {

inline constexpr std::string_view kHeadOn = "head-on";
inline constexpr std::string_view kPillars = "pillars";
// Random swaps, closer and closer together.
inline constexpr std::string_view kDensitySweep = "density-sweep";

std::vector<std::string> scenario_names();

// Whether this is no scenario, but a file of starts and goals: "-", or with a '.' or '/' in it.
bool names_a_file(std::string_view scenario);

struct ScenarioSize {
  std::size_t bees;
  double spacing_m;
  double clear_m;
  std::uint64_t seed;
};

// Of a scenario of that name, but for the sweep, which has several.
scenes::Mission mission_of(std::string_view scenario, const ScenarioSize& size);

}  // namespace beespace::cli
