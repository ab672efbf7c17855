// What the readers say to users of the command, in the words of those who call them from a
// program.
#pragma once

#include <beespace/result.hpp>

#include <string>

namespace beespace::c_io {

// Options by the names of the fields and flags of beespace_io_options: "--skip-bad" is "skip_bad".
std::string in_words_of_programs(std::string text);

Error in_words_of_programs(Error error);

}  // namespace beespace::c_io
