#include "cli/answer_output.hpp"
#include "cli/block_writer.hpp"
#include "cli/json_text.hpp"
#include "cli/number_text.hpp"

#include <beespace/version.hpp>

namespace beespace::cli {
namespace {

std::string_view name_of(io::Frame frame) {
  return frame == io::Frame::kWgs84 ? "wgs84" : "metres";
}

std::string source_of(const DetectRequest& request) {
  return request.input == "-" ? "<stdin>" : request.input;
}

void append_list(std::string& out, const std::vector<std::string>& texts) {
  out += '[';
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (i > 0) out += ", ";
    append_json_string(out, texts[i]);
  }
  out += ']';
}

void append_optional(std::string& out, std::string_view key,
                     const std::optional<std::uint64_t>& value) {
  out += ", \"";
  out += key;
  out += "\": " + (value ? std::to_string(*value) : std::string("null"));
}

// What an error says and where it lies, as the members of an object.
void append_members(std::string& out, const Error& error) {
  out += "\"code\": " + json_string(to_string(error.code));
  out += ", \"message\": " + json_string(error.message);
  out += ", \"file\": " +
         (error.place.source.empty() ? std::string("null") : json_string(error.place.source));
  append_optional(out, "line", error.place.line);
  append_optional(out, "column", error.place.column);
  append_optional(out, "record", error.place.record);
}

void append_skipped(std::string& out, const std::vector<Error>& skipped) {
  if (skipped.empty()) return;
  out += ",\n    \"first_skipped\": [";
  for (std::size_t i = 0; i < skipped.size(); ++i) {
    out += i > 0 ? ",\n      {" : "\n      {";
    append_members(out, skipped[i]);
    out += '}';
  }
  out += "\n    ]";
}

void append_input(std::string& out, const io::LoadedPoints& loaded, const DetectRequest& request) {
  out += "  \"input\": {\n    \"file\": " + json_string(source_of(request));
  out += ",\n    \"format\": " + json_string(loaded.format_description);
  out += ",\n    \"frame\": " + json_string(name_of(loaded.frame));
  out += ",\n    \"reason\": " + json_string(loaded.frame_reason);
  out += ",\n    \"points\": " + std::to_string(loaded.points.size());
  out += ",\n    \"skipped\": " + std::to_string(loaded.skipped_count);
  append_skipped(out, loaded.skipped);
  out += ",\n    \"notes\": ";
  append_list(out, loaded.notes);
  out += "\n  },\n";
}

void append_closest(std::string& out, const io::LoadedPoints& loaded, const Detection& detection) {
  out += "  \"closest_pair\": ";
  if (!detection.closest) {
    out += "null,\n";
    return;
  }
  const ClosestPair& pair = *detection.closest;
  const std::vector<PointId> both = {pair.first, pair.second};
  const ShownIds ids(loaded, both);
  out += "{\"first\": ";
  ids.append_json(out, pair.first);
  out += ", \"second\": ";
  ids.append_json(out, pair.second);
  out += ", \"distance_m\": " + exact(pair.distance_m) + "},\n";
}

void append_entry(std::string& out, const ShownIds& ids, const Detection& detection, PointId point,
                  bool nearest) {
  if (!nearest) {
    ids.append_json(out, point);
    return;
  }
  out += "{\"id\": ";
  ids.append_json(out, point);
  out += ", \"nearest\": ";
  ids.append_json(out, detection.nearest[point].id);
  out += ", \"distance_m\": ";
  append_exact(out, detection.nearest[point].distance_m);
  out += '}';
}

}  // namespace

void write_json(const io::LoadedPoints& loaded, const Detection& detection, const ShownIds& ids,
                const DetectRequest& request, io::AtomicOutput& output) {
  BlockWriter out(output);
  out.text += "{\n  \"version\": " + json_string(version()) + ",\n";
  append_input(out.text, loaded, request);
  out.text += "  \"threshold_m\": " + exact(request.search.threshold_m);
  out.text += ",\n  \"inclusive\": ";
  out.text += request.search.inclusive ? "true" : "false";
  out.text += ",\n  \"at_risk_count\": " + std::to_string(detection.at_risk.size());
  out.text += ",\n  \"share\": " + exact(detection.share(loaded)) + ",\n";
  append_closest(out.text, loaded, detection);
  out.text += "  \"timings\": {\"read_s\": " + exact(detection.timings.read_s);
  out.text += ", \"search_s\": " + exact(detection.timings.search_s) + "},\n";
  out.text += request.nearest ? "  \"at_risk\": [\n    " : "  \"at_risk\": [";
  const std::string_view separator = request.nearest ? ",\n    " : ", ";
  for (std::size_t i = 0; i < detection.at_risk.size(); ++i) {
    if (i > 0) out.text += separator;
    append_entry(out.text, ids, detection, detection.at_risk[i], request.nearest);
    out.pass_on();
  }
  out.text += "]\n}\n";
}

std::string error_as_json(const Error& error) {
  std::string out = "{\"error\": {";
  append_members(out, error);
  return out + "}}\n";
}

}  // namespace beespace::cli
