// Whether a closed line of corners encloses one region, or crosses itself. Decided exactly.
#pragma once

#include <beespace/obstacle.hpp>

#include <cstddef>
#include <optional>
#include <span>

namespace beespace::obstacles {

// The last corner may repeat the first one: then without it.
std::span<const Corner> without_closing_corner(std::span<const Corner> outline);

bool all_on_one_line(std::span<const Corner> corners);

// Two edges that have a place in common, although no corner joins them; each is named by the
// corner that it begins at.
struct Crossing {
  std::size_t first;
  std::size_t second;
};
// For corners that are not all on one line, none at the place of the one before it. An edge that
// goes back along the one before it is found too, as the next one then begins on that. Cost: n^2.
std::optional<Crossing> first_crossing(std::span<const Corner> corners);

}  // namespace beespace::obstacles
