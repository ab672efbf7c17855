#include "cli/guide/guide_intro.hpp"

#include "cli/console/summary_line.hpp"
#include "io/bytes/number_text.hpp"

namespace beespace::cli {
namespace {

using io::exact;

std::string shape_text(const GuideRequest& request) {
  const Separation& shape = request.options.separation;
  if (shape.shape == SeparationShape::kEllipsoid) {
    return ", and " + exact(shape.vertical_factor) + " times that in height";
  }
  if (shape.shape == SeparationShape::kCylinder) {
    return " horizontally, or " + exact(shape.vertical_m) + " m in height";
  }
  return "";
}

std::string limits_text(const FlightLimits& limits) {
  return exact(limits.max_speed_mps) + " m/s, " + exact(limits.max_acceleration_mps2) + " m/s^2";
}

// Of a loop on board the error of reports is none of the position that it flies by.
const char* error_word(const FleetFigures& figures) {
  const bool reports = figures.loop == LoopPlace::kOnboard && figures.report_error_m > 0.0;
  return reports ? "sensing" : "position";
}

}  // namespace

std::string guide_intro(const GuideRequest& request, const Tube& tube, std::uint32_t epoch,
                        std::size_t missing) {
  const GuideOptions& options = request.options;
  const bool ground = options.figures.loop == LoopPlace::kGround;
  std::string out;
  append_summary_line(out, "loop", ground ? "closed on the ground" : "closed on board");
  append_summary_line(out, "tube",
                      io::length(tube.radius_m) + " around the nominal path (of it " +
                          io::length(tube.clock_m) + " for clocks)");
  if (!(tube.radius_m > 0.0)) {
    append_summary_line(out, "note",
                        std::string("no ") + error_word(options.figures) +
                            " error, deviation or clock error is given: agents are "
                            "taken to be exactly where they are told to be");
  }
  append_summary_line(out, "threshold",
                      exact(options.threshold_m) + " m between true positions" +
                          shape_text(request) + "; nominal paths keep " +
                          io::length(options.threshold_m + 2.0 * tube.radius_m));
  append_summary_line(out, "planned",
                      limits_text(tube.planned) + " (of " + limits_text(options.limits) + ")");
  append_summary_line(out, "tick",
                      exact(options.link.period_s) + " s; commands take effect after " +
                          std::to_string(options.link.command_delay));
  append_summary_line(out, "epoch", std::to_string(epoch));
  if (missing > 0) {
    append_summary_line(out, "missing",
                        io::counted(missing, "agent", "agents") +
                            " of the planner before; none is certified until "
                            "all have been heard of, or left");
  }
  if (!request.mavlink) {
    append_summary_line(out, "agents",
                        "beespace follow --period " + exact(options.link.period_s) +
                            " --planned-speed " + exact(tube.planned.max_speed_mps) +
                            " --planned-acceleration " + exact(tube.planned.max_acceleration_mps2) +
                            " --agent ID");
  }
  return out;
}

}  // namespace beespace::cli
