#include "cli/command_line/option_checks.hpp"
#include "cli/recorded/predict_command.hpp"

#include <beespace/version.hpp>

#include <CLI/CLI.hpp>

#include <string>

namespace beespace::cli {
namespace {

constexpr const char* kDescription = "Tell which bees are about to come too close to each other";

constexpr const char* kDetails =
    "Reads where bees are and how fast they fly: text tables with columns named x, y, z, vx, vy, "
    "vz\n"
    "(metres, metres per second) or lon, lat, height, ve, vn, vu (degrees; east, north, up), and "
    "id\n"
    "and time where there are such. Everybody flies on in a straight line. Writes a line for each\n"
    "pair in conflict: id, id, when it begins, when it is closest, how close in metres, when it "
    "ends.\n"
    "These times lie between now and the horizon: a conflict that goes on now begins now, and one "
    "that\n"
    "still goes on at the horizon ends there. A bee of which it is not known how fast it goes is "
    "checked\n"
    "for now only, where it was last heard of. A flight is shown behind its aircraft: a1b2c3 "
    "(UAL123).\n"
    "\n"
    "Examples:\n"
    "  beespace predict swarm.csv --threshold 5 --horizon 60\n"
    "  beespace predict traffic.csv --threshold 5NM --vertical 1000ft --output conflicts.csv\n"
    "  beespace generate --scene flight --points 1000 | beespace predict --threshold 10\n"
    "\n"
    "Exit status: 0 fine, 1 there is a conflict (with --fail-on-risk), 2 wrong usage, 3 bad input "
    "or\n"
    "more than --max-results, 4 cannot open, read or write, 130 interrupted, 143 terminated, 141\n"
    "closed pipe.";

}  // namespace

CLI::App* add_predict_command(CLI::App& command, PredictCommandOptions& options) {
  CLI::App* predict = command.add_subcommand("predict", kDescription);
  predict->footer(kDetails);
  predict->set_version_flag("--version", std::string(version()), "Print the version and exit");
  predict->add_option("FILE", options.moving.inputs, "What to read (default, or -: standard input)")
      ->type_name(" ")
      ->expected(0, 1);
  add_input_options(*predict, options.moving);
  predict
      ->add_option("--max-age", options.max_age,
                   "Leave out who was not heard of for so long (default: 30)")
      ->type_name("SECONDS")
      ->group("Input");
  add_separation_options(*predict, options.moving);
  predict->add_option("--horizon", options.horizon, "How far to look ahead (default: 60)")
      ->type_name("SECONDS")
      ->group("Separation");
  add_output_options(*predict, options.moving);
  refuse_pointless_values(*predict);
  return predict;
}

}  // namespace beespace::cli
