#include "cli/detect/json_cell.hpp"

namespace beespace::cli {
namespace {

void write_cell(io::JsonWriter& json, const Cell& cell, const analysis::ShownIds& ids) {
  if (const auto* number = std::get_if<std::uint64_t>(&cell)) {
    json.value(*number);
  } else if (const auto* bees = std::get_if<std::span<const PointId>>(&cell)) {
    write_ids(json, *bees, ids);
  } else if (const auto* far = std::get_if<DistanceCell>(&cell)) {
    json.value(far->distance_m);
  } else if (const PointId bee = std::get<BeeCell>(cell).id; bee != Nearest::kNone) {
    ids.write(json, bee);
  } else {
    json.null();
  }
}

}  // namespace

void write_cells(io::JsonWriter& json, const std::vector<Column>& columns, PointId bee,
                 const analysis::ShownIds& ids) {
  for (const Column& column : columns) {
    write_cell(json.key(column.name), column.cell(bee), ids);
  }
}

void write_ids(io::JsonWriter& json, std::span<const PointId> bees, const analysis::ShownIds& ids) {
  json.begin_array();
  for (const PointId bee : bees) ids.write(json, bee);
  json.end();
}

}  // namespace beespace::cli
