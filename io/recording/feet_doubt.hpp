// Heights in feet and speeds in knots that only the names of a known source tell, which others have
// in metres: whether a height, a speed, or the ways from record to record bear them out.
#pragma once

#include "io/units/unit_taken.hpp"

#include <beespace/mover.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <optional>
#include <vector>

namespace beespace::io {

// Of positions in degrees.
class FeetDoubt {
 public:
  // Whether units are told by names alone, so that there is something to doubt.
  static bool concerns(const std::vector<UnitTaken>& units);

  void take_height(double metres);
  // What a record says of the velocity, which may have not-a-numbers.
  void take_speed(const Velocity& stated);
  // The same record and the next one of that bee.
  void take_step(const Fix& from, const Velocity& stated, const Fix& to);

  // Errors: kInvalidArgument, without source, where nothing bears them out.
  [[nodiscard]] std::optional<Error> doubt() const;

 private:
  double highest_m_ = 0.0;
  double fastest_mps_ = 0.0;
  std::vector<double> ratios_;  // of speeds by places to those that are stated
};

}  // namespace beespace::io
