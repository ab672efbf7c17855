#include "cli/command_line/option_values.hpp"
#include "cli/generate/generate_command.hpp"
#include "cli/generate/generate_moving.hpp"
#include "cli/generate/generate_values.hpp"

#include <beespace/point.hpp>

#include <algorithm>
#include <initializer_list>
#include <memory>
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
    "  sphere-swap  all bees through the centre of a sphere to its other side\n"
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

void add_swarm_options(Command& generate, GenerateRequest& request) {
  generate.group("Swarm");
  generate.option("--points", "N", request.points, whole(1, kMaxPoints), "How many bees").required =
      true;
  generate.choice(
      "--scene", request.scene,
      {"uniform", "clusters", "area", "flight", "head-on", "crossing", "sphere-swap", "encounters"},
      "How they are spread, and how they fly: see below", "SCENE");
  generate.option("--size", "SIDE|AxBxC", request.size, read_size,
                  "The box, or its side, or the diameter of the\nsphere, in metres (default: "
                  "12800, or 1000 for\nbees that fly)");
  generate.option("--clusters", "N", request.clusters, whole(1, kMaxPoints),
                  "How many centres (default: 100)");
  generate.option("--sigma", "LENGTH", request.sigma_m, read_length,
                  "How far from their centre bees are (default: 200)");
  generate.option("--area", "NAME", request.area, "A part of the Earth: medellin").words = {
      "medellin"};
  generate.option("--seed", "N", request.seed, read_seed,
                  "Another number, another swarm (default: 1)");
}

void add_flight_options(Command& generate, GenerateRequest& request) {
  generate.group("Flight");
  generate.option("--speed", "SPEED|LOW-HIGH", request.speeds, read_speeds,
                  "How fast bees fly, in metres per second\n(default: 5-20)");
  generate.option("--miss", "LENGTH", request.miss_m, read_distance,
                  "How far apart the pairs of head-on pass, and at\nmost those of encounters "
                  "(default: 10)");
  generate.option("--duration", "SECONDS", request.duration_s, read_seconds,
                  "Write a recording that lasts so long\n(default: all bees at one instant)");
  generate.option("--interval", "SECONDS", request.interval_s, read_seconds,
                  "About how long from fix to fix of a bee (default: 1)");
}

void add_output_options(Command& generate, GenerateRequest& request) {
  generate.group("Output");
  generate.option("-o,--output", "FILE", request.output,
                  "Where the swarm goes (default: standard output)");
  generate.choice("--format", request.format,
                  {"csv", "tsv", "npy", "bin", "csv.gz", "tsv.gz", "npy.gz", "bin.gz"},
                  "Where the ending does not say", "csv|tsv|npy|bin[.gz]");
  // There is nothing to silence; scripts may say it to all subcommands alike.
  generate.flag("--quiet", request.quiet, "Only errors; generate never says more");
}

// The scene that the other options speak of.
std::string scene_of(const Command& command) {
  const auto is_any_given = [&](std::initializer_list<const char*> options) {
    return std::any_of(options.begin(), options.end(),
                       [&](const char* option) { return command.is_given(option); });
  };
  if (is_any_given({"--area"})) return "area";
  if (is_any_given({"--clusters", "--sigma"})) return "clusters";
  return is_any_given({"--speed", "--duration", "--interval"}) ? "flight" : "uniform";
}

// An option that the scene would ignore is a misunderstanding.
Status check_fit(const Command& command, const std::string& scene) {
  const bool moving = is_moving_scene(scene);
  const bool pairs = scene == "head-on" || scene == "encounters";
  const struct {
    const char* name;
    bool fits;
  } table[] = {
      {"--size", scene != "area" && scene != "encounters"},
      {"--clusters", scene == "clusters"},
      {"--sigma", scene == "clusters"},
      {"--area", scene == "area"},
      {"--speed", moving},
      {"--miss", pairs},
      {"--duration", moving},
      {"--interval", moving},
  };
  for (const auto& option : table) {
    if (option.fits || !command.is_given(option.name)) continue;
    return generate_error(std::string(option.name) + " does not apply to --scene " + scene);
  }
  if (command.is_given("--interval") && !command.is_given("--duration")) {
    return generate_error("--interval is about recordings; add --duration SECONDS");
  }
  return std::monostate{};
}

Result<SwarmFormat> format_of(const GenerateRequest& request) {
  const bool named = request.output != "-";
  if (!request.format.empty()) {
    const SwarmFormat format = *swarm_format("." + request.format);
    if (!named || ending_allows(request.output, format)) return format;
    return generate_error("--format " + request.format + " contradicts the ending of '" +
                          request.output + "'; correct one of them");
  }
  if (!named) return SwarmFormat{};
  if (const auto format = swarm_format(request.output)) return *format;
  return generate_error("the ending of '" + request.output +
                        "' does not tell the format; add --format csv, tsv, npy or bin");
}

Status settle(const Command& command, GenerateRequest& request) {
  const auto format = format_of(request);
  if (!format) return format.error();
  request.swarm_format = *format;
  if (request.scene.empty()) request.scene = scene_of(command);
  return check_fit(command, request.scene);
}

}  // namespace

Command generate_command() {
  const auto request = std::make_shared<GenerateRequest>();
  Command generate("generate", kDescription, kDetails, [request](const Command& command) {
    return settle(command, *request).and_then([&] { return run_generate(*request); });
  });
  add_swarm_options(generate, *request);
  add_flight_options(generate, *request);
  add_output_options(generate, *request);
  return generate;
}

}  // namespace beespace::cli
