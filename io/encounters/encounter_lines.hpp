// Lines of files that simulators of air traffic read.
#pragma once

#include "io/bytes/characters.hpp"

#include <string_view>

namespace beespace::io {

// A blank line, or a comment: one that begins with "#".
inline bool says_nothing(std::string_view line) {
  const std::string_view text = without_padding(line);
  return text.empty() || text.front() == '#';
}

}  // namespace beespace::io
