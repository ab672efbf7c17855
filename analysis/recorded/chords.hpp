// How far the straight line between two fixes may be from what was flown where a bee turns, as
// gliders that circle do, whose logs tell no velocities: as far as the arc that turns as much from
// fix to fix as the track does there. A conflict that is nearer to the threshold than that is
// possible, not certain; and conflicts one after the other between which the two may have stayed
// closer, as chords cut their circles, are told as one.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace beespace::analysis {

struct Chords {
  double most_off_m =
      0.0;  // of those at whose closest straight lines may be off by more than little
  std::size_t possible = 0;  // conflicts
  std::size_t joined = 0;    // conflicts that are parts of others now
};

// Of aircraft without velocities, whose conflicts these are; of others nothing is done. With a
// vertical threshold how close two are across when they are worst is what counts.
Chords doubt_chords(const io::Recording& recording, const std::vector<Track>& tracks,
                    const ConflictOptions& options, std::vector<Conflict>& conflicts);

// "where two turn that are in conflict, straight lines between fixes may be off by up to 19.3 m,
// and so may how close they come; 300 conflicts are possible, not certain"; nothing where none is
// off.
std::string chords_text(const Chords& chords);

}  // namespace beespace::analysis
