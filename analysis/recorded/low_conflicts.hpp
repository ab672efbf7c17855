// Conflicts of two that are both low above the places from which they took off, as the neighbours
// of a take-off grid are: they are left out where that is asked for, and counted.
#pragma once

#include "io/recording/recorded_noun.hpp"
#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace beespace::analysis {

struct LowConflicts {
  double below_m = 0.0;
  std::vector<Conflict> left_out = {};
  // Of so many it is not known where they took off: none of their conflicts is left out.
  std::size_t bees_not_known = 0;
  bool of_table = false;  // which may have a column that tells it
  // Where it is not asked for: what would be left out by the distance that is too close, if that is
  // that of neighbours in a grid.
  std::size_t would_leave_out = 0;

  // The closest of them.
  [[nodiscard]] std::optional<Conflict> closest() const;
};

// Takes out of `conflicts` those in which both are all the time less than `below_m` above, or
// below, the place from which they took off. That is known of drones of a show that begin on its
// ground, of those whose log begins while they say that they have landed, and of those whose table
// or telemetry says it (io::TakeOffs). Conflicts that are only possible stay.
LowConflicts leave_out_low(const io::Recording& recording, double below_m,
                           std::vector<Conflict>& conflicts);

// How many leave_out_low() would take out; 0 where one of these is closer than neighbours in a grid
// of drones are, beside that threshold.
std::size_t would_leave_out_low(const io::Recording& recording, double threshold_m,
                                const std::vector<Conflict>& conflicts);

// Whether conflicts of which the closest is that close may be those of neighbours in a grid.
bool may_be_of_grid(double closest_m, double threshold_m);

// The height from which a bee took off, where that is known; not of shows.
std::optional<double> took_off_at_m(const io::Recording& recording, PointId bee);

// "72 conflicts of two lower than 3 m above where they took off".
std::string low_text(const LowConflicts& low);
// "of 2 bees it is not known where they took off: none of theirs is left out"; empty where there is
// none.
std::string takeoff_unknown_text(const LowConflicts& low, const io::RecordedNoun& noun = {});

// Takes those that were left out away from some of the same.
void leave_out_too(const LowConflicts& low, std::vector<Conflict>& some);

}  // namespace beespace::analysis
