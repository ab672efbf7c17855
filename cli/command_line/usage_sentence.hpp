// What is wrong with a command line that could not be read, in beespace's own words.
#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
class ParseError;
}  // namespace CLI

namespace beespace::cli {

// "detect, predict or help": what it can be told to do.
std::string names_of_subcommands(const CLI::App& command);

// `command` is the whole command after its parse() threw `error`.
std::string usage_sentence(const CLI::App& command, const CLI::ParseError& error);

}  // namespace beespace::cli
