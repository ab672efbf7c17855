// A piece of the input as an error message shows it: short, quoted, harmless to a terminal.
#pragma once

#include <string>
#include <string_view>

namespace beespace::io {

// "'abc'": at most about 40 characters, the rest as "...", control bytes and broken UTF-8 as \xNN.
std::string excerpt(std::string_view text);

}  // namespace beespace::io
