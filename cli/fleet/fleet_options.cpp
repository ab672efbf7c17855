#include "cli/command_line/option_values.hpp"
#include "cli/fleet/fleet_command.hpp"
#include "cli/input/placement_option.hpp"
#include "io/bytes/number_text.hpp"
#include "io/units/iso_time.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace beespace::cli {
namespace {

constexpr const char* kDescription = "Tell how far a fleet strays from what it was set to fly";

constexpr const char* kDetails =
    "Reads what was flown, and with --set what was set, as 'beespace replay' does; bees are the "
    "same by\n"
    "their ids. Compares each flown fix with the place that was set then, on straight lines "
    "between\n"
    "fixes. What was set in metres and flown in degrees, as a show is, is set down on the Earth "
    "where\n"
    "the show says that it is, or --origin does; --set-begins says when it was begun. Ids that "
    "differ are\n"
    "matched by their numbers, 'Drone 3' and '3', or, where these mean others or there are none, "
    "by\n"
    "where each begins; so is a spare that flies for another.\n"
    "\n"
    "Standard output, or --output, gets a line for each bee: id, and in what was set; how far it "
    "was\n"
    "from where it was set to be, when, on average, and in 95 of 100 fixes; how many fixes; and "
    "for\n"
    "how long it was set to fly and it is not known where it was, in gaps of more than --max-gap "
    "and\n"
    "where its fixes begin late or end early.\n"
    "The summary, on standard error, tells of all bees the greatest and what 99.9 % do not "
    "exceed:\n"
    "  deviation     how far one is from where it was set to be\n"
    "  lag           how much later than set they fly, and the deviation without that\n"
    "and, if what was set is no show, the figures to plan with:\n"
    "  rate          how fast the deviation changes, from fix to fix\n"
    "  changes by    how fast the rate changes\n"
    "Set and flown positions cannot tell how wrong the flown ones are themselves, nor what was "
    "wind\n"
    "and what was corrected; see docs/fleet-figures.md.\n"
    "\n"
    "Examples:\n"
    "  beespace fleet flown.csv --set set.csv\n"
    "  beespace fleet telemetry.csv --set show.skyc --set-begins 2025-11-27T19:00:00Z\n"
    "  beespace fleet logs/ --set show.skyc --max-deviation 1m --fail-on-risk --output drones.csv\n"
    "  beespace fleet log.csv --set log.csv --set-columns x=set_x,y=set_y,z=set_z --json\n"
    "\n"
    "Exit status: 0 done, 1 one is farther than --max-deviation, or it is not known how far (with\n"
    "--fail-on-risk), 2 wrong usage, 3 bad input, 4 cannot open, read or write, 130 interrupted,\n"
    "143 terminated, 141 closed pipe.";

// "2025-11-27T19:00:00.2Z", or seconds of the clock of what was flown.
Result<SetBegins> read_set_begins(const Typed& typed) {
  const std::optional<double> number = io::parse_number(typed.text);
  if (number && std::isfinite(*number)) return SetBegins{*number, false};
  SetBegins begins{0.0, true};
  const std::string_view problem = io::parse_iso_time(typed.text, begins.seconds);
  if (problem.empty()) return begins;
  return usage_error(typed.command,
                     "--set-begins is '" + typed.text +
                         "': say a date and time, as 2025-11-27T19:00:00Z, or the seconds of what "
                         "was flown (" +
                         std::string(problem) + ")");
}

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code problem;
  return a == b || (std::filesystem::equivalent(a, b, problem) && !problem);
}

Status settle_fleet(FleetRequest& request) {
  if (Status settled = settle_answer(request.moving, "fleet"); !settled) return settled;
  if (request.set.empty()) {
    return usage_error("fleet", "--set is missing; give the file of what was set to be flown");
  }
  const std::vector<std::string>& flown = request.moving.inputs;
  if (request.set == "-" && std::count(flown.begin(), flown.end(), "-") > 0) {
    return usage_error("fleet", "standard input can be read once; give --set a file");
  }
  const bool alike =
      request.set_columns.empty() || request.set_columns == request.moving.load.columns;
  if (alike && std::any_of(flown.begin(), flown.end(), [&](const std::string& one) {
        return is_same_file(one, request.set);
      })) {
    return usage_error("fleet",
                       "flown and set are the same columns; name those of what was set with "
                       "--set-columns");
  }
  return std::monostate{};
}

}  // namespace

Command fleet_command() {
  const auto request = std::make_shared<FleetRequest>();
  MovingRequest& moving = request->moving;
  Command fleet("fleet", kDescription, kDetails, [request](const Command&) -> Result<ExitCode> {
    return settle_fleet(*request).and_then([&] { return run_fleet(*request); });
  });
  fleet.arguments("FILES", moving.inputs,
                  "Files and folders of what was flown (default, or -:\nstandard input)");
  add_input_options(fleet, moving);
  fleet.group("Compare");
  fleet.option("--set", "FILE", request->set, "What was set to be flown");
  fleet.option("--set-columns", "LIST", request->set_columns,
               "Its columns, as of --columns: x=set_x,y=set_y,z=set_z");
  fleet.option("--set-begins", "TIME", request->beside.begins, read_set_begins,
               "When 0 s of what was set was, by the clock of what\nwas flown: "
               "2025-11-27T19:00:00Z, or seconds");
  fleet.option("--origin", "PLACE", request->beside.origin, read_placement,
               "Where 0,0,0 of what was set in metres is, if flown in\ndegrees: "
               "lon,lat,height,heading of x (0 north, 90 east),\nby heights as flown (default: "
               "as a show says itself)");
  add_max_gap_option(fleet, request->max_gap_s);
  fleet.option("--max-deviation", "LENGTH", request->max_deviation_m, amount("metres", kAboveZero),
               "Name who is farther than this from where it was set to\nbe (default: no limit)");
  add_form_options(fleet, moving);
  fleet.flag(
      "--fail-on-risk", moving.fail_on_risk,
      "Exit with 1 when one is farther than --max-deviation,\nor it is not known how far: in "
      "gaps, or set or flown alone");
  add_quiet_option(fleet, moving.quiet);
  return fleet;
}

}  // namespace beespace::cli
