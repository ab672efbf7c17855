#include "cli/detect/json_facts.hpp"

#include "analysis/text/unit_notes.hpp"
#include "cli/console/error_json.hpp"
#include "cli/output/json_units.hpp"
#include "io/bytes/byte_source.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace beespace::cli {
namespace {

std::string_view name_of(io::Frame frame) {
  return frame == io::Frame::kWgs84 ? "wgs84" : "metres";
}

void write_skipped(io::JsonWriter& json, const std::vector<Error>& skipped) {
  if (skipped.empty()) return;
  json.begin_array("first_skipped", io::JsonLayout::kLines);
  for (const Error& error : skipped) write_error(json, error);
  json.end();
}

}  // namespace

void write_repeated(io::JsonWriter& json, const io::RepeatedIds& repeated) {
  json.member("repeated_ids", repeated.count);
  if (repeated.count == 0) return;
  json.begin_object("first_repeated").member("id", repeated.id);
  json.member("records", std::array{repeated.first_row, repeated.second_row});
  json.end();
}

void write_input(io::JsonWriter& json, const InputFacts& facts) {
  const io::LoadedPoints& loaded = facts.loaded;
  const std::string_view datum = analysis::datum_text(loaded.heights);
  json.begin_object(io::JsonLayout::kLines).member("file", io::source_name(facts.path));
  json.member("format", loaded.format_description).member("frame", name_of(loaded.frame));
  json.member("reason", loaded.frame_reason);
  write_units(json.key("units"), loaded.units);
  json.member("heights", io::known_if(!datum.empty(), datum));
  json.member("points", facts.points).member("skipped", loaded.skipped_count);
  write_skipped(json, loaded.skipped);
  if (facts.repeated != nullptr) write_repeated(json, *facts.repeated);
  json.member("notes", loaded.notes);
  json.end();
}

void write_search(io::JsonWriter& json, const DetectRequest& request, io::Unit height_unit) {
  json.member("threshold_m", request.search.threshold_m);
  json.member("vertical_m", request.search.vertical_m);
  write_vertical(json.key("vertical"), request.vertical, height_unit);
  json.member("inclusive", request.search.inclusive);
}

void write_timings(io::JsonWriter& json, const Timings& timings) {
  json.begin_object("timings").member("read_s", timings.read_s);
  json.member("search_s", timings.search_s).end();
}

}  // namespace beespace::cli
