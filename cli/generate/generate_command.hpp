// `beespace generate`: its options, and what it does with them.
#pragma once

#include "cli/console/exit_code.hpp"

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

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
};

// Adds the subcommand to the command; `options` must outlive the parsing.
CLI::App* add_generate_command(CLI::App& command, GenerateOptions& options);

ExitCode run_generate(const GenerateOptions& options);

}  // namespace beespace::cli
