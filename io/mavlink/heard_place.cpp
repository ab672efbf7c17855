#include "io/mavlink/heard_place.hpp"

#include "io/aircraft/aircraft_report.hpp"
#include "io/frames/track_domain.hpp"
#include "io/problems/skipped_records.hpp"

#include <beespace/point.hpp>

#include <cmath>
#include <string>

namespace beespace::io {

std::optional<Error> position_problem(const Heard& heard) {
  const Point& at = heard.at.position;
  std::optional<Error> error;
  if (heard.at.global()) {
    error = impossible_place(at);
  } else if (!std::isfinite(at.x + at.y + at.z)) {
    error =
        Error{ErrorCode::kNotFinite, "its position is not a number" + std::string(kOrLeaveOut), {}};
  } else if (!in_motion_domain(at.x) || !in_motion_domain(at.y) || !in_motion_domain(at.z)) {
    error = Error{ErrorCode::kOutsideDomain,
                  "its position cannot be computed with exactly; use 0, or a size of " +
                      std::string(kMotionDomain) + " m" + std::string(kOrLeaveOut),
                  {}};
  }
  if (error) {
    std::string whose = "system ";
    error->message.insert(0, whose.append(std::to_string(heard.system)).append(": "));
  }
  return error;
}

}  // namespace beespace::io
