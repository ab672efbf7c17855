#include "cli/input/moving_options.hpp"

#include "cli/command_line/option_values.hpp"
#include "cli/console/terminal.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::cli {
namespace {

Result<io::UnitOverrides> read_units(const Typed& typed) {
  return io::read_unit_overrides(typed.text).transform_error([&](const Error& error) {
    return usage_error(typed.command, error.message);
  });
}

Result<io::TimeZone> read_time_zone(const Typed& typed) {
  return io::TimeZone::find(typed.text).transform_error([&](const Error& error) {
    return usage_error(typed.command, "--time-zone: " + error.message);
  });
}

Result<double> read_likelihood(const Typed& typed) {
  const auto least = io::parse_number(typed.text);
  if (least && *least >= 0.0 && *least <= 1.0) return *least;
  return usage_error(typed.command, "--least-likelihood is a number from 0 to 1, as 0.9; '" +
                                        typed.text + "' is none");
}

Result<io::StatedLength> read_pixel(const Typed& typed) {
  const auto stated = io::parse_stated(typed.text, io::Quantity::kLength);
  if (stated && stated->metric > 0.0 && std::isfinite(stated->metric)) return *stated;
  return usage_error(typed.command, "--scale is the length of a pixel, above 0, as in 0.1mm; '" +
                                        typed.text + "' is none");
}

}  // namespace

void add_frame_option(Command& command, io::Frame& frame, const char* help) {
  command.choice(
      "--crs", frame,
      {{"auto", io::Frame::kAuto}, {"wgs84", io::Frame::kWgs84}, {"metres", io::Frame::kMetres}},
      help);
}

void add_time_unit_option(Command& command, io::Unit& unit) {
  command.choice("--time-unit", unit,
                 {{"auto", io::Unit::kUnstated},
                  {"s", io::Unit::kSecond},
                  {"ms", io::Unit::kMillisecond},
                  {"us", io::Unit::kMicrosecond},
                  {"ns", io::Unit::kNanosecond}},
                 "Of times, where the input does not say");
}

void add_clock_and_pixel_options(Command& command, io::RecordingOptions& load) {
  command.option("--time-zone", "ZONE", load.time_zone, read_time_zone,
                 "Of dates and times that name none, and in which\ntimes are told: UTC, "
                 "Europe/Madrid, +02:00");
  command.choice("--dates", load.dates,
                 {{"auto", io::DateOrder::kUnsaid},
                  {"day-first", io::DateOrder::kDayFirst},
                  {"month-first", io::DateOrder::kMonthFirst}},
                 "Of dates as 05/06/2024, if none of them tells it");
  command.option("--fps", "N", load.frames_per_second, amount("frames a second", kAboveZero),
                 "Where a column counts frames: how many a second");
  command.option("--scale", "LENGTH", load.pixel, read_pixel,
                 "Of positions in pixels: how long one is, as 0.1mm");
}

void add_units_options(Command& command, io::UnitOverrides& units, io::HeightSource& heights) {
  command.option("--units", "LIST", units, read_units,
                 "Where the header names none: height=ft,speed=kt,\nclimb=ft/min, position=m; or "
                 "metric, or aviation\n(ft, kt, ft/min, and told in NM and ft too)");
  command.choice("--heights", heights,
                 {{"auto", io::HeightSource::kAuto},
                  {"geometric", io::HeightSource::kGeometric},
                  {"pressure", io::HeightSource::kPressure}},
                 "Of several heights, which to take (aircraft, tables)");
}

void add_input_options(Command& command, MovingRequest& request) {
  command.group("Input");
  add_frame_option(command, request.load.frame, "Whether positions are in degrees or metres");
  command.option("--columns", "LIST", request.load.columns,
                 "By number or name: id=1,time=2,x=3,y=4,z=5,vx=6");
  add_time_unit_option(command, request.load.time_unit);
  command.flag("--one-clock", request.load.one_clock,
               "Times of several files count from one zero, though\nnothing says so");
  add_clock_and_pixel_options(command, request.load);
  command.option(
      "--least-likelihood", "N", request.load.least_likelihood, read_likelihood,
      "Of poses (DeepLabCut, SLEAP): places less likely count\nas unknown (default: 0.6)");
  command.flag("--grounded", request.load.grounded,
               "Count those that stand on the ground as well (shows, logs, aircraft)");
  add_units_options(command, request.load.units, request.load.heights);
  command.flag("--skip-bad", request.load.skip_bad, "Leave bad records out and list them");
}

void add_max_gap_option(Command& command, std::optional<double>& max_gap_s) {
  command.option("--max-gap", "SECONDS|never", max_gap_s, read_max_gap,
                 "Unknown between fixes farther apart in time\n(default: 5 times the typical "
                 "interval)");
}

void add_gap_options(Command& command, std::optional<double>& max_gap_s, double& tolerance_m) {
  command.group("Input");
  add_max_gap_option(command, max_gap_s);
  command.option("--tolerance", "LENGTH", tolerance_m, amount("metres", kAboveZero),
                 "How closely to follow curves (default: 0.001)");
}

void add_sector_option(Command& command, io::RecordingOptions& load) {
  command.flag("--sector", load.sector,
               "A cut of a sector: before its first and after its\nlast fix an aircraft is "
               "outside, and not asked about\n(default: where it is then is unknown)");
}

void add_threshold_options(Command& command, MovingRequest& request) {
  command.group("Separation");
  command.option("--threshold", "LENGTH", request.threshold, read_stated_threshold_in_motion,
                 "Closer than this is too close (default: what the\ninput declares, or 2 for "
                 "shows, 5 for logs of drones,\notherwise 100; of aircraft it is asked for)");
  command.option("--vertical", "LENGTH", request.vertical, read_vertical, kVerticalHelp);
  add_usual_separation_option(command, request.separation);
  command.flag("--inclusive", request.inclusive, "A distance of exactly the threshold counts too");
  command.option("--threads", "N", request.threads, read_threads,
                 "How many threads work (default: 0, all)");
}

void add_low_option(Command& command, MovingRequest& request) {
  command.option(
      "--ignore-below", "LENGTH", request.ignore_below_m, amount("metres", kAboveZero),
      "Leave out, and count, conflicts of two that are both\nlower than this above where "
      "they took off, as in a\ntake-off grid (default: none is left out)");
}

void add_separation_options(Command& command, MovingRequest& request) {
  add_threshold_options(command, request);
  command.option("--max-results", "N", request.max_results, read_max_results,
                 "Fail beyond so many conflicts (default: no limit)");
}

void add_form_options(Command& command, MovingRequest& request) {
  command.group("Output");
  command.option("-o,--output", "FILE", request.output,
                 "Where the answer goes, by its ending .csv or .json,\nperhaps with .gz, in this "
                 "form (default: standard\noutput)");
  command.flag("--csv", request.csv, "With a header, values between commas");
  command.flag("--json", request.json, "One JSON document with everything in it");
}

void add_risk_option(Command& command, MovingRequest& request) {
  command.flag("--fail-on-risk", request.fail_on_risk,
               "Exit with 1 when there is a conflict, or a gap or\nrecords that were left out may "
               "hide one");
}

void add_quiet_option(Command& command, bool& quiet) {
  command.flag("--quiet", quiet, "No summary and no progress, only errors");
}

Status settle(MovingRequest& request, const char* command) {
  request.command = command;
  if (request.inputs.empty() && input_is_terminal()) {
    return usage_error(command, "say which file to read, or pipe the input in");
  }
  if (std::count(request.inputs.begin(), request.inputs.end(), "-") > 1) {
    return usage_error(command, "standard input can be read once");
  }
  if (request.inputs.empty()) request.inputs.emplace_back("-");
  if (Status settled =
          settle_separation(command, request.separation, request.threshold, request.vertical);
      !settled) {
    return settled;
  }
  take_heights_of(request.separation, request.vertical, request.load.heights);
  request.load.units.spoken_of = spoken_of_aviation(request.separation, request.threshold);
  if (request.threshold) request.threshold_m = request.threshold->metric;
  if (request.vertical) request.vertical_m = request.vertical->metric;
  return std::monostate{};
}

Status settle_answer(MovingRequest& request, const char* command,
                     const std::vector<std::string>& text_endings) {
  if (Status settled = settle(request, command); !settled) return settled;
  return output_form(command, {request.output, request.csv, request.json},
                     {{Form::kText, Form::kCsv, Form::kJson}, text_endings})
      .transform([&](const OutputForm& form) { request.form = form; });
}

Error in_words_of_the_command(Error error, const MovingRequest& request) {
  if (error.code != ErrorCode::kTooManyResults) return error;
  error.message = "there are more than " + io::grouped(request.max_results) +
                  (request.max_results == 1 ? " conflict" : " conflicts") +
                  "; raise --max-results, or lower the threshold";
  return error;
}

}  // namespace beespace::cli
