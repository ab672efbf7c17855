// Which bee was to fly what was set for which.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace beespace::cli {

struct Match {
  std::size_t flown;
  std::size_t set;
};

struct Matches {
  std::vector<Match> pairs = {};
  bool by_numbers = false;  // as no ids are the same
};

std::vector<std::string> ids_of(const io::Recording& recording);

// By ids that are the same, or where none is by their numbers.
Matches matches_of(const std::vector<std::string>& flown, const std::vector<std::string>& set);

// The same once both are in one frame and by one clock: where ids are matched by their numbers, and
// most bees begin where another one was set to, each flies what was set to begin where it began.
// Errors: kUnsupportedFormat where that is not clear.
Status settle_matches(const std::vector<Track>& flown, const std::vector<Track>& set,
                      const std::vector<std::string>& flown_ids,
                      const std::vector<std::string>& set_ids, Matches& matches,
                      std::vector<std::string>& notes);

}  // namespace beespace::cli
