#include "cli/simulate/simulate_scenarios.hpp"

namespace beespace::cli {
namespace {

using Make = scenes::Mission (*)(std::size_t, double, double, std::uint64_t);

struct Scenario {
  std::string_view name;
  Make make;
};

constexpr Scenario kScenarios[] = {{"random-swap", scenes::random_swap},
                                   {"sphere-swap", scenes::antipodal_swap},
                                   {"crossing-streams", scenes::crossing_streams},
                                   {"funnel", scenes::funnel},
                                   {kPillars, scenes::pillars}};

}  // namespace

std::vector<std::string> scenario_names() {
  std::vector<std::string> names;
  for (const Scenario& scenario : kScenarios) names.emplace_back(scenario.name);
  names.emplace_back(kHeadOn);
  names.emplace_back(kDensitySweep);
  return names;
}

bool names_a_file(std::string_view scenario) {
  return scenario == "-" || scenario.find_first_of("./") != std::string_view::npos;
}

scenes::Mission mission_of(std::string_view scenario, const ScenarioSize& size) {
  for (const Scenario& known : kScenarios) {
    if (known.name != scenario) continue;
    return known.make(size.bees, size.spacing_m, size.clear_m, size.seed);
  }
  return scenes::head_on(size.spacing_m);
}

}  // namespace beespace::cli
