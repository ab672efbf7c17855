#include "cli/detect/answer_output.hpp"
#include "cli/output/block_writer.hpp"
#include "io/table/table_writer.hpp"

#include <algorithm>

namespace beespace::cli {
namespace {

// Arrays have no header of their own.
std::string_view header_of(const io::LoadedPoints& loaded) {
  if (loaded.format_description.starts_with("text")) return io::header_line(loaded);
  return loaded.frame == io::Frame::kWgs84 ? "longitude,latitude,height" : "x,y,z";
}

std::string listed(std::span<const PointId> bees, const analysis::ShownIds& ids, char delimiter) {
  const char between = delimiter == ';' ? ',' : ';';
  std::string text;
  for (const PointId bee : bees) {
    if (!text.empty()) text += between;
    ids.append(text, bee);
  }
  return text;
}

void write_csv_cell(io::TableWriter& table, const Cell& cell, const analysis::ShownIds& ids) {
  if (const auto* number = std::get_if<std::uint64_t>(&cell)) {
    table.field(*number);
  } else if (const auto* far = std::get_if<DistanceCell>(&cell)) {
    table.field(far->distance_m);
  } else if (const auto* bee = std::get_if<BeeCell>(&cell)) {
    table.field(bee->id == Nearest::kNone ? std::string() : ids.text(bee->id));
  } else {
    table.field(listed(std::get<std::span<const PointId>>(cell), ids, table.delimiter()));
  }
}

void write_csv_rows(const BeeTable& rows, const Answer& answer, io::AtomicOutput& output) {
  const io::LoadedPoints& ours = answer.inputs.ours;
  // Without an id column the row is the id, which the record itself does not say.
  const bool with_rows = !io::has_id_column(ours) &&
                         std::any_of(rows.columns.begin(), rows.columns.end(),
                                     [](const Column& column) { return column.names_bees; });
  BlockWriter out(output);
  io::TableWriter table(out.text, io::delimiter(ours));
  const std::string_view header = header_of(ours);
  if (!header.empty()) {
    table.next() += header;
    if (with_rows) table.field("row");
    for (const Column& column : rows.columns) table.field(column.name);
    table.end_row();
  }
  io::for_each_record(ours, rows.bees, [&](const io::Record& record) {
    table.next() += record.text;
    if (with_rows) table.field(record.row);
    for (const Column& column : rows.columns) {
      write_csv_cell(table, column.cell(record.point), answer.ids.theirs());
    }
    table.end_row();
    out.pass_on();
  });
}

void write_csv_rows(const PairTable& rows, const Answer& answer, io::AtomicOutput& output) {
  const Inputs& inputs = answer.inputs;
  BlockWriter out(output);
  io::TableWriter table(out.text, io::delimiter(inputs.ours));
  table.header(pair_header(rows.fields)).end_row();
  std::size_t row = 0;
  for (const Pair& pair : rows.pairs) {
    table.field(answer.ids.ours().text(pair.first)).field(answer.ids.theirs().text(pair.second));
    table.field(distance(inputs.ours.points[pair.first], inputs.theirs().points[pair.second]));
    write_apart(table, rows.apart_of(row++), rows.fields);
    table.end_row();
    out.pass_on();
  }
}

void write_csv_rows(const GroupTable& rows, const Answer& answer, io::AtomicOutput& output) {
  write_csv_rows(rows.members, answer, output);
}

}  // namespace

void write_csv(const Answer& answer, io::AtomicOutput& output) {
  std::visit([&](const auto& rows) { write_csv_rows(rows, answer, output); },
             answer.detection.table.rows);
}

}  // namespace beespace::cli
