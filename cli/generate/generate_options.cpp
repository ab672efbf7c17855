#include "cli/command_line/option_checks.hpp"
#include "cli/generate/generate_command.hpp"

#include <beespace/version.hpp>

#include <CLI/CLI.hpp>

#include <string>

namespace beespace::cli {
namespace {

constexpr const char* kDescription =
    "Make up a swarm: the same seed gives the same bees on every machine";

constexpr const char* kDetails =
    "The format follows the ending of FILE: .csv, .txt, .tsv, .npy, .bin, each also with .gz;\n"
    "without FILE it is csv. An area is written in degrees, in the course format; else metres.\n"
    "\n"
    "Scenes:\n"
    "  uniform      evenly in a box (the default)\n"
    "  clusters     around centres in a cube\n"
    "  area         evenly in a part of the Earth\n"
    "and, of bees that fly, as text only:\n"
    "  flight       from anywhere in a box, straight on in any direction\n"
    "  head-on      pairs that fly at each other, within 60 s or the duration\n"
    "  crossing     two streams through a box at right angles\n"
    "  sphere-swap  everybody through the centre of a sphere to its other side\n"
    "  encounters   pairs, each far from all others, that pass within 60 s or the duration\n"
    "With velocities at one instant; or with --duration as a recording, fix by fix.\n"
    "\n"
    "Examples:\n"
    "  beespace generate --points 1000000 --size 12800 --output bees.csv\n"
    "  beespace generate --points 150000 --size 66000x46000x9600 --seed 7 --output bees.npy\n"
    "  beespace generate --scene clusters --points 100000 --clusters 50 --sigma 200\n"
    "  beespace generate --area medellin --points 1000 --output bees.csv\n"
    "  beespace generate --points 1000 | beespace detect --threshold 500\n"
    "  beespace generate --scene flight --points 1000 | beespace predict --threshold 10\n"
    "  beespace generate --scene head-on --points 20 --duration 60 | beespace replay";

void add_swarm_options(CLI::App& generate, GenerateOptions& options) {
  generate.add_option("--points", options.points, "How many bees")
      ->required()
      ->type_name("N")
      ->group("Swarm");
  CLI::Option* scene =
      generate
          .add_option("--scene", options.scene, "How they are spread, and how they fly: see below")
          ->type_name("SCENE")
          ->group("Swarm");
  allow_only(*scene, {"uniform", "clusters", "area", "flight", "head-on", "crossing", "sphere-swap",
                      "encounters"});
  generate
      .add_option("--size", options.size,
                  "The box, or its side, or the diameter of the\nsphere, in metres (default: "
                  "12800, or 1000 for\nbees that fly)")
      ->type_name("SIDE|AxBxC")
      ->group("Swarm");
  generate.add_option("--clusters", options.clusters, "How many centres (default: 100)")
      ->type_name("N")
      ->group("Swarm");
  generate
      .add_option("--sigma", options.sigma, "How far from their centre bees are (default: 200)")
      ->type_name("LENGTH")
      ->group("Swarm");
  generate.add_option("--area", options.area, "A part of the Earth: medellin")
      ->type_name("NAME")
      ->group("Swarm");
  generate.add_option("--seed", options.seed, "Another number, another swarm (default: 1)")
      ->type_name("N")
      ->group("Swarm");
}

void add_flight_options(CLI::App& generate, GenerateOptions& options) {
  generate
      .add_option("--speed", options.speed,
                  "How fast bees fly, in metres per second\n(default: 5-20)")
      ->type_name("SPEED|LOW-HIGH")
      ->group("Flight");
  generate
      .add_option("--miss", options.miss,
                  "How far apart the pairs of head-on pass, and at\nmost those of encounters "
                  "(default: 10)")
      ->type_name("LENGTH")
      ->group("Flight");
  generate
      .add_option("--duration", options.duration,
                  "Write a recording that lasts so long\n(default: everybody at one instant)")
      ->type_name("SECONDS")
      ->group("Flight");
  generate
      .add_option("--interval", options.interval,
                  "About how long from fix to fix of a bee (default: 1)")
      ->type_name("SECONDS")
      ->group("Flight");
}

void add_output_options(CLI::App& generate, GenerateOptions& options) {
  generate
      .add_option("-o,--output", options.output, "Where the swarm goes (default: standard output)")
      ->type_name("FILE")
      ->group("Output");
  CLI::Option* format =
      generate.add_option("--format", options.format, "Where the ending does not say")
          ->type_name("csv|tsv|npy|bin[.gz]")
          ->group("Output");
  allow_only(*format, {"csv", "tsv", "npy", "bin", "csv.gz", "tsv.gz", "npy.gz", "bin.gz"});
  // There is nothing to silence; scripts may say it to all subcommands alike.
  generate.add_flag("--quiet")
      ->description("Only errors; generate never says more")
      ->group("Output");
}

}  // namespace

CLI::App* add_generate_command(CLI::App& command, GenerateOptions& options) {
  CLI::App* generate = command.add_subcommand("generate", kDescription);
  generate->footer(kDetails);
  generate->set_version_flag("--version", std::string(version()), "Print the version and exit");
  add_swarm_options(*generate, options);
  add_flight_options(*generate, options);
  add_output_options(*generate, options);
  refuse_pointless_values(*generate);
  return generate;
}

}  // namespace beespace::cli
