// Which bee was to fly what was set for which.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/mover.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace beespace::cli {

struct Match {
  std::size_t flown;
  std::size_t set;
};

struct Matches {
  std::vector<Match> pairs = {};
  bool by_numbers = false;    // as no ids are the same
  bool by_take_offs = false;  // nor numbers: for the time being, in the order of take-offs
};

std::vector<std::string> ids_of(const io::Recording& recording);

// By ids that are the same, or where none is by their numbers.
Matches matches_of(const std::vector<std::string>& flown, const std::vector<std::string>& set);

// The fixes of a bee whose z are heights: tracks of what is in degrees are not so.
std::span<const Fix> fixes_with_heights(const io::Recording& recording,
                                        const std::vector<Track>& tracks, std::size_t bee);

// Where neither does: in the order of take-offs, which tells of all together when they were begun,
// and from which height, but not which is which. Both are by bee.
using FixesByBee = std::vector<std::span<const Fix>>;
void match_by_take_offs(const FixesByBee& flown, const FixesByBee& set, Matches& matches);

// The same once both are in one frame and by one clock: where ids are matched by their numbers, and
// most bees begin where another one was set to, or ids tell nothing, each flies what was set to
// begin where it began. So does one that has no match, as a spare, where that of another one was
// not flown. Errors: kUnsupportedFormat where that is not clear.
Status settle_matches(const std::vector<Track>& flown, const std::vector<Track>& set,
                      const std::vector<std::string>& flown_ids,
                      const std::vector<std::string>& set_ids, Matches& matches,
                      std::vector<std::string>& notes);

}  // namespace beespace::cli
