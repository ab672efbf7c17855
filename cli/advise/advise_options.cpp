#include "cli/advise/advise_command.hpp"

namespace beespace::cli {
namespace {

constexpr const char* kDescription =
    "Tell every bee of a swarm how to fly on so that it keeps its distance";

constexpr const char* kDetails =
    "Reads where bees are and what they want: a table with the columns x, y, z (metres, z up), vx, "
    "vy,\n"
    "vz (without these everybody stands) and goal_x, goal_y, goal_z or want_vx, want_vy, want_vz "
    "(of\n"
    "both the wanted velocity counts, not the goal); perhaps id, max_speed_mps and\n"
    "max_acceleration_mps2, which count instead of --speed and --acceleration. Writes a line for "
    "each\n"
    "bee: id, vx, vy, vz, advice, certified. The velocity is the one nearest to its wish with "
    "which "
    "it\n"
    "can still brake clear of everybody else and of obstacles, if all do as advised; it is to be "
    "had at\n"
    "the end of the step (with --acceleration none: from its start). Who is too close already is "
    "not\n"
    "certified, and parts from the other; with --json these pairs are listed too.\n"
    "\n"
    "Advice:\n"
    "  as-wished  the wish, or as near to it as the bee's limits allow\n"
    "  deflected  another velocity, for the sake of others\n"
    "  braking    as hard as it can: there is nothing better\n"
    "  waiting    it stands, or all but, though it would like to fly: others are in its way\n"
    "\n"
    "Obstacles are a JSON document, as 'beespace simulate --help' shows it. Intruders are a table "
    "of x,\n"
    "y, z, vx, vy, vz: they do not do as advised, so everybody gives way to them as well as it "
    "can, "
    "and\n"
    "nothing is promised.\n"
    "\n"
    "Examples:\n"
    "  beespace advise swarm.csv --threshold 5 --speed 10 --acceleration 5\n"
    "  beespace advise swarm.csv --obstacles city.json --clearance 2 --output advice.json\n"
    "  beespace advise swarm.csv --intruders birds.csv --intruder-horizon 20 --fail-on-risk\n"
    "\n"
    "Exit status: 0 fine, 1 somebody is not certified or a conflict with an intruder lies ahead "
    "(with\n"
    "--fail-on-risk), 2 wrong usage, 3 bad input, 4 cannot open, read or write, 130 interrupted, "
    "143\n"
    "terminated, 141 closed pipe.";

void add_flight_options(Command& advise, AdviseCommandOptions& options) {
  advise.group("Flight");
  advise.option("--speed", "SPEED", options.speed, "The greatest, in m/s (default: 10)");
  advise.option("--acceleration", "A|none", options.acceleration,
                "The greatest, in m/s^2 (default: 5); none:\nvelocities change at once");
  advise.option("--step", "SECONDS", options.step, "How long until the next advice (default: 0.1)");
}

void add_prevention_options(Command& advise, AdviseCommandOptions& options) {
  advise.group("Separation");
  advise.option("--threshold", "LENGTH", options.threshold,
                "Closer than this is too close (default: 5)");
  advise.option("--uncertainty", "LENGTH", options.uncertainty,
                "How far from where it is said to be a bee may be\n(default: 0)");
  advise.option("--obstacles", "FILE", options.obstacles,
                "What stands in the way; - for standard input");
  advise.option("--clearance", "LENGTH", options.clearance,
                "Closer than this to an obstacle is too close\n(default: 1)");
  advise.option("--intruders", "FILE", options.intruders,
                "Who flies there and does not do as advised; - for\nstandard input");
  advise.option("--intruder-horizon", "SECONDS", options.intruder_horizon,
                "How long intruders are taken to fly straight on\n(default: 10)");
  advise.choice("--method", options.method, {"certified", "orca", "mvp"},
                "Who keeps them apart (default: certified); orca and\nmvp, to compare with, "
                "promise nothing");
  advise.option("--threads", "N", options.threads, "How many threads work (default: 0, all)");
}

void add_output_options(Command& advise, AdviseCommandOptions& options) {
  advise.group("Output");
  advise.option("-o,--output", "FILE", options.output,
                "Where the answer goes, by its ending .csv or .json,\nperhaps with .gz, in this "
                "form (default: standard\noutput)");
  advise.flag("--json", options.json, "One JSON document with everything in it");
  advise.flag("--fail-on-risk", options.fail_on_risk,
              "Exit with 1 when somebody is not certified, or a\nconflict with an intruder lies "
              "ahead");
  advise.flag("--quiet", options.quiet, "No summary and no progress, only errors");
}

}  // namespace

Command advise_command(AdviseCommandOptions& options) {
  Command advise("advise", kDescription, kDetails, [&options] { return run_advise(options); });
  advise.argument("FILE", options.input, "What to read (default, or -: standard input)");
  add_flight_options(advise, options);
  add_prevention_options(advise, options);
  add_output_options(advise, options);
  return advise;
}

}  // namespace beespace::cli
