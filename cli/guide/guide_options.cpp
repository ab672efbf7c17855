#include "cli/command_line/option_values.hpp"
#include "cli/console/terminal.hpp"
#include "cli/guide/guide_command.hpp"
#include "cli/guide/guide_request.hpp"
#include "cli/guide/guide_values.hpp"
#include "cli/input/moving_options.hpp"
#include "cli/input/shape_value.hpp"

#include <limits>
#include <memory>
#include <utility>

namespace beespace::cli {
namespace {

constexpr const char* kName = "guide";

constexpr const char* kDescription =
    "Guide a fleet whose positions are not exact, and whose messages are late or lost";

constexpr const char* kDetails =
    "The planner's side. Reads messages, an object of JSON a line, from standard input: join, "
    "may_join, leave,\n"
    "goal, preferred, report, ack, intruders, adopt, expect, tick. Writes, each tick: commands for "
    "agents, and "
    "for\n"
    "those who watch status, pair, near_obstacle, near_fence, intruder_conflict and ticked. What "
    "every\n"
    "field means is in docs/fleet-messages.md. 'beespace follow' is the agent's side.\n"
    "From the figures of the fleet, all of them bounds, follows the radius of the tube that an "
    "agent never\n"
    "leaves. As long as the figures are true, true positions keep the threshold, whatever is lost, "
    "late,\n"
    "doubled or out of order; an agent that breaks them is named. The proof is in "
    "docs/prevention.md.\n"
    "A message that makes no sense is refused, and said; all others go on.\n"
    "\n"
    "With --format mavlink standard output is frames of MAVLink 2, SET_POSITION_TARGET_LOCAL_NED, "
    "one each\n"
    "tick and agent: positions and velocities, or velocities alone with --loop ground. Input is x "
    "east,\n"
    "y north, z up; frames are north, east, down. Ids are systems, 1 to 254. Autopilots that fly "
    "on "
    "with\n"
    "their last setpoint when none comes are not covered while none comes: run 'beespace follow' "
    "beside\n"
    "each (see docs/fleet-messages.md).\n"
    "\n"
    "Examples:\n"
    "  beespace guide --threshold 5 --max-speed 10 --max-acceleration 5 --deviation 0.5 \\\n"
    "    --sensing-error 0.1 --correction-acceleration 1 --correction-speed 2 --store "
    "fleet.ndjson\n"
    "  beespace guide --threshold 5 --max-speed 10 --max-acceleration 5 --loop ground \\\n"
    "    --report-error 0.25 --report-age 0.1 --deviation 0.1 --correction-acceleration 1 "
    "--correction-speed 2\n"
    "  beespace guide --threshold 2 --max-speed 1.5 --max-acceleration 2 --plane \\\n"
    "    --ticks-from-input < messages.ndjson\n"
    "\n"
    "Exit status: 0 fine, 2 wrong usage or figures that contradict each other, 3 bad input, 4 "
    "cannot open,\n"
    "read, write or store, 129 hung up, 130 interrupted, 143 terminated, 141 closed pipe.";

struct Asked {
  GuideRequest request;
  std::uint64_t command_delay = 1;
  std::uint64_t longest_loss = 0;
  std::uint64_t epoch = 1;
};

void add_separation_options(Command& guide, GuideRequest& request) {
  GuideOptions& options = request.options;
  guide.group("Separation");
  guide
      .option("--threshold", "LENGTH", options.threshold_m, read_threshold_in_motion,
              "True positions closer than this are too close")
      .required = true;
  guide.option(
      "--shape", kShapes, options.separation, read_shape,
      "What must stay free: a sphere, one stretched in\nheight, or a cylinder: too close is "
      "who is closer\nhorizontally than the threshold, and in height\nthan this");
  guide.option("--obstacles", "FILE", request.obstacles,
               "What stands in the way: JSON, as of simulate");
  guide.option("--fence", "NX,NY,NZ,OFFSET[;...]|FILE", request.fences, read_fences,
               "What no agent leaves: all places p with\nn . p >= offset, of each plane; or a file "
               "with one a\nline");
  guide.option("--clearance", "LENGTH", options.clearance_m, length_from(kLeastLength_m),
               "Closer than this to an obstacle or fence is too\nclose (default: 1)");
  guide.flag("--plane", options.planar, "Agents keep their heights: robots on a floor");
}

void add_flight_options(Command& guide, Asked& asked) {
  GuideOptions& options = asked.request.options;
  guide.group("Fleet");
  guide
      .option("--max-speed", "SPEED", options.limits.max_speed_mps, read_speed,
              "The greatest of an agent, in m/s")
      .required = true;
  guide
      .option("--max-acceleration", "A", options.limits.max_acceleration_mps2,
              amount("metres per second squared", kAboveZero), "The same in m/s^2")
      .required = true;
  guide.option("--period", "SECONDS", options.link.period_s, read_span,
               "A tick, in seconds, without a unit (default: 0.1)");
  guide.option("--command-delay", "TICKS", asked.command_delay, whole(1, 32),
               "After so many ticks a command takes effect; it must\nbe there before (default: 1)");
  guide.option("--longest-loss", "N", asked.longest_loss, whole(0, 1000),
               "So many messages of an agent are lost one after the\nother, at most (default: 0)");
  guide.choice("--loop", options.figures.loop,
               {{"onboard", LoopPlace::kOnboard}, {"ground", LoopPlace::kGround}},
               "Who keeps an agent on its path: itself, or this\ncommand, by reports (default: "
               "onboard)");
}

void add_figures(Command& guide, FleetFigures& figures) {
  guide.group("Bounds of what is not exact");
  const auto length = length_from(0.0);
  const auto seconds = amount("seconds", kFromZero);
  const auto speed = amount("metres per second", kFromZero);
  guide.option("--report-error", "LENGTH", figures.report_error_m, length,
               "How far a reported position is off (default: 0)");
  guide.option("--report-age", "SECONDS", figures.report_age_s, seconds,
               "How old a report is when it is used (default: 0)");
  guide.option("--sensing-error", "LENGTH", figures.sensing_error_m, length,
               "On board: how far off is what the agent takes for\nits position (default: 0)");
  guide.option("--loop-period", "SECONDS", figures.loop_period_s, seconds,
               "On board: the period of its loop (default: 0,\ncontinuous)");
  guide.option("--loop-delay", "SECONDS", figures.loop_delay_s, seconds,
               "On board: how old a measurement is when it is used\n(default: 0)");
  guide.option("--deviation", "SPEED", figures.deviation_mps, speed,
               "How fast wind, drift and errors of velocity carry\nan agent away (default: 0)");
  guide.option("--clock-error", "SECONDS", figures.clock_error_s, seconds,
               "How far its clock is off (default: 0)");
  guide.option("--correction-acceleration", "A", figures.correction_mps2,
               amount("metres per second squared", kFromZero),
               "What is kept of the greatest acceleration for\ncorrections (default: 0)");
  guide.option("--correction-speed", "SPEED", figures.correction_mps, speed,
               "The same of the greatest speed (default: 0)");
}

void add_running_options(Command& guide, Asked& asked) {
  GuideRequest& request = asked.request;
  guide.group("Running");
  guide.option("--store", "FILE", request.store,
               "Where the epoch and who is in the fleet are\nremembered: each start raises the "
               "epoch, and calls\nwho was in the fleet");
  guide.option("--epoch", "N", asked.epoch,
               whole_without_commas(1, std::numeric_limits<std::uint32_t>::max()),
               "The epoch at least; without --store it must be\ngreater than that of all planners "
               "before (default: 1)");
  guide.flag("--ticks-from-input", request.ticks_from_input,
             "Ticks come as messages, not by the clock");
  guide.option("--threads", "N", request.options.threads, read_threads,
               "How many threads work (default: 1; 0: all)");
  guide.group("Output");
  guide.choice("--format", request.mavlink, {{"ndjson", false}, {"mavlink", true}},
               "Commands and status as lines (default), or frames\nof MAVLink, see above");
  guide.option("--log", "FILE", request.log,
               "With --format mavlink: where the lines go, behind\nwhat is there");
  guide.choice("--status", request.status,
               {{"changes", StatusLines::kChanges},
                {"all", StatusLines::kAll},
                {"none", StatusLines::kNone}},
               "In each tick, of which agents there is a status:\nof those whose contract or "
               "certificates have\nchanged (default), of all, of none");
  add_quiet_option(guide, request.quiet);
}

Status settle(const Command& command, Asked& asked) {
  GuideRequest& request = asked.request;
  if (input_is_terminal()) {
    return usage_error(kName,
                       "pipe the messages in, from agents and from those who tell where to "
                       "go");
  }
  if (command.is_given("--log") && !request.mavlink) {
    return usage_error(kName,
                       "--log is of --format mavlink; without, the lines are on standard "
                       "output");
  }
  if (command.is_given("--clearance") && request.obstacles.empty() && request.fences.empty()) {
    return usage_error(kName,
                       "--clearance is of obstacles and fences, and there are none; add "
                       "--obstacles or --fence");
  }
  if (request.obstacles == "-") {
    return usage_error(kName, "--obstacles cannot be standard input, where the messages come");
  }
  if (request.options.figures.loop == LoopPlace::kGround) {
    for (const char* const option : {"--sensing-error", "--loop-period", "--loop-delay"}) {
      if (!command.is_given(option)) continue;
      return usage_error(
          kName, std::string(option) + " is of --loop onboard; on the ground give --report-error");
    }
  }
  request.options.link.command_delay = static_cast<int>(asked.command_delay);
  request.options.link.longest_loss = static_cast<int>(asked.longest_loss);
  request.options.epoch = static_cast<std::uint32_t>(asked.epoch);
  return std::monostate{};
}

}  // namespace

Command guide_command() {
  const auto asked = std::make_shared<Asked>();
  Command guide(kName, kDescription, kDetails, [asked](const Command& command) {
    return settle(command, *asked).and_then([&] { return run_guide(asked->request); });
  });
  add_separation_options(guide, asked->request);
  add_flight_options(guide, *asked);
  add_figures(guide, asked->request.options.figures);
  add_running_options(guide, *asked);
  return guide;
}

}  // namespace beespace::cli
