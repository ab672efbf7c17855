#include "cli/input/moving_options.hpp"
#include "cli/watch/watch_command.hpp"

namespace beespace::cli {
namespace {

constexpr const char* kDescription = "Watch a swarm live: reports in, events out as they happen";

constexpr const char* kDetails =
    "Reads a report a line, as they come: a table with a header (id, time_s, x, y, z in metres or "
    "lon,\n"
    "lat, height in degrees, perhaps velocities), an object of JSON with the same keys, readsb's "
    "JSON,\n"
    "or BaseStation (SBS-1) messages. Writes an object of JSON a line: what has happened, as soon "
    "as\n"
    "both bees have been heard of again, and what lies ahead. Memory grows with the bees, not with "
    "the\n"
    "reports. Bad lines are counted and said, and left out: then the verdict is of what was taken. "
    "At\n"
    "the end of the input, or when it is told to end (SIGINT, SIGTERM, SIGHUP), a summary goes to\n"
    "standard error.\n"
    "A line {\"event\": \"leave\", \"id\": \"a\"} says that a bee is there no longer.\n"
    "\n"
    "Events:\n"
    "  predicted       two are about to come too close: when it begins, how close, and when\n"
    "  entered         two have come closer than the threshold\n"
    "  closest_passed  they are getting farther apart again: how close they were, and when\n"
    "  left            they are farther apart than the threshold times --leave-factor\n"
    "  lost            two that had entered, and one has fallen silent: unknown from then on\n"
    "  ended           two that had entered, when the input ended\n"
    "  possible        with --max-speed: a stale bee may be too close to another one\n"
    "  stale           a bee has not been heard of for --max-age, or its clock has stepped\n"
    "  heard           it has been heard of again\n"
    "  clock           a bee's clock is off, and by how much; its reports are taken at corrected "
    "times\n"
    "  clocks_anew     the clocks of most have gone back, as after a restart\n"
    "  overloaded      a bound is reached, and how many bees or pairs are left out\n"
    "  advice          with --advise, every --step: a bee that should not fly on as it does, and "
    "the\n"
    "                  velocity to change to from effective_s on; or that is not certified, and "
    "why\n"
    "  advised         ends the advice of a step: whom no line names, flies straight on\n"
    "\n"
    "Examples:\n"
    "  tail -f swarm.csv | beespace watch --threshold 5\n"
    "  nc receiver 30003 | beespace watch --threshold 5000 --vertical 300\n"
    "  beespace watch flight.csv --threshold 5 --speed 10\n"
    "  tail -f swarm.csv | beespace watch --threshold 5 --advise --max-speed 15\n"
    "\n"
    "Exit status: 0 fine, 1 it is not known that none has entered (with --fail-on-risk), 2 wrong "
    "usage,\n"
    "3 bad input, 4 cannot open, read or write, 129 hung up, 130 interrupted, 143 terminated, 141 "
    "closed\n"
    "pipe.";

void add_input_options(Command& watch, WatchOptions& options) {
  watch.argument("FILE", options.input, "What to read (default, or -: standard input)");
  watch.group("Input");
  watch.choice("--crs", options.frame, {"auto", "wgs84", "metres"},
               "Whether positions are in degrees or metres");
  watch.option("--columns", "LIST", options.columns,
               "By number or name: id=1,time=2,x=3,y=4,z=5,vx=6");
  watch.choice("--time-unit", options.time_unit, {"auto", "s", "ms", "us", "ns"},
               "Of times, where the input does not say");
  add_units_options(watch, options.units, options.heights);
  watch.option("--max-age", "SECONDS", options.max_age,
               "Stale is who was not heard of for so long (default: 5)");
  watch.choice("--clock", options.clock, {"report", "arrival"},
               "Whose clock tells when a report was: its own, or\nthat of this machine when "
               "it comes");
  watch.option("--max-skew", "SECONDS", options.max_skew,
               "Clocks that differ by more are not believed\n(default: 2, or half of --max-age "
               "if that is less)");
  watch.option("--max-bees", "N", options.max_bees,
               "So many bees are known at a time (default: 1000000)");
  watch.option("--speed", "FACTOR", options.speed,
               "Read a recording as fast as it happened, times this");
  watch.option("--rate", "N", options.rate, "Read so many reports a second at most");
}

}  // namespace

Command watch_command(WatchOptions& options) {
  Command watch("watch", kDescription, kDetails, [&options] { return run_watch(options); });
  add_input_options(watch, options);
  watch.group("Separation");
  watch.option("--threshold", "LENGTH", options.threshold,
               "Closer than this is too close (default: 100)");
  watch.option("--vertical", "LENGTH", options.vertical, kVerticalHelp);
  watch.option("--threads", "N", options.threads, "How many threads work (default: 1; 0: all)");
  add_live_options(watch, options.live, "Separation");
  watch.option("--max-pairs", "N", options.max_pairs,
               "So many pairs are followed at a time, the closest\n(default: 500000)");
  add_live_advice_options(watch, options.advice, "Advice");
  watch.group("Output");
  watch.flag("--fail-on-risk", options.fail_on_risk,
             "Exit with 1 when two have entered, or it is not known\nthat none has");
  watch.flag("--quiet", options.quiet, "No summary, only errors");
  return watch;
}

}  // namespace beespace::cli
