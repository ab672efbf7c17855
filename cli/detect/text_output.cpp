#include "cli/detect/answer_output.hpp"
#include "cli/output/block_writer.hpp"
#include "io/bytes/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>

namespace beespace::cli {
namespace {

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

void append_ids(std::string& out, std::span<const PointId> bees, const analysis::ShownIds& ids) {
  for (const PointId bee : bees) {
    out += '\t';
    ids.append(out, bee);
  }
}

void append_cell(std::string& out, const Cell& cell, const analysis::ShownIds& ids) {
  if (const auto* bees = std::get_if<std::span<const PointId>>(&cell)) {
    append_ids(out, *bees, ids);
    return;
  }
  out += '\t';
  if (const auto* number = std::get_if<std::uint64_t>(&cell)) io::append_exact(out, *number);
  if (const auto* bee = std::get_if<BeeCell>(&cell); bee && bee->id != Nearest::kNone) {
    ids.append(out, bee->id);
  }
  if (const auto* far = std::get_if<DistanceCell>(&cell); far && std::isfinite(far->distance_m)) {
    io::append_exact(out, far->distance_m);
  }
}

void write_rows(const BeeTable& table, const Answer& answer, io::AtomicOutput& output) {
  const analysis::ShownIds& ids = answer.ids.ours();
  if (table.columns.empty() && ids.are_point_numbers()) return write_numbers(table.bees, output);
  BlockWriter out(output);
  // A plain list of ids needs no header.
  if (!table.columns.empty()) {
    out.text += "id";
    for (const Column& column : table.columns) (out.text += '\t') += column.name;
    out.text += '\n';
  }
  for (const PointId bee : table.bees) {
    ids.append(out.text, bee);
    for (const Column& column : table.columns) {
      append_cell(out.text, column.cell(bee), answer.ids.theirs());
    }
    out.text += '\n';
    out.pass_on();
  }
}

void write_rows(const PairTable& table, const Answer& answer, io::AtomicOutput& output) {
  const Inputs& inputs = answer.inputs;
  BlockWriter out(output);
  out.text += "first\tsecond\tdistance_m\n";
  for (const Pair& pair : table.pairs) {
    answer.ids.ours().append(out.text, pair.first);
    out.text += '\t';
    answer.ids.theirs().append(out.text, pair.second);
    out.text += '\t';
    io::append_exact(out.text,
                     distance(inputs.ours.points[pair.first], inputs.theirs().points[pair.second]));
    out.text += '\n';
    out.pass_on();
  }
}

void write_rows(const GroupTable& table, const Answer& answer, io::AtomicOutput& output) {
  BlockWriter out(output);
  out.text += "group\tsize\tmembers\n";
  for (std::size_t i = 0; i < table.groups.size(); ++i) {
    io::append_exact(out.text, std::uint64_t{i});
    out.text += '\t';
    io::append_exact(out.text, std::uint64_t{table.groups[i].size()});
    append_ids(out.text, table.groups[i], answer.ids.ours());
    out.text += '\n';
    out.pass_on();
  }
}

}  // namespace

void write_text(const Answer& answer, io::AtomicOutput& output) {
  std::visit([&](const auto& rows) { write_rows(rows, answer, output); },
             answer.detection.table.rows);
}

}  // namespace beespace::cli
