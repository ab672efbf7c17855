#include "cli/detect/json_cell.hpp"

#include "io/bytes/number_text.hpp"

#include <cmath>

namespace beespace::cli {
namespace {

void append_cell(std::string& out, const Cell& cell, const analysis::ShownIds& ids) {
  if (const auto* number = std::get_if<std::uint64_t>(&cell)) {
    io::append_exact(out, *number);
  } else if (const auto* bees = std::get_if<std::span<const PointId>>(&cell)) {
    append_json_ids(out, *bees, ids);
  } else if (const auto* bee = std::get_if<BeeCell>(&cell); bee && bee->id != Nearest::kNone) {
    ids.append_json(out, bee->id);
  } else if (const auto* far = std::get_if<DistanceCell>(&cell);
             far && std::isfinite(far->distance_m)) {
    io::append_exact(out, far->distance_m);
  } else {
    out += "null";
  }
}

}  // namespace

void append_json_members(std::string& out, const std::vector<Column>& columns, PointId bee,
                         const analysis::ShownIds& ids) {
  for (const Column& column : columns) {
    out += ", \"";
    out += column.name;
    out += "\": ";
    append_cell(out, column.cell(bee), ids);
  }
}

void append_json_ids(std::string& out, std::span<const PointId> bees,
                     const analysis::ShownIds& ids) {
  out += '[';
  for (std::size_t i = 0; i < bees.size(); ++i) {
    if (i > 0) out += ", ";
    ids.append_json(out, bees[i]);
  }
  out += ']';
}

}  // namespace beespace::cli
