// While a drone says that it has landed it stands on the ground. It is compared with those that
// fly, as others may come close to it; two that both stand are no conflict.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace beespace::analysis {

// Whether any drone says when it has landed.
bool says_who_has_landed(const io::Recording& recording);

// Whether this bee surely stands on the ground then, by its own records.
bool has_landed(const io::Recording& recording, PointId track, double time_s);

// Whether both do when they are closest.
bool both_stand(const io::Recording& recording, const Conflict& encounter);

// Takes out the conflicts of two that both stand as long as it lasts, and cuts others to the time
// in which one of the two flies, the closest of which is then told; returns how many were taken
// out. Those that are not certain stay whole: they may be of other ways than these tracks, in which
// `options` found the conflicts. Errors: those of find_conflicts().
Result<std::size_t> leave_out_standing(const io::Recording& recording,
                                       const std::vector<Track>& tracks,
                                       const ConflictOptions& options,
                                       std::vector<Conflict>& conflicts);

// Of these, those in which one of the two stands as long as they last. What is decided of drones of
// a show that stand at its ends is another matter (show_conflicts.hpp).
std::vector<Conflict> beside_landed(const io::Recording& recording,
                                    const std::vector<Conflict>& conflicts);

// The closest two of all that fly, in the geometry of the tracks; nothing where no two do at the
// same time. Errors: those of find_closest_encounter().
Result<std::optional<Conflict>> closest_of_flying(const io::Recording& recording,
                                                  const std::vector<Track>& tracks,
                                                  double max_gap_s, const RunOptions& run);

// As closest_of_each(), of those that fly: of each bee in all its flights.
Result<std::vector<std::optional<Conflict>>> closest_of_each_flying(
    const io::Recording& recording, const std::vector<Track>& tracks, double threshold_m,
    double max_gap_s, unsigned threads);

}  // namespace beespace::analysis
