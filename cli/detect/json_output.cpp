#include "cli/detect/answer_output.hpp"
#include "cli/detect/json_cell.hpp"
#include "cli/detect/json_facts.hpp"
#include "cli/output/block_writer.hpp"

#include <beespace/version.hpp>

namespace beespace::cli {
namespace {

void write_closest(io::JsonWriter& json, const Answer& answer) {
  const auto& closest = answer.detection.closest;
  if (!closest) return json.key("closest_pair").null();
  const PairTable table{{{closest->first, closest->second}}};
  const AnswerIds ids(answer.inputs, Table{table}, Form::kJson);
  json.begin_object("closest_pair");
  write_pair(json, table.pairs.front(), answer.inputs, ids);
  json.end();
}

void write_json_rows(const BeeTable& table, const Answer& answer, BlockWriter& out,
                     io::JsonWriter& json) {
  const bool bare = table.columns.empty();
  json.begin_array(bare ? io::JsonLayout::kLine : io::JsonLayout::kRows);
  if (!bare) json.new_line();
  for (const PointId bee : table.bees) {
    if (bare) {
      answer.ids.ours().write(json, bee);
    } else {
      json.begin_object();
      answer.ids.ours().write(json.key("id"), bee);
      write_cells(json, table.columns, bee, answer.ids.theirs());
      json.end();
    }
    out.pass_on();
  }
  json.end();
}

void write_json_rows(const PairTable& table, const Answer& answer, BlockWriter& out,
                     io::JsonWriter& json) {
  json.begin_array(io::JsonLayout::kRows);
  std::size_t row = 0;
  for (const Pair& pair : table.pairs) {
    json.begin_object();
    write_pair(json, pair, answer.inputs, answer.ids);
    write_apart(json, table.apart_of(row++), table.fields);
    json.end();
    out.pass_on();
  }
  json.end();
}

void write_json_rows(const GroupTable& table, const Answer& answer, BlockWriter& out,
                     io::JsonWriter& json) {
  json.begin_array(io::JsonLayout::kRows);
  for (std::size_t i = 0; i < table.groups.size(); ++i) {
    json.begin_object().member("group", i).member("size", table.groups[i].size());
    write_ids(json.key("members"), table.groups[i], answer.ids.ours());
    json.end();
    out.pass_on();
  }
  json.end();
}

// How many rows there are, where that is not a number said before.
void write_row_count(io::JsonWriter& json, const Table& table) {
  if (const auto* pairs = std::get_if<PairTable>(&table.rows)) {
    json.member("pair_count", pairs->pairs.size());
  }
  if (const auto* groups = std::get_if<GroupTable>(&table.rows)) {
    json.member("group_count", groups->groups.size());
  }
}

void write_table(const Answer& answer, BlockWriter& out, io::JsonWriter& json) {
  write_row_count(json, answer.detection.table);
  json.key(answer.request.report->key);
  std::visit([&](const auto& rows) { write_json_rows(rows, answer, out, json); },
             answer.detection.table.rows);
}

}  // namespace

void write_pair(io::JsonWriter& json, const Pair& pair, const Inputs& inputs,
                const AnswerIds& ids) {
  ids.ours().write(json.key("first"), pair.first);
  ids.theirs().write(json.key("second"), pair.second);
  json.member("distance_m",
              distance(inputs.ours.points[pair.first], inputs.theirs().points[pair.second]));
}

void write_json(const Answer& answer, io::AtomicOutput& output) {
  const DetectRequest& request = answer.request;
  const Detection& detection = answer.detection;
  BlockWriter out(output);
  io::JsonWriter json(out.text);
  json.begin_object(io::JsonLayout::kLines);
  json.member("version", version()).member("report", request.report->name);
  const Inputs& inputs = answer.inputs;
  write_input(json.key("input"),
              {request.input(), inputs.ours, inputs.ours.points.size(), &inputs.our_repeated});
  if (request.others) {
    write_input(json.key("others"), {*request.others, *inputs.others, inputs.others->points.size(),
                                     &inputs.their_repeated});
  }
  write_search(json, request, inputs.height_unit());
  json.member("at_risk_count", detection.at_risk.size());
  json.member("share", detection.share(inputs.ours));
  write_closest(json, answer);
  write_timings(json, detection.timings);
  if (*request.report->key != '\0') write_table(answer, out, json);
  json.end();
  out.text += '\n';
}

}  // namespace beespace::cli
