#include "c_io/wording.hpp"

#include <cstddef>
#include <string_view>
#include <utility>

namespace beespace::c_io {

namespace {

struct Wording {
  std::string_view command;
  std::string_view program;
};

// Longer ones first, where one begins as another one.
constexpr Wording kWordings[] = {
    {"give it with --obstacles to 'beespace simulate', 'advise' or 'verify'",
     "read it as obstacles"},
    {"'beespace replay' and 'beespace predict' read it", "read it as a recording"},
    {"'beespace replay' reads the show", "read the show as a recording"},
    {"with which 'beespace predict' needs no time", "with which no time is needed"},
    {"which 'beespace replay' reads", "which is read as a recording"},
    {"'beespace detect' reads it", "read it as points"},
    {"'beespace replay' reads it", "read it as a recording"},
    {"'beespace watch' reads it", "the command 'beespace watch' reads it"},
    {"ask 'beespace predict' about it, with --horizon 0 for now only", "read it as a recording"},
    {"ask 'beespace predict' about it", "read it as a recording"},
    {"ask 'beespace replay' about it", "read it as a recording"},
    {"ask 'beespace detect'", "read it as points"},
    {"is for 'beespace replay'", "is read as a recording"},
    {"--time-unit", "time_unit"},
    {"--one-clock", "one_clock"},
    {"--time-zone", "time_zone"},
    {"--dates", "dates"},
    {"--scale", "scale"},
    {"--fps", "fps"},
    {"--least-likelihood", "least_likelihood"},
    {"--skip-bad", "skip_bad"},
    {"--columns", "columns"},
    {"--crs", "frame"},
    {"--units", "units"},
    {"--heights", "heights"},
    {"--format", "format"},
    {"--grounded", "grounded"},
    {"--threshold", "threshold"},
    {"--vertical", "vertical"},
    {"--inclusive", "inclusive"},
    {"--max-gap", "max_gap"},
    {"--ignore-below", "ignore_below"},
    {"--max-age", "max_age"},
};

}  // namespace

std::string in_words_of_programs(std::string text) {
  for (const Wording& wording : kWordings) {
    for (std::size_t at = text.find(wording.command); at != std::string::npos;
         at = text.find(wording.command, at + wording.program.size())) {
      text.replace(at, wording.command.size(), wording.program);
    }
  }
  return text;
}

Error in_words_of_programs(Error error) {
  error.message = in_words_of_programs(std::move(error.message));
  return error;
}

}  // namespace beespace::c_io
