// What every option's value is held to while the command line is read.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
class Option;
}  // namespace CLI

namespace beespace::cli {

// One of a few words; a mistyped one is told which was meant.
void allow_only(CLI::Option& option, const std::vector<std::string>& words);
// The same, or what `otherwise` says of; `hint` tells of that: "nor has it a '.', as files do".
void allow_only_or(CLI::Option& option, const std::vector<std::string>& words,
                   const std::function<bool(const std::string&)>& otherwise,
                   const std::string& hint);

// For every option and argument that the command has by now: refuses an empty text, as an unset
// variable of a script leaves it, and for flags any value ("--csv=5").
void refuse_pointless_values(CLI::App& command);

}  // namespace beespace::cli
