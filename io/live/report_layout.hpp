// What live input needs beyond a table of fixes: the frame cannot wait for all values, and every
// line must say whose it is and when.
#pragma once

#include "io/aircraft/aircraft_report.hpp"
#include "io/live/report_lines.hpp"
#include "io/tracks/track_layout.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cmath>
#include <optional>

namespace beespace::io {

// `asked`: what the caller says of the frame. Errors: kMissingColumn without id or time,
// kUnknownFrame where the names do not tell the frame, or each vehicle counts from an origin of its
// own, kInvalidArgument where each counts heights from a ground of its own.
std::optional<Error> live_problem(const TrackLayout& layout, Frame asked);

// What a report of an aircraft says; its texts are those of `report`. Errors: those of choose().
Result<std::optional<ReportLine>> report_line(const AircraftReport& report,
                                              const AircraftChoice& choice, LeftOut& left_out);

// What is wrong with a position in degrees that is none.
std::optional<Error> out_of_range(const Point& position, Frame frame);

// The line says that velocity, of which not-a-numbers are not known.
inline void set_velocity(ReportLine& line, const Velocity& velocity) {
  line.stated_velocity = velocity;
  if (std::isfinite(velocity.x + velocity.y + velocity.z)) line.velocity = velocity;
}

}  // namespace beespace::io
