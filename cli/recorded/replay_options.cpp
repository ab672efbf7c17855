#include "cli/command_line/option_values.hpp"
#include "cli/recorded/replay_command.hpp"
#include "cli/recorded/replay_out_of_core.hpp"

#include <memory>

namespace beespace::cli {
namespace {

constexpr const char* kReplayDescription =
    "Tell whether a recording, or a drone show, keeps its distance";

constexpr const char* kReplayDetails =
    "Reads recordings: text tables with columns named id, time_s, x, y, z (metres) or lon, lat, "
    "height\n"
    "(degrees), several files, folders or zips with a table a bee, and Skybrush shows (.skyc, or "
    "one\n"
    "JSON file), aircraft as traffic, OpenSky and Flightradar24 have them (CSV, JSON), readsb's\n"
    "aircraft.json, logs of gliders (.igc), segments of so6, DAIDALUS encounters, animals as\n"
    "Movebank, trackdf, TRex, idtracker.ai and EthoVision have them, logs of PX4 (.ulg) and\n"
    "ArduPilot (.bin), a drone each, and of MAVLink (.tlog), poses of ROS, Motive, Vicon and QTM. "
    "Between two fixes a bee "
    "moves\n"
    "in a\n"
    "straight line, so a pass between fixes is found as well. Where the input has velocities, "
    "curves with\n"
    "these are looked at too, and who comes too close along them alone is reported as possible "
    "(with\n"
    "--straight not); curves of shows are followed to within --tolerance, and what that leaves "
    "open "
    "is also\n"
    "reported as possible, not left out. Between fixes farther apart in time than --max-gap it is "
    "unknown "
    "where a\n"
    "bee was, and before its first fix and after its last one: the verdict is about the known "
    "time, "
    "and\n"
    "says for how long which bees are unknown. A flight is shown behind its aircraft: a1b2c3 "
    "(UAL123).\n"
    "Writes the report, a table under a header line, to standard output and a summary to standard "
    "error.\n"
    "\n"
    "Reports, and what their lines say:\n"
    "  conflicts   id, id, when it begins, when it is closest, how close, when it ends (and "
    "whether "
    "it\n"
    "              is certain, where there are curves of shows or velocities; and where some are "
    "lost\n"
    "              for a time, whether one of the two is unknown just before it or after it)\n"
    "  pairs       each pair in conflict: id, id, conflicts, time in conflict, when it is closest, "
    "how close,\n"
    "              for how long one of the two is unknown\n"
    "  bees        each bee: id, conflicts, time in conflict, its closest in conflict, of drones "
    "always: how\n"
    "              close, when, with whom; for how long it is unknown\n"
    "  separation  how far apart the closest two are in a straight line, every so often: time,\n"
    "              distance, id, id, how many are unknown\n"
    "  events      what 'beespace watch' would have said, line by line, with the gaps of the "
    "others\n"
    "\n"
    "Examples:\n"
    "  beespace replay show.skyc\n"
    "  beespace replay flight.csv --threshold 5 --max-gap 2 --output conflicts.csv\n"
    "  beespace replay north.ulg south.ulg --threshold 5\n"
    "  beespace replay logs/ --threshold 10 --report bees\n"
    "  beespace replay storks.csv --threshold 50 --report pairs --time-zone Europe/Madrid\n"
    "  beespace replay fish.csv --threshold 3mm --fps 25 --scale 0.1mm\n"
    "  beespace replay show.skyc --fail-on-risk --quiet --output /dev/null\n"
    "\n"
    "Exit status: 0 fine, 1 there is a conflict, or a gap or records left out that may hide one "
    "(with --fail-on-risk), "
    "2\n"
    "wrong usage, 3 bad input or more than --max-results, 4 cannot open, read or write, 130 "
    "interrupted,\n"
    "143 terminated, 141 closed pipe.";

// An option that the report would ignore is a misunderstanding.
Status check_fit(const Command& command, const ReplayRequest& request) {
  const struct {
    const char* option;
    const char* report;
  } table[] = {{"--every", "separation"},
               {"--horizon", "events"},
               {"--leave-factor", "events"},
               {"--look-every", "events"}};
  for (const auto& [option, report] : table) {
    if (report == request.report || !command.is_given(option)) continue;
    return usage_error("replay", std::string(option) + " does not apply to --report " +
                                     request.report + "; leave it out, or say --report " + report);
  }
  if (request.moving.inclusive && request.report == "events") {
    return usage_error("replay",
                       "--inclusive does not apply to --report events, in which exactly the "
                       "threshold is never too close; leave it out");
  }
  if (request.moving.ignore_below_m && request.report == "events") {
    return usage_error("replay", "--ignore-below does not apply to --report events; leave it out");
  }
  return std::monostate{};
}

Status check_memory(const ReplayRequest& request) {
  if (!request.memory_bytes) {
    return request.temporary.empty() ? Status(std::monostate{})
                                     : usage_error("replay", "--temporary goes with --memory");
  }
  if (request.moving.ignore_below_m) {
    return usage_error("replay", "--memory does not take --ignore-below; leave one of them out");
  }
  if (request.report == "conflicts" || request.report == "pairs" || request.report == "bees") {
    return std::monostate{};
  }
  return usage_error("replay", "--memory does not take --report " + request.report +
                                   ", for which all bees must be in memory; it takes conflicts, "
                                   "pairs and bees");
}

Status settle(const Command& command, ReplayRequest& request) {
  if (Status fit = check_fit(command, request); !fit) return fit;
  if (Status fit = check_memory(request); !fit) return fit;
  // Bees fly straight from fix to fix; only events predict where they go.
  request.moving.load.velocities_needed = request.report == "events";
  // Events are lines of JSON.
  if (request.report == "events")
    return settle_answer(request.moving, "replay", {"jsonl", "ndjson"});
  return settle_answer(request.moving, "replay");
}

}  // namespace

Command replay_command() {
  const auto request = std::make_shared<ReplayRequest>();
  MovingRequest& moving = request->moving;
  Command replay("replay", kReplayDescription, kReplayDetails, [request](const Command& command) {
    return settle(command, *request).and_then([&] {
      return request->memory_bytes ? run_replay_out_of_core(*request) : run_replay(*request);
    });
  });
  replay.arguments("FILES", moving.inputs,
                   "Files and folders to read (default, or -:\nstandard input)");
  add_input_options(replay, moving);
  add_gap_options(replay, request->max_gap_s, request->tolerance_m);
  add_sector_option(replay, moving.load);
  replay.flag("--straight", request->straight, "Straight lines, whatever the velocities");
  add_separation_options(replay, moving);
  add_low_option(replay, moving);
  replay.choice("--report", request->report, {"conflicts", "pairs", "bees", "separation", "events"},
                "What to find, see below (default: conflicts)", "WHAT");
  replay.option("--every", "SECONDS", request->every_s, amount("seconds", kAboveZero),
                "How often --report separation looks (default: 1)");
  replay.group("Events");
  add_live_options(replay, request->live);
  replay.group("Memory");
  replay.option("--memory", "SIZE", request->memory_bytes, read_memory,
                "Use so much memory and temporary files, for tables\nthat do not fit: 500MB, 4GB "
                "(conflicts, pairs and bees only)");
  replay.option("--temporary", "FOLDER", request->temporary, take_text,
                "Where temporary files go, which have no name\n(default: $TMPDIR, or /var/tmp)");
  add_form_options(replay, moving);
  add_risk_option(replay, moving);
  add_quiet_option(replay, moving.quiet);
  return replay;
}

}  // namespace beespace::cli
