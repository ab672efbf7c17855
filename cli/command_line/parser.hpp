// Parses a command line by the descriptions of the subcommands; or says what is wrong with it, in
// beespace's own words.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/console/exit_code.hpp"

#include <string>
#include <vector>

namespace beespace::cli {

struct Program {
  std::string name;
  std::string summary;
  std::string examples;
  std::vector<Command> commands;
};

// Runs the subcommand that the line names, or prints the help, the version, or the error.
ExitCode run_command_line(Program& program, int argc, char** argv);

}  // namespace beespace::cli
