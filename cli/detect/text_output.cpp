#include "cli/detect/answer_output.hpp"
#include "cli/output/block_writer.hpp"
#include "io/table/table_writer.hpp"

#include <array>
#include <charconv>
#include <cstddef>

namespace beespace::cli {
namespace {

constexpr char kTab = '\t';

void write_numbers(const std::vector<PointId>& numbers, io::AtomicOutput& output) {
  constexpr std::size_t kLongestLine = 11;
  std::array<char, std::size_t{1} << 15> block;
  char* at = block.data();
  char* const end = block.data() + block.size();
  for (const PointId number : numbers) {
    if (static_cast<std::size_t>(end - at) < kLongestLine) {
      output.write({block.data(), static_cast<std::size_t>(at - block.data())});
      at = block.data();
    }
    at = std::to_chars(at, end, number).ptr;
    *at++ = '\n';
  }
  output.write({block.data(), static_cast<std::size_t>(at - block.data())});
}

void write_ids(io::TableWriter& table, std::span<const PointId> bees,
               const analysis::ShownIds& ids) {
  for (const PointId bee : bees) ids.append(table.next(), bee);
}

void write_text_cell(io::TableWriter& table, const Cell& cell, const analysis::ShownIds& ids) {
  if (const auto* bees = std::get_if<std::span<const PointId>>(&cell)) {
    write_ids(table, *bees, ids);
  } else if (const auto* number = std::get_if<std::uint64_t>(&cell)) {
    table.field(*number);
  } else if (const auto* far = std::get_if<DistanceCell>(&cell)) {
    table.field(far->distance_m);
  } else if (const PointId bee = std::get<BeeCell>(cell).id; bee != Nearest::kNone) {
    ids.append(table.next(), bee);
  } else {
    table.empty_field();
  }
}

void write_text_rows(const BeeTable& rows, const Answer& answer, io::AtomicOutput& output) {
  const analysis::ShownIds& ids = answer.ids.ours();
  if (rows.columns.empty() && ids.are_point_numbers()) return write_numbers(rows.bees, output);
  BlockWriter out(output);
  io::TableWriter table(out.text, kTab);
  // A plain list of ids needs no header.
  if (!rows.columns.empty()) {
    table.field("id");
    for (const Column& column : rows.columns) table.field(column.name);
    table.end_row();
  }
  for (const PointId bee : rows.bees) {
    ids.append(table.next(), bee);
    for (const Column& column : rows.columns) {
      write_text_cell(table, column.cell(bee), answer.ids.theirs());
    }
    table.end_row();
    out.pass_on();
  }
}

void write_text_rows(const PairTable& rows, const Answer& answer, io::AtomicOutput& output) {
  const Inputs& inputs = answer.inputs;
  BlockWriter out(output);
  io::TableWriter table(out.text, kTab);
  table.header(pair_header(rows.fields)).end_row();
  std::size_t row = 0;
  for (const Pair& pair : rows.pairs) {
    answer.ids.ours().append(table.next(), pair.first);
    answer.ids.theirs().append(table.next(), pair.second);
    table.field(distance(inputs.ours.points[pair.first], inputs.theirs().points[pair.second]));
    write_apart(table, rows.apart_of(row++), rows.fields);
    table.end_row();
    out.pass_on();
  }
}

void write_text_rows(const GroupTable& rows, const Answer& answer, io::AtomicOutput& output) {
  BlockWriter out(output);
  io::TableWriter table(out.text, kTab);
  table.header("group,size,members").end_row();
  for (std::size_t i = 0; i < rows.groups.size(); ++i) {
    table.field(i).field(rows.groups[i].size());
    write_ids(table, rows.groups[i], answer.ids.ours());
    table.end_row();
    out.pass_on();
  }
}

}  // namespace

void write_text(const Answer& answer, io::AtomicOutput& output) {
  std::visit([&](const auto& rows) { write_text_rows(rows, answer, output); },
             answer.detection.table.rows);
}

}  // namespace beespace::cli
