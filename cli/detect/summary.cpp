#include "cli/detect/summary.hpp"

#include "analysis/geometry/scale_doubt.hpp"
#include "analysis/snapshot/shown_ids.hpp"
#include "analysis/text/unit_notes.hpp"
#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <string_view>

namespace beespace::cli {
namespace {

std::string input_line(const io::LoadedPoints& loaded, const std::string& path) {
  const std::string name = path == "-" ? "standard input" : path;
  return printable(name) + " (" + io::byte_count(loaded.bytes) + ", " + loaded.format_description +
         ")";
}

// The reader notes what it did not find.
bool has_height(const io::LoadedPoints& loaded) {
  return std::none_of(loaded.notes.begin(), loaded.notes.end(),
                      [](const std::string& note) { return note.starts_with("no height column"); });
}

std::string frame_line(const io::LoadedPoints& loaded) {
  std::string frame = "metres";
  if (loaded.frame == io::Frame::kWgs84) {
    frame = "WGS84 longitude, latitude";
    if (has_height(loaded)) frame += ", height";
  }
  return frame + ": " + printable(loaded.frame_reason);
}

std::string closest_line(const Inputs& inputs, const ClosestPair& pair, double threshold_m) {
  const std::vector<PointId> first = {pair.first};
  const std::vector<PointId> second = {pair.second};
  const analysis::ShownIds ours(inputs.ours, first);
  const analysis::ShownIds theirs(inputs.theirs(), second);
  return printable(ours.text(pair.first)) + " and " + (inputs.others ? "their " : "") +
         printable(theirs.text(pair.second)) + ", " +
         io::length_below(threshold_m, pair.distance_m) + " apart";
}

std::string time_line(const Inputs& inputs, const Timings& timings) {
  const double total = timings.read_s + timings.search_s + timings.write_s;
  std::string text = "read " + io::duration(timings.read_s) + ", search " +
                     io::duration(timings.search_s) + ", write " + io::duration(timings.write_s);
  if (total > 0.0) {
    const std::size_t points =
        inputs.ours.points.size() + (inputs.others ? inputs.others->points.size() : 0);
    text += " (" + io::grouped(static_cast<double>(points) / total, 0) + " points/s)";
  }
  return text;
}

void append_skipped(std::string& out, const io::LoadedPoints& loaded) {
  append_summary_line(out, "skipped",
                      io::grouped(loaded.skipped_count) +
                          (loaded.skipped_count == 1 ? " bad record" : " bad records"));
  for (const Error& error : loaded.skipped)
    append_summary_line(out, "", printable(to_string(error)));
  if (loaded.skipped_count > loaded.skipped.size()) {
    append_summary_line(
        out, "", "and " + io::grouped(loaded.skipped_count - loaded.skipped.size()) + " more");
  }
}

}  // namespace

void append_input(std::string& out, std::string_view label, const InputFacts& facts) {
  const io::LoadedPoints& loaded = facts.loaded;
  append_summary_line(out, label, input_line(loaded, facts.path));
  append_summary_line(out, "frame", frame_line(loaded));
  append_units(out, loaded.units);
  const std::string_view datum = analysis::datum_text(loaded.heights);
  if (!datum.empty()) append_summary_line(out, "heights", datum);
  for (const std::string& note : loaded.notes) append_summary_line(out, "note", printable(note));
  if (loaded.skipped_count > 0) append_skipped(out, loaded);
  append_summary_line(out, "points", io::grouped(facts.points));
  if (facts.repeated != nullptr) append_repeated(out, *facts.repeated);
}

void append_repeated(std::string& out, const io::RepeatedIds& repeated) {
  if (repeated.count == 0) return;
  append_summary_line(out, "repeated", red(analysis::text_of(repeated)));
}

std::string at_risk_text(std::uint64_t at_risk, std::uint64_t points, std::uint64_t skipped) {
  if (at_risk == 0 && skipped > 0) {
    return bold("none of those that are known") + "; " + io::grouped(skipped) +
           (skipped == 1 ? " record was left out" : " records were left out");
  }
  const double share = static_cast<double>(at_risk) / static_cast<double>(points);
  if (at_risk == 0) return bold("none");
  return red(io::grouped(at_risk) + " (" + io::percentage(share) + ")");
}

void append_search(std::string& out, const DetectRequest& request, io::Unit height_unit) {
  append_summary_line(
      out, "threshold",
      separation_text(request.search.threshold_m, request.search.vertical_m,
                      request.search.inclusive, request.threshold, request.vertical) +
          usual_text(request.separation) + (!request.threshold ? kDefaultThresholdWords : ""));
  append_vertical(out, request.vertical, height_unit);
}

std::string summary(const Inputs& inputs, const Detection& detection,
                    const DetectRequest& request) {
  std::string out;
  append_input(out, "input",
               {request.input(), inputs.ours, inputs.ours.points.size(), &inputs.our_repeated});
  append_note(out, analysis::metres_note(inputs.ours.units, inputs.ours.frame, request.threshold));
  if (inputs.others) {
    append_input(
        out, "others",
        {*request.others, *inputs.others, inputs.others->points.size(), &inputs.their_repeated});
  }
  append_search(out, request, inputs.height_unit());
  append_summary_line(
      out, "at risk",
      at_risk_text(detection.at_risk.size(), inputs.ours.points.size(), inputs.skipped()));
  if (!detection.table.finding.empty()) {
    append_summary_line(out, request.report->label, detection.table.finding);
  }
  if (detection.closest) {
    const bool kept_apart = request.search.vertical_m && detection.at_risk.empty();
    append_summary_line(out, "closest",
                        closest_line(inputs, *detection.closest, request.search.threshold_m) +
                            (kept_apart ? " in a straight line, not too close" : ""));
  }
  append_summary_line(out, "time", time_line(inputs, detection.timings));
  return out;
}

}  // namespace beespace::cli
