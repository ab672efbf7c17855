#include "cli/command_line/option_values.hpp"
#include "cli/console/terminal.hpp"
#include "cli/input/live_options.hpp"
#include "cli/input/moving_options.hpp"
#include "cli/watch/watch_command.hpp"
#include "cli/watch/watch_request.hpp"

#include <beespace/mover.hpp>

#include <memory>
#include <vector>

namespace beespace::cli {
namespace {

constexpr const char* kName = "watch";

constexpr const char* kDescription = "Watch a swarm live: reports in, events out as they happen";

constexpr const char* kDetails =
    "Reads a report a line, as they come: a table with a header (id, time_s, x, y, z in metres or "
    "lon,\n"
    "lat, height in degrees, perhaps velocities), an object of JSON with the same keys, readsb's "
    "JSON,\n"
    "BaseStation (SBS-1) messages, or a telemetry log of MAVLink (.tlog). Writes an object of "
    "JSON\n"
    "a line: what has happened, as soon as both bees have been heard of again, and what lies\n"
    "ahead. Memory grows with the bees, not with the reports. Bad lines are counted and said, and\n"
    "left out: then the verdict is of what was taken. At the end of the input, or when it is told "
    "to\n"
    "end (SIGINT, SIGTERM, SIGHUP), a summary goes to standard error.\n"
    "A line {\"event\": \"leave\", \"id\": \"a\"} says that a bee is there no longer.\n"
    "--advise counts with exact positions and bees that obey at once; a fleet with noise, wind and "
    "messages\n"
    "that are late or lost is guided by 'beespace guide'.\n"
    "\n"
    "Events:\n"
    "  predicted       two are about to come too close: when that was found (said_at_s), when it\n"
    "                  begins, how close, and when; closing: at the end of the horizon, and they\n"
    "                  come closer after it\n"
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

// What is asked for, and what is settled once all of it is read.
struct Asked {
  WatchRequest request;
  LiveRequest live;
  std::optional<double> max_skew_s;
  bool advise = false;
  LiveAdviceRequest advice{.options = {.uncertainty_m = 0.1}, .limits = {30.0, 5.0}};
  std::optional<double> step_s;
};

void add_input_options(Command& watch, Asked& asked) {
  WatchRequest& request = asked.request;
  watch.argument("FILE", request.input, "What to read (default, or -: standard input)");
  watch.group("Input");
  add_frame_option(watch, request.lines.frame, "Whether positions are in degrees or metres");
  watch.option("--columns", "LIST", request.lines.columns,
               "By number or name: id=1,time=2,x=3,y=4,z=5,vx=6");
  add_time_unit_option(watch, request.lines.time_unit);
  watch.flag("--one-clock", request.lines.one_clock,
             "Times of several vehicles count from one zero, though\nnothing says so");
  add_clock_and_pixel_options(watch, request.lines);
  watch.flag("--grounded", request.lines.grounded,
             "Count aircraft that stand on the ground as well");
  add_units_options(watch, request.lines.units, request.lines.heights);
  watch.option("--max-age", "SECONDS", request.swarm.max_age_s,
               amount_in_motion("seconds", kAboveZero),
               "Stale is who was not heard of for so long (default: 5)");
  watch.choice("--clock", request.by_arrival, {{"report", false}, {"arrival", true}},
               "Whose clock tells when a report was: its own, or\nthat of this machine when it "
               "comes");
  watch.option("--max-skew", "SECONDS", asked.max_skew_s, amount("seconds", kAboveZero),
               "Clocks that differ by more are not believed\n(default: 2, or half of --max-age "
               "if that is less)");
  constexpr std::uint64_t kMost = 4'000'000'000;
  watch.option("--max-bees", "N", request.swarm.max_agents, whole_without_commas(1, kMost),
               "So many bees are known at a time (default: 1000000)");
  watch.option("--speed", "FACTOR", request.speed, amount("times", kAboveZero),
               "Read a recording as fast as it happened, times this");
  watch.option("--rate", "N", request.rate, amount("reports a second", kAboveZero),
               "Read so many reports a second at most");
  watch.group("Separation");
  watch.option("--threshold", "LENGTH", request.threshold, read_stated_threshold_in_motion,
               "Closer than this is too close (default: 100; of logs of\ndrones, 5; of aircraft it "
               "is asked for)");
  watch.option("--vertical", "LENGTH", request.vertical, read_vertical_in_motion, kVerticalHelp);
  add_usual_separation_option(watch, request.separation);
  watch.option("--threads", "N", request.swarm.threads, read_threads,
               "How many threads work (default: 1; 0: all)");
  add_live_options(watch, asked.live);
  watch.option("--max-pairs", "N", request.swarm.max_pairs, whole_without_commas(1, kMost),
               "So many pairs are followed at a time, the closest\n(default: 500000)");
}

void add_advice_options(Command& watch, Asked& asked) {
  watch.group("Advice");
  watch.flag("--advise", asked.advise,
             "Every --step, also tell who should not fly on as it\ndoes, and how instead");
  watch.option("--max-speed", "SPEED", asked.request.swarm.max_speed_mps, read_speed,
               "No bee is ever faster, in m/s: then events say whom a\nsilent one may meet. In "
               "advice, the greatest\n(default: 30); who is faster already may stay so");
  watch.option("--max-acceleration", "A|none", asked.advice.limits.max_acceleration_mps2,
               read_acceleration,
               "In advice, the greatest, in m/s^2 (default: 5); none:\nvelocities change at once");
  watch.option("--uncertainty", "LENGTH", asked.advice.options.uncertainty_m, length_from(0.0),
               "In advice, how far from where it leads a bee may be\nand still be certified "
               "(default: 0.1)");
  watch.option("--step", "SECONDS", asked.step_s, read_span,
               "In advice, how long until the next (default: that of\n--look-every)");
}

// Advice that is wanted, or what makes no sense without advice, or with it.
Status settle_advice(const Command& command, Asked& asked) {
  if (!asked.advise) {
    for (const char* option : {"--max-acceleration", "--uncertainty", "--step"}) {
      if (!command.is_given(option)) continue;
      return usage_error(kName, std::string(option) + " is of advice; add --advise");
    }
    return std::monostate{};
  }
  WatchRequest& request = asked.request;
  if (request.vertical) {
    return usage_error(kName, std::string("--advise knows distances in space only; leave --") +
                                  (request.separation != nullptr ? "separation" : "vertical") +
                                  " out, or watch twice");
  }
  const double look_every_s = asked.live.look_every_s;
  if (!asked.step_s && !(look_every_s >= 1e-6 && look_every_s <= 1e6)) {
    return usage_error(kName, "--look-every is no step of advice; say --step");
  }
  LiveAdviceRequest& advice = request.advice.emplace(asked.advice);
  FlightLimits& limits = advice.limits;
  limits.max_speed_mps = request.swarm.max_speed_mps.value_or(limits.max_speed_mps);
  advice.max_age_s = request.swarm.max_age_s;
  advice.options.threshold_m = request.swarm.threshold_m;
  advice.options.threads = request.swarm.threads;
  advice.options.step_s = asked.step_s.value_or(look_every_s);
  // In this time all come to a stop, whatever they are told.
  advice.options.unknown_horizon_s =
      advice.options.step_s + limits.max_speed_mps / limits.max_acceleration_mps2;
  return std::monostate{};
}

// So that no report is refused for the options. A vertical threshold may be compared as typed, or
// in metres.
Status check_leaving(const Command& command, const WatchRequest& request) {
  std::vector<double> thresholds = {request.swarm.threshold_m};
  if (request.vertical) {
    thresholds.insert(thresholds.end(), {request.vertical->metric, request.vertical->value});
  }
  for (const double threshold : thresholds) {
    if (threshold * request.swarm.leave_factor <= kLargestInMotion) continue;
    return usage_error(kName,
                       std::string("--leave-factor '").append(command.typed("--leave-factor")) +
                           "' times the threshold cannot be computed with; give less");
  }
  return std::monostate{};
}

Status settle(const Command& command, Asked& asked) {
  WatchRequest& request = asked.request;
  if (request.input.empty() && input_is_terminal()) {
    return usage_error(kName, "say which file to read, or pipe the reports in");
  }
  if (request.speed && request.rate) {
    return usage_error(kName, "--speed and --rate exclude each other");
  }
  if (request.by_arrival && (request.speed || request.rate)) {
    return usage_error(kName, "--clock arrival is for reports that come as things happen; leave " +
                                  std::string(request.speed ? "--speed" : "--rate") + " out");
  }
  if (request.input.empty()) request.input += '-';
  SwarmOptions& swarm = request.swarm;
  if (Status settled =
          settle_separation(kName, request.separation, request.threshold, request.vertical);
      !settled) {
    return settled;
  }
  take_heights_of(request.separation, request.vertical, request.lines.heights);
  request.lines.units.spoken_of = spoken_of_aviation(request.separation, request.threshold);
  if (request.threshold) swarm.threshold_m = request.threshold->metric;
  if (request.vertical) swarm.vertical_m = request.vertical->metric;
  swarm.leave_factor = asked.live.leave_factor;
  swarm.horizon_s = asked.live.horizon_s;
  request.times = {asked.live.look_every_s,
                   asked.max_skew_s.value_or(default_max_skew_s(swarm.max_age_s))};
  return settle_advice(command, asked).and_then([&] { return check_leaving(command, request); });
}

}  // namespace

Command watch_command() {
  const auto asked = std::make_shared<Asked>();
  WatchRequest& request = asked->request;
  Command watch(kName, kDescription, kDetails, [asked](const Command& command) {
    return settle(command, *asked).and_then([&] { return run_watch(asked->request); });
  });
  add_input_options(watch, *asked);
  add_advice_options(watch, *asked);
  watch.group("Output");
  watch.flag("--fail-on-risk", request.fail_on_risk,
             "Exit with 1 when two have entered, or it is not known\nthat none has");
  watch.flag("--quiet", request.quiet, "No summary, only errors");
  return watch;
}

}  // namespace beespace::cli
