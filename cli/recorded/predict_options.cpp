#include "cli/command_line/option_values.hpp"
#include "cli/recorded/predict_command.hpp"

#include <memory>

namespace beespace::cli {
namespace {

constexpr const char* kPredictDescription =
    "Tell which bees are about to come too close to each other";

constexpr const char* kPredictDetails =
    "Reads where bees are and how fast they fly: text tables with columns named x, y, z, vx, vy, "
    "vz\n"
    "(metres, metres per second) or lon, lat, height, ve, vn, vu (degrees; east, north, up), and "
    "id\n"
    "and time where there are such; aircraft as traffic, OpenSky and Flightradar24 have them "
    "(CSV,\n"
    "JSON), readsb's aircraft.json, BlueSky scenarios, logs of PX4 (.ulg), ArduPilot (.bin) and "
    "MAVLink (.tlog).\n"
    "All "
    "bees fly on in\n"
    "straight lines. Writes a line for each pair in conflict: id, id, when it begins, when it is\n"
    "closest, how close in metres, when it ends.\n"
    "These times lie between now and the horizon: a conflict that goes on now begins now, and one "
    "that\n"
    "still goes on at the horizon ends there. A bee of which it is not known how fast it goes is "
    "checked\n"
    "for now only, where it was last heard of. Of a recording only what lies after its end is "
    "looked\n"
    "at, exit status included: 'beespace replay' is for what happened in it. A flight is shown "
    "behind its aircraft: a1b2c3 "
    "(UAL123).\n"
    "\n"
    "Examples:\n"
    "  beespace predict swarm.csv --threshold 5 --horizon 60\n"
    "  beespace predict aircraft.json --separation enroute --output conflicts.csv\n"
    "  beespace generate --scene flight --points 1000 | beespace predict --threshold 10\n"
    "\n"
    "Exit status: 0 fine, 1 there is a conflict, or nothing to compare, or a bee of which it is "
    "not\n"
    "known where it goes (with --fail-on-risk), 2 wrong usage, 3 bad input or more than "
    "--max-results, 4 cannot open, read or write, 130 interrupted, 143 terminated, 141\n"
    "closed pipe.";

}  // namespace

Command predict_command() {
  const auto request = std::make_shared<PredictRequest>();
  MovingRequest& moving = request->moving;
  Command predict("predict", kPredictDescription, kPredictDetails, [request](const Command&) {
    return settle_answer(request->moving, "predict").and_then([&] {
      return run_predict(*request);
    });
  });
  predict.arguments("FILES", moving.inputs,
                    "Files and folders to read (default, or -:\nstandard input)");
  add_input_options(predict, moving);
  predict.option("--max-age", "SECONDS", request->max_age_s, amount("seconds", kFromZero),
                 "Leave out who was not heard of for so long (default: 30)");
  add_separation_options(predict, moving);
  predict.option("--horizon", "SECONDS", request->horizon_s, amount("seconds", kFromZero),
                 "How far to look ahead (default: 60; of\naircraft: 300)");
  add_form_options(predict, moving);
  add_risk_option(predict, moving);
  add_quiet_option(predict, moving.quiet);
  return predict;
}

}  // namespace beespace::cli
