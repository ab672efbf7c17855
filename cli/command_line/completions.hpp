// What the shells offer while a command line is typed, from the descriptions of the subcommands.
#pragma once

#include "cli/command_line/command.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::cli {

// The file that the shell reads: of "bash", "zsh" or "fish"; of "man" how the manual's entries
// begin, one a line behind subcommand and option. Nothing for other words.
std::optional<std::string> completions_for(std::string_view shell,
                                           const std::vector<Command>& commands);

}  // namespace beespace::cli
