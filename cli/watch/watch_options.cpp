#include "cli/command_line/option_checks.hpp"
#include "cli/input/moving_options.hpp"
#include "cli/watch/watch_command.hpp"

#include <beespace/version.hpp>

#include <CLI/CLI.hpp>

#include <string>

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

void add_input_options(CLI::App& watch, WatchOptions& options) {
  watch.add_option("FILE", options.input, "What to read (default, or -: standard input)")
      ->type_name(" ");
  CLI::Option* frame =
      watch.add_option("--crs", options.frame, "Whether positions are in degrees or metres")
          ->type_name("auto|wgs84|metres")
          ->group("Input");
  allow_only(*frame, {"auto", "wgs84", "metres"});
  watch.add_option("--columns", options.columns, "By number or name: id=1,time=2,x=3,y=4,z=5,vx=6")
      ->type_name("LIST")
      ->group("Input");
  CLI::Option* unit =
      watch.add_option("--time-unit", options.time_unit, "Of times, where the input does not say")
          ->type_name("auto|s|ms|us|ns")
          ->group("Input");
  allow_only(*unit, {"auto", "s", "ms", "us", "ns"});
  add_units_options(watch, options.units, options.heights);
  watch
      .add_option("--max-age", options.max_age,
                  "Stale is who was not heard of for so long (default: 5)")
      ->type_name("SECONDS")
      ->group("Input");
  CLI::Option* clock =
      watch
          .add_option("--clock", options.clock,
                      "Whose clock tells when a report was: its own, or\nthat of this machine when "
                      "it comes")
          ->type_name("report|arrival")
          ->group("Input");
  allow_only(*clock, {"report", "arrival"});
  watch
      .add_option("--max-skew", options.max_skew,
                  "Clocks that differ by more are not believed\n(default: 2, or half of --max-age "
                  "if that is less)")
      ->type_name("SECONDS")
      ->group("Input");
  watch
      .add_option("--max-bees", options.max_bees,
                  "So many bees are known at a time (default: 1000000)")
      ->type_name("N")
      ->group("Input");
  watch.add_option("--speed", options.speed, "Read a recording as fast as it happened, times this")
      ->type_name("FACTOR")
      ->group("Input");
  watch.add_option("--rate", options.rate, "Read so many reports a second at most")
      ->type_name("N")
      ->group("Input");
}

}  // namespace

CLI::App* add_watch_command(CLI::App& command, WatchOptions& options) {
  CLI::App* watch = command.add_subcommand("watch", kDescription);
  watch->footer(kDetails);
  watch->set_version_flag("--version", std::string(version()), "Print the version and exit");
  add_input_options(*watch, options);
  watch
      ->add_option("--threshold", options.threshold, "Closer than this is too close (default: 100)")
      ->type_name("LENGTH")
      ->group("Separation");
  watch->add_option("--vertical", options.vertical, kVerticalHelp)
      ->type_name("LENGTH")
      ->group("Separation");
  watch->add_option("--threads", options.threads, "How many threads work (default: 1; 0: all)")
      ->type_name("N")
      ->group("Separation");
  add_live_options(*watch, options.live, "Separation");
  watch
      ->add_option("--max-pairs", options.max_pairs,
                   "So many pairs are followed at a time, the closest\n(default: 500000)")
      ->type_name("N")
      ->group("Separation");
  add_live_advice_options(*watch, options.advice, "Advice");
  watch
      ->add_flag("--fail-on-risk", options.fail_on_risk,
                 "Exit with 1 when two have entered, or it is not known\nthat none has")
      ->group("Output");
  watch->add_flag("--quiet", options.quiet, "No summary, only errors")->group("Output");
  refuse_pointless_values(*watch);
  return watch;
}

}  // namespace beespace::cli
