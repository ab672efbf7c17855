#include "cli/summary.hpp"

#include "cli/number_text.hpp"
#include "cli/shown_ids.hpp"
#include "cli/terminal.hpp"

#include <algorithm>
#include <string_view>

namespace beespace::cli {
namespace {

void append_line(std::string& out, std::string_view label, std::string_view text) {
  constexpr std::size_t kLabelWidth = 11;
  out += "  ";
  out += label;
  out.append(kLabelWidth - std::min(kLabelWidth, label.size()), ' ');
  out += text;
  out += '\n';
}

std::string input_line(const io::LoadedPoints& loaded, const DetectRequest& request) {
  const std::string name = request.input == "-" ? "standard input" : request.input;
  return printable(name) + " (" + byte_count(loaded.bytes) + ", " + loaded.format_description + ")";
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

std::string threshold_line(const SearchOptions& search) {
  return exact(search.threshold_m) + (search.inclusive ? " m or closer" : " m (closer than)");
}

std::string at_risk_line(const io::LoadedPoints& loaded, const Detection& detection) {
  if (detection.at_risk.empty()) return bold("nobody");
  const std::string text =
      grouped(detection.at_risk.size()) + " (" + percentage(detection.share(loaded)) + ")";
  return red(text);
}

std::string closest_line(const io::LoadedPoints& loaded, const ClosestPair& pair) {
  const std::vector<PointId> both = {pair.first, pair.second};
  const ShownIds ids(loaded, both);
  return printable(ids.text(pair.first)) + " and " + printable(ids.text(pair.second)) + ", " +
         length(pair.distance_m) + " apart";
}

std::string time_line(const io::LoadedPoints& loaded, const Timings& timings) {
  const double total = timings.read_s + timings.search_s + timings.write_s;
  std::string text = "read " + duration(timings.read_s) + ", search " + duration(timings.search_s) +
                     ", write " + duration(timings.write_s);
  if (total > 0.0) {
    const double rate = static_cast<double>(loaded.points.size()) / total;
    text += " (" + grouped(rate, 0) + " points/s)";
  }
  return text;
}

void append_skipped(std::string& out, const io::LoadedPoints& loaded) {
  append_line(
      out, "skipped",
      grouped(loaded.skipped_count) + (loaded.skipped_count == 1 ? " bad record" : " bad records"));
  for (const Error& error : loaded.skipped) append_line(out, "", printable(to_string(error)));
  if (loaded.skipped_count > loaded.skipped.size()) {
    append_line(out, "", "and " + grouped(loaded.skipped_count - loaded.skipped.size()) + " more");
  }
}

}  // namespace

std::string summary(const io::LoadedPoints& loaded, const Detection& detection,
                    const DetectRequest& request) {
  std::string out;
  append_line(out, "input", input_line(loaded, request));
  append_line(out, "frame", frame_line(loaded));
  for (const std::string& note : loaded.notes) append_line(out, "note", printable(note));
  if (loaded.skipped_count > 0) append_skipped(out, loaded);
  append_line(out, "points", grouped(loaded.points.size()));
  append_line(out, "threshold", threshold_line(request.search));
  append_line(out, "at risk", at_risk_line(loaded, detection));
  if (detection.closest) append_line(out, "closest", closest_line(loaded, *detection.closest));
  append_line(out, "time", time_line(loaded, detection.timings));
  return out;
}

}  // namespace beespace::cli
