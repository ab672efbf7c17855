#include "cli/simulate/simulate_command.hpp"
#include "cli/simulate/simulate_scenarios.hpp"

namespace beespace::cli {
namespace {

constexpr const char* kDescription =
    "Fly a swarm that keeps its distance, step by step, and check what it flew";

constexpr const char* kDetails =
    "Everybody would like to fly straight to its goal, as fast as it can, and to stop there. In "
    "every\n"
    "step each is told a velocity with which nobody comes too close to anybody, nor to an "
    "obstacle: the\n"
    "one that is closest to its wish. All that is flown is checked by the checker of 'beespace "
    "verify',\n"
    "which knows nothing of how velocities are found. Ends when all have arrived (within half of "
    "the\n"
    "threshold of their goals) and stand, or after --steps. The summary goes to standard error; "
    "the\n"
    "recording is written with --output only: a table of time_s, id, x, y, z, vx, vy, vz (with\n"
    "--acceleration none without velocities, as these jump), which 'beespace verify' and "
    "'beespace\n"
    "replay' read.\n"
    "\n"
    "Scenarios:\n"
    "  random-swap       a cube of bees who change places at random\n"
    "  sphere-swap       everybody on a sphere, through its middle to the opposite point\n"
    "  crossing-streams  two cubes of bees who fly through each other at right angles\n"
    "  funnel            a wide field of bees who all fly into a narrow column\n"
    "  pillars           a cube of bees who fly through a forest of pillars\n"
    "  head-on           two who fly straight at each other\n"
    "  density-sweep     random swaps at 3, 2.5, 2, 1.75 and 1.5 thresholds, a line for each\n"
    "Or a file (with a '.' or '/' in its name, or - for standard input): a table with the columns "
    "x, y,\n"
    "z, goal_x, goal_y, goal_z, and perhaps id, max_speed_mps and max_acceleration_mps2.\n"
    "\n"
    "Obstacles are a JSON document, metres, z up; without low_m or high_m they have no end there:\n"
    "  {\"obstacles\": [{\"kind\": \"sphere\", \"center\": [0, 0, 50], \"radius_m\": 10},\n"
    "    {\"kind\": \"box\", \"low\": [0, 0, 0], \"high\": [20, 30, 40]},\n"
    "    {\"kind\": \"ground\", \"height_m\": 0},\n"
    "    {\"kind\": \"cylinder\", \"center\": [50, 0], \"radius_m\": 2, \"high_m\": 60},\n"
    "    {\"kind\": \"prism\", \"outline\": [[0, 50], [40, 50], [0, 90]], \"high_m\": 25}]}\n"
    "\n"
    "Examples:\n"
    "  beespace simulate random-swap --bees 1000 --output swap.csv\n"
    "  beespace verify swap.csv --threshold 5 --max-speed 10 --max-acceleration 5\n"
    "  beespace simulate random-swap --bees 1000 --method none\n"
    "  beespace simulate sphere-swap --bees 200 --threshold 2 --speed 15 --acceleration none\n"
    "  beespace simulate mission.csv --obstacles city.json --clearance 2\n"
    "  beespace simulate density-sweep --method orca\n"
    "  beespace simulate head-on --output - | beespace replay --threshold 5\n"
    "  beespace simulate random-swap --json --quiet --fail-on-risk\n"
    "\n"
    "Exit status: 0 fine, 1 somebody came too close (with --fail-on-risk), 2 wrong usage, 3 bad "
    "input,\n"
    "4 cannot open, read or write, 130 interrupted, 143 terminated, 141 closed pipe.";

void add_flight_options(Command& simulate, SimulateOptions& options) {
  simulate.group("Scenario");
  simulate.option("--bees", "N", options.bees,
                  "How many (default: 1000; head-on is always of two)");
  simulate.option("--spacing", "LENGTH", options.spacing,
                  "About how far apart they begin (default: three\ntimes the threshold; of head-on "
                  "20 times)");
  simulate.option("--seed", "N", options.seed, "Another number, another swarm (default: 1)");
  simulate.group("Flight");
  simulate.option("--speed", "SPEED", options.speed, "The greatest, in m/s (default: 10)");
  simulate.option("--acceleration", "A|none", options.acceleration,
                  "The greatest, in m/s^2 (default: 5); none:\nvelocities change at once");
  simulate.option("--step", "SECONDS", options.step, "How long a step is (default: 0.1)");
  simulate.option("--steps", "N", options.steps, "The most steps to fly (default: 1000)");
}

void add_prevention_options(Command& simulate, SimulateOptions& options) {
  simulate.group("Separation");
  simulate.option("--threshold", "LENGTH", options.threshold,
                  "Closer than this is too close (default: 5)");
  simulate.choice("--method", options.method, {"certified", "orca", "mvp", "none"},
                  "Who keeps them apart (default: certified); with\nnone everybody flies as it "
                  "likes; orca and mvp, to\ncompare with, promise nothing and know of no "
                  "obstacles");
  simulate.option("--obstacles", "FILE", options.obstacles,
                  "What stands in the way, beside the scenario's own:\nJSON, see below; - for "
                  "standard input");
  simulate.option("--clearance", "LENGTH", options.clearance,
                  "Closer than this to an obstacle is too close\n(default: 1)");
  simulate.option("--threads", "N", options.threads, "How many threads work (default: 0, all)");
}

void add_output_options(Command& simulate, SimulateOptions& options) {
  simulate.group("Output");
  simulate.option(
      "-o,--output", "FILE", options.output,
      "Where the recording goes: .csv or .tsv, perhaps\nwith .gz; - for standard output");
  simulate.flag("--json", options.json, "The summary as JSON on standard output");
  simulate.flag("--fail-on-risk", options.fail_on_risk, "Exit with 1 when somebody came too close");
  simulate.flag("--quiet", options.quiet, "No summary and no progress, only errors");
}

}  // namespace

Command simulate_command(SimulateOptions& options) {
  Command simulate("simulate", kDescription, kDetails,
                   [&options] { return run_simulate(options); });
  Option& scenario =
      simulate.argument("SCENARIO", options.scenario, "What to fly, or a file, see below");
  scenario.required = true;
  allow_only(scenario, scenario_names(), names_a_file,
             ", and no file (which would have a '.' or '/' in its name)");
  add_flight_options(simulate, options);
  add_prevention_options(simulate, options);
  add_output_options(simulate, options);
  return simulate;
}

}  // namespace beespace::cli
