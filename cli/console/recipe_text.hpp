// Lines that messages say to type, with what was typed: so that they can be pasted as they stand.
#pragma once

#include <string>

namespace beespace::cli {

// The name of a file within a line to type that stands in single quotes itself: in double ones
// where a shell would not take it for one word.
std::string typed_name(const std::string& file);

// `message` with the name of the file for the word FILE, where there is such a file, and
// "--threshold 5 --vertical 2" or "--separation enroute", as typed, for io::kYourThreshold; where
// no threshold was typed that stays as it is.
struct TypedSeparation {
  std::string threshold = {};
  std::string separation = {};
  std::string vertical = {};
};
std::string with_what_was_typed(std::string message, const std::string& file,
                                const TypedSeparation& typed);

}  // namespace beespace::cli
