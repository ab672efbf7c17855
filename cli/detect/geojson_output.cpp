#include "cli/detect/answer_output.hpp"
#include "cli/detect/json_cell.hpp"
#include "cli/output/block_writer.hpp"
#include "io/json/geojson_geometry.hpp"

#include <algorithm>
#include <cstddef>

namespace beespace::cli {
namespace {

// Where some points are, by their number.
class Positions {
 public:
  Positions(const io::LoadedPoints& loaded, std::vector<PointId> points)
      : points_(std::move(points)) {
    std::sort(points_.begin(), points_.end());
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
    positions_.reserve(points_.size());
    io::for_each_record(loaded, points_, [this](const io::Record& record) {
      positions_.push_back(record.geographic);
    });
  }

  [[nodiscard]] const GeographicPosition& of(PointId point) const {
    const auto place = std::lower_bound(points_.begin(), points_.end(), point);
    return positions_[static_cast<std::size_t>(place - points_.begin())];
  }

 private:
  std::vector<PointId> points_;
  std::vector<GeographicPosition> positions_;
};

void write_geojson_rows(const BeeTable& table, const Answer& answer, BlockWriter& out,
                        io::JsonWriter& json) {
  io::for_each_record(answer.inputs.ours, table.bees, [&](const io::Record& record) {
    io::write_geojson_feature(
        json, io::JsonLayout::kLine, [&] { io::write_geojson_point(json, record.geographic); },
        [&] {
          answer.ids.ours().write(json.key("id"), record.point);
          write_cells(json, table.columns, record.point, answer.ids.theirs());
        });
    out.pass_on();
  });
}

void write_geojson_rows(const PairTable& table, const Answer& answer, BlockWriter& out,
                        io::JsonWriter& json) {
  const Inputs& inputs = answer.inputs;
  std::vector<PointId> firsts;
  std::vector<PointId> seconds;
  for (const Pair& pair : table.pairs) {
    firsts.push_back(pair.first);
    seconds.push_back(pair.second);
  }
  const Positions ours(inputs.ours, std::move(firsts));
  const Positions theirs(inputs.theirs(), std::move(seconds));
  for (const Pair& pair : table.pairs) {
    io::write_geojson_feature(
        json, io::JsonLayout::kLine,
        [&] { io::write_geojson_line(json, ours.of(pair.first), theirs.of(pair.second)); },
        [&] { write_pair(json, pair, inputs, answer.ids); });
    out.pass_on();
  }
}

void write_geojson_rows(const GroupTable& table, const Answer& answer, BlockWriter& out,
                        io::JsonWriter& json) {
  write_geojson_rows(table.members, answer, out, json);
}

}  // namespace

void write_geojson(const Answer& answer, io::AtomicOutput& output) {
  BlockWriter out(output);
  io::JsonWriter json(out.text);
  json.begin_object().member("type", "FeatureCollection");
  json.begin_array("features", io::JsonLayout::kFlush);
  std::visit([&](const auto& rows) { write_geojson_rows(rows, answer, out, json); },
             answer.detection.table.rows);
  json.end().end();
  out.text += '\n';
}

}  // namespace beespace::cli
