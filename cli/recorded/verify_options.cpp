#include "cli/command_line/option_values.hpp"
#include "cli/recorded/verify_command.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::cli {
namespace {

constexpr const char* kVerifyDescription =
    "Check that a flight kept its distance, and that each bee flew as it can";

constexpr const char* kVerifyDetails =
    "Reads recordings and drone shows as 'beespace replay' does. Drones of shows fly along their "
    "curves,\n"
    "and the show's own limits count where no option says another. Between fixes that all have "
    "velocities\n"
    "a bee flies on the curve that has its positions and velocities at both: evenly accelerated, "
    "where it\n"
    "was. Without them, or with --straight, it flies straight lines. All of the time in between is "
    "looked\n"
    "at, not samples of it. Flights in degrees whose bees have fixes at times of their own, as "
    "logs of "
    "drones\n"
    "have, are looked at as by 'beespace replay': straight lines, and possible losses along curves "
    "with the\n"
    "velocities; accelerations are those of the velocities, or without these of the turns at "
    "fixes.\n"
    "Writes a line for each finding, the first 1000 of each kind:\n"
    "  loss          id, id: closer than the threshold within one step; when that step begins and "
    "ends,\n"
    "                and how close they came at least\n"
    "  clearance     id, obstacle: closer to an obstacle than --clearance within one step; how "
    "close it\n"
    "                was seen to be, below zero inside\n"
    "  speed         id: faster than --max-speed within one step; when it begins and ends, and how "
    "fast\n"
    "  acceleration  id: the same of --max-acceleration\n"
    "Along curves, with --vertical, and of flights with fixes at times of their own, a line is a "
    "stretch of time,\n"
    "and says the limit and when the worst is; there are also:\n"
    "  horizontal, climb, descent, height   id: the same of --max-horizontal, ...\n"
    "Where such a line turns at a point, the acceleration is that which takes the turn within half "
    "of what\n"
    "is before and behind it, and within 0.5 m of the point: as little as a flight along it "
    "needs.\n"
    "A step longer than --max-gap was not seen: nothing is found in it, and the flight does not "
    "hold.\n"
    "\n"
    "Examples:\n"
    "  beespace simulate random-swap --output swap.csv\n"
    "  beespace verify swap.csv --threshold 5 --max-speed 10 --max-acceleration 5\n"
    "  beespace verify log.csv --threshold 2 --straight --output findings.csv\n"
    "  beespace verify show.skyc --max-acceleration 4\n"
    "  beespace verify flight.csv --threshold 2 --obstacles city.json --clearance 3\n"
    "  beespace verify north.ulg south.ulg --threshold 5 --max-speed 12\n"
    "  beespace verify log.csv --quiet --output /dev/null && echo safe\n"
    "\n"
    "Exit status: 0 it holds, 1 there is a loss, a breach, a gap, or a limit of a show that is not "
    "looked\n"
    "at, 2 wrong usage, 3 bad input, 4 cannot open, read or write, "
    "130\n"
    "interrupted, 143 terminated, 141 closed pipe.";

// With commas between them.
Result<std::vector<std::string>> read_names(const Typed& typed) {
  std::vector<std::string> names;
  std::string_view text = typed.text;
  for (std::size_t end = 0; end != std::string_view::npos;) {
    end = text.find(',');
    names.emplace_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return names;
}

void add_check_options(Command& verify, VerifyRequest& request) {
  verify.group("Check");
  verify.option("--threshold", "LENGTH", request.moving.threshold, read_stated_threshold_in_motion,
                "Closer than this is too close (default: what the\ninput declares, or 2 for shows, "
                "otherwise 5)");
  verify.option("--vertical", "LENGTH", request.moving.vertical, read_vertical, kVerticalHelp);
  add_usual_separation_option(verify, request.moving.separation);
  add_low_option(verify, request.moving);
  verify.option("--max-speed", "SPEED", request.check.max_speed_mps,
                amount("metres per second", kFromZero), "In m/s (default: not checked)");
  verify.option("--max-acceleration", "A", request.check.max_acceleration_mps2,
                amount("metres per second squared", kFromZero),
                "In m/s^2 (default: not checked); needs velocities, or\ncurves");
  const auto limit = [&](PathLimit which) -> std::optional<double>& {
    return request.limits[static_cast<std::size_t>(which)];
  };
  verify.option("--max-horizontal", "SPEED", limit(PathLimit::kHorizontalSpeed),
                amount("metres per second", kFromZero),
                "Of the speed in x and y (default: what the show\ndeclares, or not checked)");
  verify.option("--max-climb", "SPEED", limit(PathLimit::kClimb),
                amount("metres per second", kFromZero), "Of the speed upwards (default: as above)");
  verify.option("--max-descent", "SPEED", limit(PathLimit::kDescent),
                amount("metres per second", kFromZero),
                "Of the speed downwards (default: as above)");
  verify.option("--max-height", "LENGTH", limit(PathLimit::kHeight), amount("metres", kFromZero),
                "Of z; of degrees, of the height as the input counts it\n(default: as above)");
  verify.option("--skip-limits", "NAMES", request.skipped_limits, read_names,
                "Limits that the show declares and that need not be\nlooked at, where that is not "
                "done: minNavAltitude");
  verify.option("--obstacles", "FILE", request.obstacles,
                "What stands in the way: JSON, as of 'beespace\nsimulate'; of flights in metres");
  verify.option("--clearance", "LENGTH", request.check.clearance_m, amount("metres", kAboveZero),
                "Closer than this to an obstacle is too close\n(default: 1)");
  add_max_gap_option(verify, request.max_gap_s);
  verify.flag("--straight", request.check.straight, "Straight lines, whatever the velocities");
  verify.option("--threads", "N", request.moving.threads, read_threads,
                "How many threads work (default: 0, all)");
}

Status settle(const Command& command, VerifyRequest& request) {
  if (Status settled = settle_answer(request.moving, "verify"); !settled) return settled;
  request.check.threads = request.moving.threads;
  const auto take = [&](const char* option, PathLimit which, double value) {
    if (command.is_given(option)) request.limits[static_cast<std::size_t>(which)] = value;
  };
  take("--max-speed", PathLimit::kSpeed, request.check.max_speed_mps);
  take("--max-acceleration", PathLimit::kAcceleration, request.check.max_acceleration_mps2);
  if (request.moving.vertical && !request.obstacles.empty()) {
    return usage_error("verify",
                       "--vertical is of two bees, and --obstacles are checked in space; check one "
                       "after the other");
  }
  if (request.check.straight && command.is_given("--max-acceleration")) {
    return usage_error("verify",
                       "--max-acceleration needs the velocities, and --straight ignores them; "
                       "leave one out");
  }
  if (command.is_given("--clearance") && request.obstacles.empty()) {
    return usage_error("verify",
                       "--clearance is of obstacles, and there are none; add --obstacles");
  }
  return std::monostate{};
}

}  // namespace

Command verify_command() {
  const auto request = std::make_shared<VerifyRequest>();
  MovingRequest& moving = request->moving;
  Command verify("verify", kVerifyDescription, kVerifyDetails, [request](const Command& command) {
    return settle(command, *request).and_then([&] { return run_verify(*request); });
  });
  verify.arguments("FILES", moving.inputs,
                   "Files and folders to read (default, or -:\nstandard input)");
  add_input_options(verify, moving);
  add_check_options(verify, *request);
  add_form_options(verify, moving);
  add_quiet_option(verify, moving.quiet);
  return verify;
}

}  // namespace beespace::cli
