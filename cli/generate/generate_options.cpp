#include "cli/generate/generate_command.hpp"

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

void add_swarm_options(Command& generate, GenerateOptions& options) {
  generate.group("Swarm");
  generate.option("--points", "N", options.points, "How many bees").required = true;
  generate.choice(
      "--scene", options.scene,
      {"uniform", "clusters", "area", "flight", "head-on", "crossing", "sphere-swap", "encounters"},
      "How they are spread, and how they fly: see below", "SCENE");
  generate.option("--size", "SIDE|AxBxC", options.size,
                  "The box, or its side, or the diameter of the\nsphere, in metres (default: "
                  "12800, or 1000 for\nbees that fly)");
  generate.option("--clusters", "N", options.clusters, "How many centres (default: 100)");
  generate.option("--sigma", "LENGTH", options.sigma,
                  "How far from their centre bees are (default: 200)");
  generate.option("--area", "NAME", options.area, "A part of the Earth: medellin");
  generate.option("--seed", "N", options.seed, "Another number, another swarm (default: 1)");
}

void add_flight_options(Command& generate, GenerateOptions& options) {
  generate.group("Flight");
  generate.option("--speed", "SPEED|LOW-HIGH", options.speed,
                  "How fast bees fly, in metres per second\n(default: 5-20)");
  generate.option("--miss", "LENGTH", options.miss,
                  "How far apart the pairs of head-on pass, and at\nmost those of encounters "
                  "(default: 10)");
  generate.option("--duration", "SECONDS", options.duration,
                  "Write a recording that lasts so long\n(default: everybody at one instant)");
  generate.option("--interval", "SECONDS", options.interval,
                  "About how long from fix to fix of a bee (default: 1)");
}

void add_output_options(Command& generate, GenerateOptions& options) {
  generate.group("Output");
  generate.option("-o,--output", "FILE", options.output,
                  "Where the swarm goes (default: standard output)");
  generate.choice("--format", options.format,
                  {"csv", "tsv", "npy", "bin", "csv.gz", "tsv.gz", "npy.gz", "bin.gz"},
                  "Where the ending does not say", "csv|tsv|npy|bin[.gz]");
  // There is nothing to silence; scripts may say it to all subcommands alike.
  generate.flag("--quiet", options.quiet, "Only errors; generate never says more");
}

}  // namespace

Command generate_command(GenerateOptions& options) {
  Command generate("generate", kDescription, kDetails,
                   [&options] { return run_generate(options); });
  add_swarm_options(generate, options);
  add_flight_options(generate, options);
  add_output_options(generate, options);
  return generate;
}

}  // namespace beespace::cli
