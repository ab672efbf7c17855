#include "cli/recorded/predict_command.hpp"

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

Command predict_command(PredictCommandOptions& options) {
  Command predict("predict", kDescription, kDetails, [&options] { return run_predict(options); });
  predict.arguments("FILE", options.moving.inputs, "What to read (default, or -: standard input)")
      .takes = Option::Takes::kOne;
  add_input_options(predict, options.moving);
  predict.group("Input");
  predict.option("--max-age", "SECONDS", options.max_age,
                 "Leave out who was not heard of for so long (default: 30)");
  add_separation_options(predict, options.moving);
  predict.group("Separation");
  predict.option("--horizon", "SECONDS", options.horizon, "How far to look ahead (default: 60)");
  add_output_options(predict, options.moving);
  return predict;
}

}  // namespace beespace::cli
