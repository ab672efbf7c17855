// `beespace generate`: its options, and what it does with them.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/console/exit_code.hpp"

#include <string>

namespace beespace::cli {

// As typed, before it is checked.
struct GenerateOptions {
  std::string scene;  // empty: what the other options speak of, or else uniform
  std::string points;
  std::string size;
  std::string clusters;
  std::string sigma;
  std::string area;
  std::string speed;
  std::string miss;
  std::string duration;
  std::string interval;
  std::string seed = "1";
  std::string output = "-";
  std::string format;  // empty: by the output's ending
  bool quiet = false;  // there is nothing to silence
};

// `options` must outlive it.
Command generate_command(GenerateOptions& options);

ExitCode run_generate(const GenerateOptions& options);

}  // namespace beespace::cli
