#include "cli/fleet/fleet_output.hpp"

#include "io/bytes/number_text.hpp"
#include "io/json/json_writer.hpp"
#include "io/recording/moment_text.hpp"

#include <beespace/version.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace beespace::cli {
namespace {

using analysis::Extreme;
using analysis::FarthestFix;
using analysis::TrackingFigures;

std::string line_of(const char* name, const Extreme& extreme, const char* unit) {
  return std::string(name) + io::grouped(extreme.greatest, 3) + unit +
         " (99.9 %: " + io::grouped(extreme.usual, 3) + unit + ")\n";
}

// Rounded up to the millimetre: it is a bound.
double up(double value) {
  return std::ceil(value * 1e3) / 1e3;
}

// Of all bees the one that strayed farthest.
std::optional<std::size_t> farthest_bee(const TrackingFigures& figures) {
  std::optional<std::size_t> farthest;
  for (std::size_t i = 0; i < figures.farthest.size(); ++i) {
    if (!figures.farthest[i]) continue;
    if (!farthest || figures.farthest[i]->deviation_m > figures.farthest[*farthest]->deviation_m) {
      farthest = i;
    }
  }
  return farthest;
}

std::string farthest_line(const FleetAnswer& answer) {
  const auto bee = farthest_bee(answer.figures);
  if (!bee) return {};
  const FarthestFix& fix = *answer.figures.farthest[*bee];
  const std::string& id = answer.both.flown_ids[*bee];
  const std::string& set_id = answer.both.set_ids[*bee];
  std::string line = "farthest      " + id;
  if (set_id != id) line += " (" + set_id + ")";
  return line + ", " + io::grouped(fix.deviation_m, 3) + " m from where it was set to be at " +
         io::moment_text(fix.time_s, answer.flown) + "\n";
}

void write_extreme(io::JsonWriter& json, const char* name, const Extreme& extreme) {
  json.begin_object(name);
  json.member("greatest", extreme.greatest).member("usual", extreme.usual).end();
}

void write_farthest(io::JsonWriter& json, const FleetAnswer& answer, std::size_t bee) {
  json.member("id", answer.both.flown_ids[bee]).member("set_id", answer.both.set_ids[bee]);
  const auto& fix = answer.figures.farthest[bee];
  json.member("deviation_m",
              fix ? std::optional<double>(fix->deviation_m) : std::optional<double>());
  const io::Calendar calendar = io::calendar_of(answer.flown);
  if (fix && calendar.tells()) {
    json.member("at", calendar.text(fix->time_s));
  } else if (fix) {
    json.member("at_s", fix->time_s);
  }
}

void write_each(io::JsonWriter& json, const FleetAnswer& answer) {
  if (const auto bee = farthest_bee(answer.figures)) {
    json.begin_object("farthest");
    write_farthest(json, answer, *bee);
    json.end();
  }
  json.begin_array("each", io::JsonLayout::kLines);
  for (std::size_t bee = 0; bee < answer.both.bees.size(); ++bee) {
    json.begin_object();
    write_farthest(json, answer, bee);
    json.end();
  }
  json.end();
}

}  // namespace

std::string fleet_text(const FleetAnswer& answer) {
  const TrackingFigures& figures = answer.figures;
  std::string text = io::counted(answer.both.bees.size(), "bee", "bees") + ", " +
                     io::counted(figures.fixes, "fix", "fixes") + " compared";
  if (figures.not_set > 0) text += ", at " + io::grouped(figures.not_set) + " nothing was set";
  if (answer.both.only_one > 0) {
    text += ", " + io::counted(answer.both.only_one, "id", "ids") + " in one of both only";
  }
  text += '\n' + line_of("deviation     ", figures.deviation_m, " m") + farthest_line(answer) +
          line_of("rate          ", figures.rate_mps, " m/s") +
          line_of("acceleration  ", figures.acceleration_mps2, " m/s^2");
  if (figures.lag_s) {
    text += "lag           " + io::grouped(*figures.lag_s, 2) + " s\n" +
            line_of("without it    ", figures.without_lag_m, " m");
  } else {
    text += "lag           none that could be told\n";
  }
  return text +
         "to plan with  sensing_error_m = " + io::grouped(up(figures.deviation_m.greatest), 3) +
         ", deviation_mps = 0, correction_mps = " + io::grouped(up(figures.rate_mps.greatest), 3) +
         "\nNot told: how wrong flown positions are themselves. Add that to sensing_error_m and "
         "report_error_m.\n";
}

std::string fleet_json(const FleetAnswer& answer) {
  const TrackingFigures& figures = answer.figures;
  std::string text;
  {
    io::JsonWriter json(text, io::JsonLayout::kLines);
    json.begin_object(io::JsonLayout::kLines);
    json.member("version", version()).member("command", "fleet");
    json.member("bees", std::uint64_t{answer.both.bees.size()});
    json.member("only_one", std::uint64_t{answer.both.only_one});
    json.member("fixes", figures.fixes).member("not_set", figures.not_set);
    write_extreme(json, "deviation_m", figures.deviation_m);
    write_extreme(json, "rate_mps", figures.rate_mps);
    write_extreme(json, "acceleration_mps2", figures.acceleration_mps2);
    json.member("lag_s", figures.lag_s);
    write_extreme(json, "without_lag_m", figures.without_lag_m);
    json.begin_object("plan").member("sensing_error_m", up(figures.deviation_m.greatest));
    json.member("deviation_mps", 0.0);
    json.member("correction_mps", up(figures.rate_mps.greatest)).end();
    write_each(json, answer);
    json.end();
  }
  return text + '\n';
}

}  // namespace beespace::cli
