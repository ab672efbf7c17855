#include "cli/input/moving_options.hpp"

#include "cli/command_line/option_values.hpp"
#include "cli/console/terminal.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace beespace::cli {
namespace {

std::optional<Error> check_inputs(const char* command, const MovingOptions& options) {
  if (options.inputs.empty() && input_is_terminal()) {
    return usage_error(command, "say which file to read, or pipe the input in");
  }
  if (std::count(options.inputs.begin(), options.inputs.end(), "-") > 1) {
    return usage_error(command, "standard input can be read once");
  }
  return std::nullopt;
}

}  // namespace

Result<io::RecordingOptions> recording_options(const char* command, const ReadingOptions& options) {
  io::RecordingOptions load;
  if (options.frame == "wgs84") load.frame = io::Frame::kWgs84;
  if (options.frame == "metres") load.frame = io::Frame::kMetres;
  if (options.time_unit == "s") load.time_unit = io::TimeUnit::kSeconds;
  if (options.time_unit == "ms") load.time_unit = io::TimeUnit::kMilliseconds;
  if (options.time_unit == "us") load.time_unit = io::TimeUnit::kMicroseconds;
  if (options.time_unit == "ns") load.time_unit = io::TimeUnit::kNanoseconds;
  if (options.heights == "geometric") load.heights = io::HeightSource::kGeometric;
  if (options.heights == "pressure") load.heights = io::HeightSource::kPressure;
  load.columns = options.columns;
  const auto units = io::read_unit_wishes(options.units);
  if (!units) return usage_error(command, units.error().message);
  load.units = *units;
  return load;
}

void add_units_options(Command& command, std::string& units, std::string& heights) {
  command.group("Input");
  command.option("--units", "LIST", units,
                 "Where the header names none: height=ft,speed=kt,\nclimb=ft/min, position=m");
  command.choice("--heights", heights, {"auto", "geometric", "pressure"},
                 "Of several heights, which to take (aircraft, tables)");
}

void add_input_options(Command& command, MovingOptions& options) {
  command.group("Input");
  command.choice("--crs", options.frame, {"auto", "wgs84", "metres"},
                 "Whether positions are in degrees or metres");
  command.option("--columns", "LIST", options.columns,
                 "By number or name: id=1,time=2,x=3,y=4,z=5,vx=6");
  command.choice("--time-unit", options.time_unit, {"auto", "s", "ms", "us", "ns"},
                 "Of times, where the input does not say");
  command.flag("--grounded", options.grounded,
               "Count those that stand on the ground as well (shows, aircraft)");
  add_units_options(command, options.units, options.heights);
  command.flag("--skip-bad", options.skip_bad, "Leave bad records out and list them");
}

void add_max_gap_option(Command& command, std::string& max_gap, const char* group) {
  command.group(group);
  command.option("--max-gap", "SECONDS|never", max_gap,
                 "Unknown between fixes farther apart in time\n(default: 5 times the typical "
                 "interval)");
}

Result<std::optional<double>> read_max_gap(const char* command, const std::string& text) {
  if (text.empty()) return std::optional<double>();
  if (text == "never") return std::optional<double>(std::numeric_limits<double>::infinity());
  const auto seconds = io::parse_number(text);
  if (seconds && *seconds > 0.0 && std::isfinite(*seconds)) return std::optional<double>(*seconds);
  return usage_error(command,
                     "--max-gap '" + text + "' is not a number of seconds above 0, nor 'never'");
}

void add_gap_options(Command& command, std::string& max_gap, std::string& tolerance) {
  add_max_gap_option(command, max_gap, "Input");
  command.group("Input");
  command.option("--tolerance", "LENGTH", tolerance,
                 "How closely to follow curves (default: 0.001)");
}

void add_threshold_options(Command& command, MovingOptions& options) {
  command.group("Separation");
  command.option("--threshold", "LENGTH", options.threshold,
                 "Closer than this is too close (default: what the\ninput declares, or 100)");
  command.option("--vertical", "LENGTH", options.vertical, kVerticalHelp);
  command.flag("--inclusive", options.inclusive, "A distance of exactly the threshold counts too");
  command.option("--threads", "N", options.threads, "How many threads work (default: 0, all)");
}

void add_separation_options(Command& command, MovingOptions& options) {
  add_threshold_options(command, options);
  command.group("Separation");
  command.option("--max-results", "N", options.max_results,
                 "Fail beyond so many conflicts (default: no limit)");
}

void add_output_options(Command& command, MovingOptions& options) {
  command.group("Output");
  command.option("-o,--output", "FILE", options.output,
                 "Where the answer goes, by its ending .csv or .json,\nperhaps with .gz, in this "
                 "form (default: standard\noutput)");
  command.flag("--csv", options.csv, "With a header, values between commas");
  command.flag("--json", options.json, "One JSON document with everything in it");
  command.flag("--fail-on-risk", options.fail_on_risk,
               "Exit with 1 when there is a conflict, or a gap or\nrecords that were left out may "
               "hide one");
  command.flag("--quiet", options.quiet, "No summary and no progress, only errors");
}

Result<MovingRequest> moving_request(const char* command, const MovingOptions& options) {
  if (auto error = check_inputs(command, options)) return *std::move(error);
  MovingRequest request;
  request.command = command;
  request.inputs = options.inputs;
  if (request.inputs.empty()) request.inputs.emplace_back("-");
  const auto load = recording_options(
      command, {options.frame, options.time_unit, options.columns, options.heights, options.units});
  if (!load) return load.error();
  request.load = *load;
  request.load.skip_bad = options.skip_bad;
  request.load.grounded = options.grounded;
  if (!options.threshold.empty()) {
    const auto threshold = read_threshold_in_motion(options.threshold);
    if (!threshold) return threshold.error();
    request.threshold_m = *threshold;
  }
  const auto vertical = read_vertical(command, options.vertical);
  if (!vertical) return vertical.error();
  request.vertical = *vertical;
  if (*vertical) request.vertical_m = (*vertical)->metric;
  request.inclusive = options.inclusive;
  const auto max_results = read_max_results(command, options.max_results);
  if (!max_results) return max_results.error();
  request.max_results = *max_results;
  const auto threads = read_threads(command, options.threads);
  if (!threads) return threads.error();
  request.threads = *threads;
  request.output = options.output;
  request.fail_on_risk = options.fail_on_risk;
  request.quiet = options.quiet;
  return request;
}

Result<MovingRequest> answering_request(const char* command, const MovingOptions& options,
                                        const std::vector<std::string>& text_endings) {
  auto request = moving_request(command, options);
  if (!request) return request;
  const auto form = output_form(command, {options.output, options.csv, options.json},
                                {{Form::kText, Form::kCsv, Form::kJson}, text_endings});
  if (!form) return form.error();
  request->form = *form;
  return request;
}

Error in_words_of_the_command(Error error, const MovingRequest& request) {
  if (error.code != ErrorCode::kTooManyResults) return error;
  error.message = "there are more than " + io::grouped(request.max_results) +
                  (request.max_results == 1 ? " conflict" : " conflicts") +
                  "; raise --max-results, or lower the threshold";
  return error;
}

}  // namespace beespace::cli
