// Which word a mistyped one may have been meant to be.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::cli {

// The known word that begins with this one, of three characters or more; else the one that is
// fewest edits away (insert, delete, replace), if it takes at most a third of the word's length.
// The first of several.
std::optional<std::string> most_similar(std::string_view word,
                                        const std::vector<std::string>& known);

}  // namespace beespace::cli
