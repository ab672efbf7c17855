#include "cli/detect/answer_output.hpp"
#include "cli/detect/json_cell.hpp"
#include "cli/output/block_writer.hpp"
#include "io/bytes/number_text.hpp"
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

void begin_feature(std::string& out, bool& first) {
  out += first ? "\n" : ",\n";
  first = false;
  out += R"({"type": "Feature", "geometry": )";
}

void write_rows(const BeeTable& table, const Answer& answer, BlockWriter& out) {
  bool first = true;
  io::for_each_record(answer.inputs.ours, table.bees, [&](const io::Record& record) {
    begin_feature(out.text, first);
    io::append_geojson_point(out.text, record.geographic);
    out.text += R"(, "properties": {"id": )";
    answer.ids.ours().append_json(out.text, record.point);
    append_json_members(out.text, table.columns, record.point, answer.ids.theirs());
    out.text += "}}";
    out.pass_on();
  });
}

void write_rows(const PairTable& table, const Answer& answer, BlockWriter& out) {
  const Inputs& inputs = answer.inputs;
  std::vector<PointId> firsts;
  std::vector<PointId> seconds;
  for (const Pair& pair : table.pairs) {
    firsts.push_back(pair.first);
    seconds.push_back(pair.second);
  }
  const Positions ours(inputs.ours, std::move(firsts));
  const Positions theirs(inputs.theirs(), std::move(seconds));
  bool first = true;
  for (const Pair& pair : table.pairs) {
    begin_feature(out.text, first);
    io::append_geojson_line(out.text, ours.of(pair.first), theirs.of(pair.second));
    out.text += R"(, "properties": {"first": )";
    answer.ids.ours().append_json(out.text, pair.first);
    out.text += ", \"second\": ";
    answer.ids.theirs().append_json(out.text, pair.second);
    out.text += ", \"distance_m\": ";
    io::append_exact(out.text,
                     distance(inputs.ours.points[pair.first], inputs.theirs().points[pair.second]));
    out.text += "}}";
    out.pass_on();
  }
}

void write_rows(const GroupTable& table, const Answer& answer, BlockWriter& out) {
  write_rows(table.members, answer, out);
}

}  // namespace

void write_geojson(const Answer& answer, io::AtomicOutput& output) {
  BlockWriter out(output);
  out.text += "{\"type\": \"FeatureCollection\", \"features\": [";
  std::visit([&](const auto& rows) { write_rows(rows, answer, out); }, answer.detection.table.rows);
  out.text += "\n]}\n";
}

}  // namespace beespace::cli
