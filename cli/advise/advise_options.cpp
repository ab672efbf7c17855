#include "cli/advise/advise_command.hpp"
#include "cli/command_line/option_checks.hpp"

#include <beespace/version.hpp>

#include <CLI/CLI.hpp>

#include <string>

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

void add_flight_options(CLI::App& advise, AdviseCommandOptions& options) {
  advise.add_option("--speed", options.speed, "The greatest, in m/s (default: 10)")
      ->type_name("SPEED")
      ->group("Flight");
  advise
      .add_option("--acceleration", options.acceleration,
                  "The greatest, in m/s^2 (default: 5); none:\nvelocities change at once")
      ->type_name("A|none")
      ->group("Flight");
  advise.add_option("--step", options.step, "How long until the next advice (default: 0.1)")
      ->type_name("SECONDS")
      ->group("Flight");
}

void add_prevention_options(CLI::App& advise, AdviseCommandOptions& options) {
  advise.add_option("--threshold", options.threshold, "Closer than this is too close (default: 5)")
      ->type_name("LENGTH")
      ->group("Separation");
  advise
      .add_option("--uncertainty", options.uncertainty,
                  "How far from where it is said to be a bee may be\n(default: 0)")
      ->type_name("LENGTH")
      ->group("Separation");
  advise
      .add_option("--obstacles", options.obstacles, "What stands in the way; - for standard input")
      ->type_name("FILE")
      ->group("Separation");
  advise
      .add_option("--clearance", options.clearance,
                  "Closer than this to an obstacle is too close\n(default: 1)")
      ->type_name("LENGTH")
      ->group("Separation");
  advise
      .add_option("--intruders", options.intruders,
                  "Who flies there and does not do as advised; - for\nstandard input")
      ->type_name("FILE")
      ->group("Separation");
  advise
      .add_option("--intruder-horizon", options.intruder_horizon,
                  "How long intruders are taken to fly straight on\n(default: 10)")
      ->type_name("SECONDS")
      ->group("Separation");
  CLI::Option* method =
      advise
          .add_option("--method", options.method,
                      "Who keeps them apart (default: certified); orca and\nmvp, to compare with, "
                      "promise nothing")
          ->type_name("certified|orca|mvp")
          ->group("Separation");
  allow_only(*method, {"certified", "orca", "mvp"});
  advise.add_option("--threads", options.threads, "How many threads work (default: 0, all)")
      ->type_name("N")
      ->group("Separation");
}

void add_output_options(CLI::App& advise, AdviseCommandOptions& options) {
  advise
      .add_option("-o,--output", options.output,
                  "Where the answer goes, by its ending .csv or .json,\nperhaps with .gz, in this "
                  "form (default: standard\noutput)")
      ->type_name("FILE")
      ->group("Output");
  advise.add_flag("--json", options.json, "One JSON document with everything in it")
      ->group("Output");
  advise
      .add_flag("--fail-on-risk", options.fail_on_risk,
                "Exit with 1 when somebody is not certified, or a\nconflict with an intruder lies "
                "ahead")
      ->group("Output");
  advise.add_flag("--quiet", options.quiet, "No summary and no progress, only errors")
      ->group("Output");
}

}  // namespace

CLI::App* add_advise_command(CLI::App& command, AdviseCommandOptions& options) {
  CLI::App* advise = command.add_subcommand("advise", kDescription);
  advise->footer(kDetails);
  advise->set_version_flag("--version", std::string(version()), "Print the version and exit");
  advise->add_option("FILE", options.input, "What to read (default, or -: standard input)")
      ->type_name(" ");
  add_flight_options(*advise, options);
  add_prevention_options(*advise, options);
  add_output_options(*advise, options);
  refuse_pointless_values(*advise);
  return advise;
}

}  // namespace beespace::cli
