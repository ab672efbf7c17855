#include "cli/advise/advise_command.hpp"
#include "cli/advise/advise_request.hpp"
#include "cli/command_line/option_values.hpp"
#include "cli/console/terminal.hpp"
#include "cli/input/moving_options.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace beespace::cli {
namespace {

constexpr const char* kDescription =
    "Tell every bee of a swarm how to fly on so that it keeps its distance";

constexpr const char* kDetails =
    "Reads where bees are and what they want: a table with the columns x, y, z (metres, z up), vx, "
    "vy,\n"
    "vz (without these all bees stand) and goal_x, goal_y, goal_z or want_vx, want_vy, want_vz "
    "(of\n"
    "both the wanted velocity counts, not the goal); perhaps id, max_speed_mps and\n"
    "max_acceleration_mps2, which count instead of --speed and --acceleration. Writes a line for "
    "each\n"
    "bee: id, vx, vy, vz, advice, certified. The velocity is the one nearest to the preferred\n"
    "one with which it can still brake clear of all others and of obstacles, if all do as advised; "
    "it is to be "
    "had at\n"
    "the end of the step (with --acceleration none: from its start). Who is too close already is "
    "not\n"
    "certified, and parts from the other; with --json these pairs are listed too.\n"
    "\n"
    "Advice:\n"
    "  as-preferred  the preferred velocity, or as near to it as the bee's limits allow\n"
    "  deflected     another velocity, for the sake of others\n"
    "  braking       as hard as it can: there is nothing better\n"
    "  waiting       it stands, or all but, though it would like to fly: others are in its way\n"
    "\n"
    "Obstacles are a JSON document, as 'beespace simulate --help' shows it. Intruders are a table "
    "of x,\n"
    "y, z, vx, vy, vz: they do not do as advised, so all bees give way to them as well as it "
    "can, "
    "and\n"
    "nothing is promised.\n"
    "\n"
    "Examples:\n"
    "  beespace advise swarm.csv --threshold 5 --speed 10 --acceleration 5\n"
    "  beespace advise swarm.csv --obstacles city.json --clearance 2 --output advice.json\n"
    "  beespace advise swarm.csv --intruders birds.csv --intruder-horizon 20 --fail-on-risk\n"
    "\n"
    "Exit status: 0 fine, 1 a bee is not certified or a conflict with an intruder lies ahead "
    "(with\n"
    "--fail-on-risk), 2 wrong usage, 3 bad input, 4 cannot open, read or write, 130 interrupted, "
    "143\n"
    "terminated, 141 closed pipe.";

void add_flight_options(Command& advise, AdviseRequest& request) {
  advise.group("Flight");
  advise.option("--speed", "SPEED", request.limits.max_speed_mps, read_speed,
                "The greatest, in m/s (default: 10)");
  advise.option("--acceleration", "A|none", request.limits.max_acceleration_mps2, read_acceleration,
                "The greatest, in m/s^2 (default: 5); none:\nvelocities change at once");
  advise.option("--step", "SECONDS", request.advice.step_s, read_span,
                "How long until the next advice (default: 0.1)");
}

void add_prevention_options(Command& advise, AdviseRequest& request) {
  AdviseOptions& advice = request.advice;
  advise.group("Separation");
  advise.option("--threshold", "LENGTH", advice.threshold_m, read_threshold_in_motion,
                "Closer than this is too close (default: 5)");
  advise.option("--uncertainty", "LENGTH", advice.uncertainty_m, length_from(0.0),
                "How far from where it is said to be a bee may be\n(default: 0)");
  advise.option("--obstacles", "FILE", request.obstacles,
                "What stands in the way; - for standard input");
  advise.option("--clearance", "LENGTH", advice.clearance_m, length_from(kLeastLength_m),
                "Closer than this to an obstacle is too close\n(default: 1)");
  advise.option("--intruders", "FILE", request.intruders,
                "Who flies there and does not do as advised; - for\nstandard input");
  advise.option("--intruder-horizon", "SECONDS", advice.intruder_horizon_s, read_span,
                "How long intruders are taken to fly straight on\n(default: 10)");
  advise.choice("--method", advice.method,
                {{"certified", AdviseMethod::kCertified},
                 {"orca", AdviseMethod::kOrca},
                 {"mvp", AdviseMethod::kMvp}},
                "Who keeps them apart (default: certified); orca and\nmvp, to compare with, "
                "promise nothing");
  advise.option("--threads", "N", advice.threads, read_threads,
                "How many threads work (default: 0, all)");
}

void add_output_options(Command& advise, AdviseRequest& request) {
  advise.group("Output");
  advise.option("-o,--output", "FILE", request.output,
                "Where the answer goes, by its ending .csv or .json,\nperhaps with .gz, in this "
                "form (default: standard\noutput)");
  advise.flag("--json", request.json, "One JSON document with everything in it");
  advise.flag("--fail-on-risk", request.fail_on_risk,
              "Exit with 1 when a bee is not certified, or a\nconflict with an intruder lies "
              "ahead");
  add_quiet_option(advise, request.quiet);
}

// An option that would be ignored is a misunderstanding.
Status check_fit(const Command& command, const AdviseRequest& request) {
  if (request.input.empty() && input_is_terminal()) {
    return advise_error("say which file to read, or pipe the swarm in");
  }
  const std::array<std::string, 3> inputs = {request.input.empty() ? "-" : request.input,
                                             request.obstacles, request.intruders};
  if (std::count(inputs.begin(), inputs.end(), "-") > 1) {
    return advise_error("standard input can be read once; give the others as files");
  }
  if (command.is_given("--clearance") && request.obstacles.empty()) {
    return advise_error("--clearance is of obstacles, and there are none; add --obstacles");
  }
  if (command.is_given("--intruder-horizon") && request.intruders.empty()) {
    return advise_error("--intruder-horizon is of intruders, and there are none; add --intruders");
  }
  if (request.advice.method == AdviseMethod::kCertified) return std::monostate{};
  const std::string method = std::string("--method ").append(command.typed("--method"));
  if (!request.obstacles.empty() || !request.intruders.empty()) {
    return advise_error(method +
                        " knows nothing of obstacles and intruders; leave them out, or let it be "
                        "certified");
  }
  if (request.fail_on_risk) {
    return advise_error(method +
                        " certifies no bee, so --fail-on-risk would always fail; leave it out");
  }
  return std::monostate{};
}

Status settle(const Command& command, AdviseRequest& request) {
  if (Status fit = check_fit(command, request); !fit) return fit;
  if (request.input.empty()) request.input += '-';
  request.speed_given = command.is_given("--speed");
  request.acceleration_given = command.is_given("--acceleration");
  return output_form("advise", {request.output, false, request.json}, {{Form::kCsv, Form::kJson}})
      .transform([&](const OutputForm& form) { request.form = form; });
}

}  // namespace

Error advise_error(std::string message) {
  return usage_error("advise", std::move(message));
}

Command advise_command() {
  const auto request = std::make_shared<AdviseRequest>();
  Command advise("advise", kDescription, kDetails, [request](const Command& command) {
    return settle(command, *request).and_then([&] { return run_advise(*request); });
  });
  advise.argument("FILE", request->input, "What to read (default, or -: standard input)");
  add_flight_options(advise, *request);
  add_prevention_options(advise, *request);
  add_output_options(advise, *request);
  return advise;
}

}  // namespace beespace::cli
