// Which drones are seen to fly, and what follows for those that are not.
//
// A drone that has flown and stands as its log ends has landed; one that stands as its log begins
// and then takes off stood before. Of one that is never in the air in its own records neither is
// known: where these end before others fly, or begin after that, it may have flown unheard.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>
#include <beespace/point.hpp>

#include <optional>
#include <vector>

namespace beespace::analysis {

class Airborne {
 public:
  // Of logs of autopilots and of shows; of all else, and of a recording of which only the ends are
  // kept, nothing is told.
  explicit Airborne(const io::Recording& recording);

  // When others fly before its first fix and after its last one, each for longer than a gap: of a
  // drone that is never in the air itself.
  [[nodiscard]] std::vector<TimeSpan> unseen(PointId bee, double max_gap_s) const;

 private:
  const io::Recording& recording_;
  bool tells_ = false;
  std::vector<bool> flies_;         // by bee
  std::optional<TimeSpan> flight_;  // from the first one that flies to the last one
};

// Who is recorded while no other is, as by a log of another day, where others are at the same time:
// it is compared with none. Nothing where all are alone, or each is known for an instant, and of
// shows, which are one plan. Of tables of drones whose clock has no time zone these are also
// several that are recorded together, but while none of most of the others is, and begin as much
// earlier or later than these as two zones are apart, as where two computers wrote the tables.
std::vector<PointId> recorded_alone(const io::Recording& recording);

// How much later those begin than the others, by the middle of both.
std::optional<double> alone_begins_s(const io::Recording& recording,
                                     const std::vector<PointId>& alone);

// The whole quarters of an hour that two clocks are apart which begin one flight about then, as far
// as two time zones may be; nothing where it is another time.
std::optional<double> zones_apart_s(double apart_s);

}  // namespace beespace::analysis
