#include "cli/generate_command.hpp"
#include "cli/option_checks.hpp"

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
    "Examples:\n"
    "  beespace generate --points 1000000 --size 12800 --output bees.csv\n"
    "  beespace generate --points 150000 --size 66000x46000x9600 --seed 7 --output bees.npy\n"
    "  beespace generate --scene clusters --points 100000 --clusters 50 --sigma 200\n"
    "  beespace generate --area medellin --points 1000 --output bees.csv\n"
    "  beespace generate --points 1000 | beespace detect --threshold 500";

void add_swarm_options(CLI::App& generate, GenerateOptions& options) {
  generate.add_option("--points", options.points, "How many bees")
      ->required()
      ->type_name("N")
      ->group("Swarm");
  CLI::Option* scene = generate
                           .add_option("--scene", options.scene,
                                       "Evenly in a box, around centres in a cube, or on Earth")
                           ->type_name("uniform|clusters|area")
                           ->group("Swarm");
  allow_only(*scene, {"uniform", "clusters", "area"});
  generate.add_option("--size", options.size, "The box, or its side, in metres (default: 12800)")
      ->type_name("SIDE|AxBxC")
      ->group("Swarm");
  generate.add_option("--clusters", options.clusters, "How many centres (default: 100)")
      ->type_name("N")
      ->group("Swarm");
  generate
      .add_option("--sigma", options.sigma, "How far from their centre bees are (default: 200)")
      ->type_name("METRES")
      ->group("Swarm");
  generate.add_option("--area", options.area, "A part of the Earth: medellin")
      ->type_name("NAME")
      ->group("Swarm");
  generate.add_option("--seed", options.seed, "Another number, another swarm (default: 1)")
      ->type_name("N")
      ->group("Swarm");
}

void add_output_options(CLI::App& generate, GenerateOptions& options) {
  generate
      .add_option("--output", options.output, "Where the swarm goes (default: standard output)")
      ->type_name("FILE")
      ->group("Output");
  CLI::Option* format =
      generate.add_option("--format", options.format, "Where the ending does not say")
          ->type_name("csv|tsv|npy|bin[.gz]")
          ->group("Output");
  allow_only(*format, {"csv", "tsv", "npy", "bin", "csv.gz", "tsv.gz", "npy.gz", "bin.gz"});
  // There is nothing to silence; scripts may say it to both subcommands alike.
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
  add_output_options(*generate, options);
  refuse_pointless_values(*generate);
  return generate;
}

}  // namespace beespace::cli
