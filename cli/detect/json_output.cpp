#include "cli/console/error_json.hpp"
#include "cli/console/summary_line.hpp"
#include "cli/detect/answer_output.hpp"
#include "cli/detect/json_cell.hpp"
#include "cli/output/block_writer.hpp"
#include "cli/output/json_units.hpp"
#include "io/bytes/number_text.hpp"
#include "io/json/json_text.hpp"

#include <beespace/version.hpp>

namespace beespace::cli {
namespace {

std::string_view name_of(io::Frame frame) {
  return frame == io::Frame::kWgs84 ? "wgs84" : "metres";
}

std::string source_of(const std::string& path) {
  return path == "-" ? "<stdin>" : path;
}

void append_list(std::string& out, const std::vector<std::string>& texts) {
  out += '[';
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (i > 0) out += ", ";
    io::append_json_string(out, texts[i]);
  }
  out += ']';
}

void append_skipped(std::string& out, const std::vector<Error>& skipped) {
  if (skipped.empty()) return;
  out += ",\n    \"first_skipped\": [";
  for (std::size_t i = 0; i < skipped.size(); ++i) {
    out += i > 0 ? ",\n      {" : "\n      {";
    append_error_members(out, skipped[i]);
    out += '}';
  }
  out += "\n    ]";
}

void append_input(std::string& out, const char* key, const io::LoadedPoints& loaded,
                  const std::string& path, const io::RepeatedIds& repeated) {
  out += std::string("  \"") + key + "\": {\n    \"file\": " + io::json_string(source_of(path));
  out += ",\n    \"format\": " + io::json_string(loaded.format_description);
  out += ",\n    \"frame\": " + io::json_string(name_of(loaded.frame));
  out += ",\n    \"reason\": " + io::json_string(loaded.frame_reason);
  out += ",\n    \"units\": " + json_units(loaded.units);
  const std::string_view datum = datum_text(loaded.heights);
  out += ",\n    \"heights\": " + (datum.empty() ? "null" : io::json_string(datum));
  out += ",\n    \"points\": " + std::to_string(loaded.points.size());
  out += ",\n    \"skipped\": " + std::to_string(loaded.skipped_count);
  append_skipped(out, loaded.skipped);
  out += ",\n    \"repeated_ids\": " + std::to_string(repeated.count);
  if (repeated.count > 0) {
    out += ",\n    \"first_repeated\": {\"id\": " + io::json_string(repeated.id) +
           ", \"records\": [" + std::to_string(repeated.first_row) + ", " +
           std::to_string(repeated.second_row) + "]}";
  }
  out += ",\n    \"notes\": ";
  append_list(out, loaded.notes);
  out += "\n  },\n";
}

void append_pair(std::string& out, const Pair& pair, const Inputs& inputs,
                 const analysis::ShownIds& ours, const analysis::ShownIds& theirs) {
  out += "{\"first\": ";
  ours.append_json(out, pair.first);
  out += ", \"second\": ";
  theirs.append_json(out, pair.second);
  out += ", \"distance_m\": ";
  io::append_exact(out,
                   distance(inputs.ours.points[pair.first], inputs.theirs().points[pair.second]));
  out += '}';
}

void append_closest(std::string& out, const Answer& answer) {
  const Inputs& inputs = answer.inputs;
  const auto& closest = answer.detection.closest;
  out += "  \"closest_pair\": ";
  if (!closest) {
    out += "null,\n";
    return;
  }
  const PairTable table{{{closest->first, closest->second}}};
  const AnswerIds ids(inputs, Table{table}, Form::kJson);
  append_pair(out, table.pairs.front(), inputs, ids.ours(), ids.theirs());
  out += ",\n";
}

void write_rows(const BeeTable& table, const Answer& answer, BlockWriter& out) {
  const bool bare = table.columns.empty();
  const std::string_view separator = bare ? ", " : ",\n    ";
  if (!bare) out.text += "\n    ";
  bool first = true;
  for (const PointId bee : table.bees) {
    if (!first) out.text += separator;
    first = false;
    if (!bare) out.text += "{\"id\": ";
    answer.ids.ours().append_json(out.text, bee);
    append_json_members(out.text, table.columns, bee, answer.ids.theirs());
    if (!bare) out.text += '}';
    out.pass_on();
  }
}

void write_rows(const PairTable& table, const Answer& answer, BlockWriter& out) {
  bool first = true;
  for (const Pair& pair : table.pairs) {
    out.text += first ? "\n    " : ",\n    ";
    first = false;
    append_pair(out.text, pair, answer.inputs, answer.ids.ours(), answer.ids.theirs());
    out.pass_on();
  }
}

void write_rows(const GroupTable& table, const Answer& answer, BlockWriter& out) {
  for (std::size_t i = 0; i < table.groups.size(); ++i) {
    out.text += i == 0 ? "\n    {\"group\": " : ",\n    {\"group\": ";
    io::append_exact(out.text, std::uint64_t{i});
    out.text += ", \"size\": ";
    io::append_exact(out.text, std::uint64_t{table.groups[i].size()});
    out.text += ", \"members\": ";
    append_json_ids(out.text, table.groups[i], answer.ids.ours());
    out.text += '}';
    out.pass_on();
  }
}

// How many rows there are, where that is not a number said before.
void append_row_count(std::string& out, const Table& table) {
  if (const auto* pairs = std::get_if<PairTable>(&table.rows)) {
    out += "  \"pair_count\": " + std::to_string(pairs->pairs.size()) + ",\n";
  }
  if (const auto* groups = std::get_if<GroupTable>(&table.rows)) {
    out += "  \"group_count\": " + std::to_string(groups->groups.size()) + ",\n";
  }
}

void write_table(const Answer& answer, BlockWriter& out) {
  append_row_count(out.text, answer.detection.table);
  out.text += std::string("  \"") + answer.request.report->key + "\": [";
  std::visit([&](const auto& rows) { write_rows(rows, answer, out); }, answer.detection.table.rows);
  out.text += "]";
}

}  // namespace

void write_json(const Answer& answer, io::AtomicOutput& output) {
  const DetectRequest& request = answer.request;
  const Detection& detection = answer.detection;
  BlockWriter out(output);
  out.text += "{\n  \"version\": " + io::json_string(version());
  out.text += ",\n  \"report\": " + io::json_string(request.report->name) + ",\n";
  append_input(out.text, "input", answer.inputs.ours, request.input, answer.inputs.our_repeated);
  if (request.others) {
    append_input(out.text, "others", *answer.inputs.others, *request.others,
                 answer.inputs.their_repeated);
  }
  out.text += "  \"threshold_m\": " + io::exact(request.search.threshold_m);
  const auto& vertical = request.search.vertical_m;
  out.text += ",\n  \"vertical_m\": " + (vertical ? io::exact(*vertical) : std::string("null"));
  out.text += ",\n  \"vertical\": " + json_vertical(request.vertical, answer.inputs.height_unit());
  out.text += ",\n  \"inclusive\": ";
  out.text += request.search.inclusive ? "true" : "false";
  out.text += ",\n  \"at_risk_count\": " + std::to_string(detection.at_risk.size());
  out.text += ",\n  \"share\": " + io::exact(detection.share(answer.inputs.ours)) + ",\n";
  append_closest(out.text, answer);
  const bool has_rows = *request.report->key != '\0';
  out.text += "  \"timings\": {\"read_s\": " + io::exact(detection.timings.read_s);
  out.text += ", \"search_s\": " + io::exact(detection.timings.search_s) + '}';
  if (has_rows) {
    out.text += ",\n";
    write_table(answer, out);
  }
  out.text += "\n}\n";
}

}  // namespace beespace::cli
