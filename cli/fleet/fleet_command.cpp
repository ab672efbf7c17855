#include "cli/fleet/fleet_command.hpp"

#include "analysis/recorded/gaps.hpp"
#include "analysis/recorded/tracking_figures.hpp"
#include "analysis/recorded/tracks.hpp"
#include "cli/console/standard_output.hpp"
#include "cli/console/terminal.hpp"
#include "cli/input/moving_output.hpp"
#include "io/bytes/number_text.hpp"
#include "io/json/json_writer.hpp"
#include "io/load_recording.hpp"

#include <beespace/version.hpp>

#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

using analysis::Extreme;
using analysis::SetAndFlown;
using analysis::TrackingFigures;

constexpr double kTolerance_m = 0.01;  // of shows, whose paths are curves

struct Compared {
  std::size_t bees = 0;      // that were set and flown
  std::size_t only_one = 0;  // of which one of both is there
  TrackingFigures figures;
};

Result<std::vector<Track>> tracks_in_space(const io::Recording& recording) {
  return tracks_of(recording, analysis::Geometry::kSpace, kTolerance_m);
}

Error cannot_compare(std::string what) {
  return {ErrorCode::kUnsupportedFormat, std::move(what), {}};
}

Result<Compared> compare(const io::Recording& flown, const io::Recording& set, double max_gap_s) {
  if (flown.frame != set.frame) {
    return cannot_compare(
        "of what was set and what was flown, one is in degrees and the other in metres; give both "
        "in the same: of a show and logs in degrees, the logs as a table, with the columns "
        "id,time_s,x_m,y_m,z_m: the ids of the show, seconds since it began, and metres from its "
        "place of take-off along its own axes");
  }
  auto flown_tracks = tracks_in_space(flown);
  if (!flown_tracks) return flown_tracks.error();
  auto set_tracks = tracks_in_space(set);
  if (!set_tracks) return set_tracks.error();
  std::map<std::string, std::size_t> set_by_id;
  for (std::size_t i = 0; i < set.bees.size(); ++i) set_by_id.emplace(set.bees[i].id, i);
  std::vector<SetAndFlown> bees;
  for (std::size_t i = 0; i < flown.bees.size(); ++i) {
    const auto found = set_by_id.find(flown.bees[i].id);
    if (found == set_by_id.end()) continue;
    bees.push_back({std::move((*set_tracks)[found->second]), std::move((*flown_tracks)[i])});
  }
  Compared compared{.bees = bees.size(),
                    .only_one = flown.bees.size() + set.bees.size() - 2 * bees.size(),
                    .figures = analysis::tracking_figures(bees, max_gap_s)};
  if (compared.figures.fixes > 0) return compared;
  return cannot_compare(bees.empty()
                            ? "no bee was both set and flown: their ids differ"
                            : "nothing was set at the times of flown fixes; bring both to the "
                              "same clock");
}

std::string line_of(const char* name, const Extreme& extreme, const char* unit) {
  return std::string(name) + io::grouped(extreme.greatest, 3) + unit +
         " (99.9 %: " + io::grouped(extreme.usual, 3) + unit + ")\n";
}

// Rounded up to the millimetre: it is a bound.
double up(double value) {
  return std::ceil(value * 1e3) / 1e3;
}

std::string text_of(const Compared& compared) {
  const TrackingFigures& figures = compared.figures;
  std::string text = io::counted(compared.bees, "bee", "bees") + ", " +
                     io::counted(figures.fixes, "fix", "fixes") + " compared";
  if (figures.not_set > 0) text += ", at " + io::grouped(figures.not_set) + " nothing was set";
  if (compared.only_one > 0) {
    text += ", " + io::counted(compared.only_one, "id", "ids") + " in one of both only";
  }
  text += '\n' + line_of("deviation     ", figures.deviation_m, " m") +
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

// Of what was set other columns are chosen by another option.
Error in_words_of_set(Error error) {
  constexpr std::string_view kColumns = "--columns";
  constexpr std::string_view kSetColumns = "--set-columns";
  for (std::size_t at = error.message.find(kColumns); at != std::string::npos;
       at = error.message.find(kColumns, at + kSetColumns.size())) {
    error.message.replace(at, kColumns.size(), kSetColumns);
  }
  return error;
}

void write_extreme(io::JsonWriter& json, const char* name, const Extreme& extreme) {
  json.begin_object(name);
  json.member("greatest", extreme.greatest).member("usual", extreme.usual).end();
}

std::string json_of(const Compared& compared) {
  const TrackingFigures& figures = compared.figures;
  std::string text;
  {
    io::JsonWriter json(text, io::JsonLayout::kLines);
    json.begin_object(io::JsonLayout::kLines);
    json.member("version", version()).member("command", "fleet");
    json.member("bees", std::uint64_t{compared.bees});
    json.member("only_one", std::uint64_t{compared.only_one});
    json.member("fixes", figures.fixes).member("not_set", figures.not_set);
    write_extreme(json, "deviation_m", figures.deviation_m);
    write_extreme(json, "rate_mps", figures.rate_mps);
    write_extreme(json, "acceleration_mps2", figures.acceleration_mps2);
    json.member("lag_s", figures.lag_s);
    write_extreme(json, "without_lag_m", figures.without_lag_m);
    json.begin_object("plan").member("sensing_error_m", up(figures.deviation_m.greatest));
    json.member("deviation_mps", 0.0);
    json.member("correction_mps", up(figures.rate_mps.greatest)).end();
    json.end();
  }
  return text + '\n';
}

}  // namespace

Result<ExitCode> run_fleet(const FleetRequest& request) {
  io::RecordingOptions load = request.moving.load;
  load.one_of_several = true;
  const auto flown = io::load_recording(request.moving.inputs, load);
  if (!flown) return flown.error();
  if (!request.set_columns.empty()) load.columns = request.set_columns;
  const auto set = io::load_recording({request.set}, load);
  if (!set) return in_words_of_set(set.error());
  const analysis::MaxGap max_gap = analysis::max_gap_of(*set, request.max_gap_s);
  const auto compared = compare(*flown, *set, max_gap.seconds);
  if (!compared) return compared.error();
  const ExitCode written = print(request.moving.json ? json_of(*compared) : text_of(*compared));
  if (written != ExitCode::kFine || request.moving.quiet) return written;
  MovingRequest of_set = request.moving;
  of_set.inputs = {request.set};
  say(input_summary(*flown, request.moving) + input_summary(*set, of_set));
  return written;
}

}  // namespace beespace::cli
