#include "cli/detect/answer_output.hpp"
#include "cli/output/block_writer.hpp"
#include "io/bytes/number_text.hpp"
#include "io/table/csv_field.hpp"

#include <algorithm>
#include <cmath>

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

std::string text_of(const Cell& cell, const analysis::ShownIds& ids, char delimiter) {
  if (const auto* number = std::get_if<std::uint64_t>(&cell)) return std::to_string(*number);
  if (const auto* far = std::get_if<DistanceCell>(&cell)) {
    return std::isfinite(far->distance_m) ? io::exact(far->distance_m) : std::string();
  }
  if (const auto* bee = std::get_if<BeeCell>(&cell)) {
    return bee->id == Nearest::kNone ? std::string() : ids.text(bee->id);
  }
  return listed(std::get<std::span<const PointId>>(cell), ids, delimiter);
}

void write_rows(const BeeTable& table, const Answer& answer, io::AtomicOutput& output) {
  const io::LoadedPoints& ours = answer.inputs.ours;
  const char delimiter = io::delimiter(ours);
  // Without an id column the row is the id, which the record itself does not say.
  const bool with_rows = !io::has_id_column(ours) &&
                         std::any_of(table.columns.begin(), table.columns.end(),
                                     [](const Column& column) { return column.names_bees; });
  BlockWriter out(output);
  const std::string_view header = header_of(ours);
  if (!header.empty()) {
    out.text += header;
    if (with_rows) (out.text += delimiter) += "row";
    for (const Column& column : table.columns) (out.text += delimiter) += column.name;
    out.text += '\n';
  }
  io::for_each_record(ours, table.bees, [&](const io::Record& record) {
    out.text += record.text;
    if (with_rows) io::append_exact(out.text += delimiter, record.row);
    for (const Column& column : table.columns) {
      out.text += delimiter;
      io::append_csv_field(
          out.text, text_of(column.cell(record.point), answer.ids.theirs(), delimiter), delimiter);
    }
    out.text += '\n';
    out.pass_on();
  });
}

void write_rows(const PairTable& table, const Answer& answer, io::AtomicOutput& output) {
  const Inputs& inputs = answer.inputs;
  const char delimiter = io::delimiter(inputs.ours);
  BlockWriter out(output);
  out.text += "first";
  (out.text += delimiter) += "second";
  (out.text += delimiter) += "distance_m\n";
  for (const Pair& pair : table.pairs) {
    io::append_csv_field(out.text, answer.ids.ours().text(pair.first), delimiter);
    out.text += delimiter;
    io::append_csv_field(out.text, answer.ids.theirs().text(pair.second), delimiter);
    out.text += delimiter;
    io::append_exact(out.text,
                     distance(inputs.ours.points[pair.first], inputs.theirs().points[pair.second]));
    out.text += '\n';
    out.pass_on();
  }
}

void write_rows(const GroupTable& table, const Answer& answer, io::AtomicOutput& output) {
  write_rows(table.members, answer, output);
}

}  // namespace

void write_csv(const Answer& answer, io::AtomicOutput& output) {
  std::visit([&](const auto& rows) { write_rows(rows, answer, output); },
             answer.detection.table.rows);
}

}  // namespace beespace::cli
