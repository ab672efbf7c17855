#include "cli/command_line/option_values.hpp"
#include "cli/recorded/verify_command.hpp"

#include <memory>

namespace beespace::cli {
namespace {

constexpr const char* kVerifyDescription =
    "Check that a flight kept its distance, and that each bee flew as it can";

constexpr const char* kVerifyDetails =
    "Reads recordings as 'beespace replay' does, of bees that all have fixes at the same times "
    "(replay\n"
    "takes others). Where all fixes have velocities, a bee flies from one to the next on the curve "
    "that\n"
    "has its positions and velocities at both: evenly accelerated, where it was. Without them, or "
    "with\n"
    "--straight, it flies straight lines. All of the time in between is looked at, not samples of "
    "it.\n"
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
    "A step longer than --max-gap was not seen: nothing is found in it, and the flight does not "
    "hold.\n"
    "\n"
    "Examples:\n"
    "  beespace simulate random-swap --output swap.csv\n"
    "  beespace verify swap.csv --threshold 5 --max-speed 10 --max-acceleration 5\n"
    "  beespace verify log.csv --threshold 2 --straight --output findings.csv\n"
    "  beespace verify flight.csv --threshold 2 --obstacles city.json --clearance 3\n"
    "  beespace verify log.csv --quiet --output /dev/null && echo safe\n"
    "\n"
    "Exit status: 0 it holds, 1 there is a loss, a breach or a gap, 2 wrong usage, 3 bad input, or "
    "fixes\n"
    "at different times, 4 cannot open, read or write, 130 interrupted, 143 terminated, 141 closed "
    "pipe.";

void add_check_options(Command& verify, VerifyRequest& request) {
  verify.group("Check");
  verify.option("--threshold", "LENGTH", request.moving.threshold_m, read_threshold_in_motion,
                "Closer than this is too close (default: what the\ninput declares, or 5)");
  verify.option("--max-speed", "SPEED", request.check.max_speed_mps,
                amount("metres per second", kFromZero), "In m/s (default: not checked)");
  verify.option("--max-acceleration", "A", request.check.max_acceleration_mps2,
                amount("metres per second squared", kFromZero),
                "In m/s^2 (default: not checked); needs velocities");
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
