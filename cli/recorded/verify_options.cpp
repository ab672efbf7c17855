#include "cli/recorded/verify_command.hpp"

namespace beespace::cli {
namespace {

constexpr const char* kDescription =
    "Check that a flight kept its distance, and that everybody flew as it can";

constexpr const char* kDetails =
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

void add_check_options(Command& verify, VerifyCommandOptions& options) {
  verify.group("Check");
  verify.option("--threshold", "LENGTH", options.moving.threshold,
                "Closer than this is too close (default: what the\ninput declares, or 5)");
  verify.option("--max-speed", "SPEED", options.max_speed, "In m/s (default: not checked)");
  verify.option("--max-acceleration", "A", options.max_acceleration,
                "In m/s^2 (default: not checked); needs velocities");
  verify.option("--obstacles", "FILE", options.obstacles,
                "What stands in the way: JSON, as of 'beespace\nsimulate'; of flights in metres");
  verify.option("--clearance", "LENGTH", options.clearance,
                "Closer than this to an obstacle is too close\n(default: 1)");
  add_max_gap_option(verify, options.max_gap, "Check");
  verify.flag("--straight", options.straight, "Straight lines, whatever the velocities");
  verify.option("--threads", "N", options.moving.threads,
                "How many threads work (default: 0, all)");
}

void add_answer_options(Command& verify, MovingOptions& options) {
  verify.group("Output");
  verify.option("-o,--output", "FILE", options.output,
                "Where the answer goes, by its ending .csv or .json,\nperhaps with .gz, in this "
                "form (default: standard\noutput)");
  verify.flag("--csv", options.csv, "With a header, values between commas");
  verify.flag("--json", options.json, "One JSON document with everything in it");
  verify.flag("--quiet", options.quiet, "No summary and no progress, only errors");
}

}  // namespace

Command verify_command(VerifyCommandOptions& options) {
  Command verify("verify", kDescription, kDetails, [&options] { return run_verify(options); });
  verify.arguments("FILES", options.moving.inputs,
                   "Files and folders to read (default, or -:\nstandard input)");
  add_input_options(verify, options.moving);
  add_check_options(verify, options);
  add_answer_options(verify, options.moving);
  return verify;
}

}  // namespace beespace::cli
