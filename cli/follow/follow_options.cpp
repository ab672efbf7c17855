#include "cli/command_line/option_values.hpp"
#include "cli/console/terminal.hpp"
#include "cli/follow/follow_command.hpp"
#include "cli/follow/follow_request.hpp"
#include "cli/input/moving_options.hpp"
#include "cli/input/number_list.hpp"
#include "io/fleet/fleet_reader.hpp"

#include <memory>

namespace beespace::cli {
namespace {

constexpr const char* kName = "follow";

constexpr const char* kDescription =
    "Follow as an agent of 'beespace guide': commands in, acknowledgements and reports out";

constexpr const char* kDetails =
    "The agent's side of the protocol, for a companion computer and for tests. Reads messages, an "
    "object\n"
    "of JSON a line, from standard input: command, hello, measured (where it is), lose, tick; "
    "lines "
    "about\n"
    "other agents and lines that are wrong are left out. Writes join, ack, report, adopt, and "
    "with\n"
    "--setpoints where to be. Takes a command or refuses it so that the agent is always on a "
    "branch "
    "that\n"
    "its planner still counts with, whatever is lost, late, doubled or out of order. What every "
    "field\n"
    "means is in docs/fleet-messages.md.\n"
    "With --store it remembers its branch on the disk, before it acknowledges, and goes on with it "
    "after a\n"
    "restart. Without, a restart loses it: its planner then names the agent.\n"
    "--period and --planned-acceleration must be those of the planner, which 'beespace guide' "
    "prints when\n"
    "it starts; commands that were planned with others are refused, and said.\n"
    "\n"
    "Examples:\n"
    "  beespace follow --agent 7 --planned-speed 8 --planned-acceleration 4 --start 0,0,30 \\\n"
    "    --store /var/lib/bee-7.json --setpoints\n"
    "  beespace follow --agent a --planned-speed 8 --planned-acceleration 4 --start 0,0,30 "
    "--simulated\n"
    "\n"
    "Exit status: 0 fine, 2 wrong usage, 3 bad store, 4 cannot read, write or store, 129 hung up, "
    "130\n"
    "interrupted, 143 terminated, 141 closed pipe.";

void add_agent_options(Command& follow, FollowRequest& request) {
  follow.group("Agent");
  follow.option("--agent", "ID", request.agent, "Who it is: a text or a number").required = true;
  follow
      .option("--planned-speed", "SPEED", request.planned.max_speed_mps, read_speed,
              "The greatest that is planned with, in m/s: as the\nguide prints it")
      .required = true;
  follow
      .option("--planned-acceleration", "A", request.planned.max_acceleration_mps2,
              amount("metres per second squared", kAboveZero), "The same in m/s^2: so it brakes")
      .required = true;
  follow.option("--period", "SECONDS", request.period_s, read_span,
                "A tick, in seconds, without a unit (default: 0.1)");
  follow.option("--radius", "LENGTH", request.radius_m, length_from(0.0),
                "Its own radius (default: 0)");
  follow.option("--start", "X,Y,Z", request.start, read_point,
                "Where it stands, in metres: it asks to join there,\nuntil it is in the fleet");
  follow.option("--store", "FILE", request.store,
                "Where it remembers its branch: the file is made, or\ngone on with");
}

void add_output_options(Command& follow, FollowRequest& request) {
  follow.group("Time and output");
  follow.flag("--ticks-from-input", request.ticks_from_input,
              "Ticks come as messages, not by the clock");
  follow.flag("--simulated", request.simulated,
              "Report its nominal position, as if it flew exactly;\nwithout, only what 'measured' "
              "messages say");
  follow.option("--report-every", "N", request.report_every, whole(1, 1'000'000),
                "With --simulated, report every so many ticks\n(default: 1)");
  follow.flag("--setpoints", request.setpoints, "In every tick also say where to be");
  add_quiet_option(follow, request.quiet);
}

Status settle(const FollowRequest& request) {
  if (request.agent.empty() || request.agent.size() > io::FleetReader::kLongestId) {
    return usage_error(kName, "--agent is a text of 1 to 64 bytes");
  }
  if (input_is_terminal()) {
    return usage_error(kName, "pipe the messages in, from 'beespace guide'");
  }
  return std::monostate{};
}

}  // namespace

Command follow_command() {
  const auto request = std::make_shared<FollowRequest>();
  Command follow(kName, kDescription, kDetails, [request](const Command&) {
    return settle(*request).and_then([&] { return run_follow(*request); });
  });
  add_agent_options(follow, *request);
  add_output_options(follow, *request);
  return follow;
}

}  // namespace beespace::cli
