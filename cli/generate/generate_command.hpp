// `beespace generate`.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/output/swarm_output.hpp"
#include "scenes/moving_scenes.hpp"

#include <beespace/point.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace beespace::cli {

struct GenerateRequest {
  std::string scene;  // where it is not given, what the other options speak of, or uniform
  std::uint64_t points = 0;
  std::optional<Point> size;  // of a box; absent: as usual for the scene
  std::uint64_t clusters = 100;
  double sigma_m = 200.0;
  std::string area = "medellin";
  scenes::Speeds speeds{5.0, 20.0};
  double miss_m = 10.0;
  std::optional<double> duration_s;  // absent: no recording
  double interval_s = 1.0;
  std::uint64_t seed = 1;
  std::string output = "-";
  std::string format;  // empty: by the ending of the output
  SwarmFormat swarm_format;
  bool quiet = false;  // there is nothing to silence
};

Command generate_command();

Result<ExitCode> run_generate(const GenerateRequest& request);

}  // namespace beespace::cli
