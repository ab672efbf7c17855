// The paths of a recording that a map file has room for.
#pragma once

#include "report/facts.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace beespace::report {

struct MapTrack {
  PointId bee = 0;
  std::vector<std::vector<Fix>> runs;  // from one gap to the next; none is empty
};

struct MapTracks {
  std::vector<MapTrack> tracks;      // ascending by bee
  std::vector<std::string> notes{};  // what was left out
};

// Of more bees than `most_tracks`, those in conflict first; of more fixes than about `most_fixes`,
// every second, third, ...
MapTracks map_tracks(const RecordingFacts& facts, std::size_t most_tracks, std::size_t most_fixes);

// What globes can show before they become slow.
inline constexpr std::size_t kMostTracks = 2'000;
inline constexpr std::size_t kMostTrackFixes = 500'000;
inline constexpr std::size_t kMostMarks = 20'000;

// How many of so many are shown, at most kMostMarks; says what is left out.
std::size_t marks_shown(std::size_t count, const std::string& what,
                        std::vector<std::string>& notes);

}  // namespace beespace::report
