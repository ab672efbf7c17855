#include "io/points/loaded_points.hpp"
#include "io/points/plain_lines.hpp"
#include "io/points/record_reading.hpp"
#include "io/points/record_source.hpp"
#include "io/table/record_walk.hpp"

#include <array>
#include <cstddef>
#include <string>

namespace beespace::io {
namespace {

using Visit = std::function<void(const Record&)>;

// Of a record that was read without an error before, as it stands; `readable_end` as for
// read_piece().
Point point_of(std::string_view record, const char* readable_end, const TableLayout& layout) {
  Point point;
  const bool plain = has_plain_lines(layout) &&
                     readable_end - record.data() > static_cast<std::ptrdiff_t>(kPlainLineReach) &&
                     read_plain_line(record.data(), layout, point);
  if (!plain && read_record(record, layout, point)) return {};
  return point;
}

// Which numbers of a record are wanted.
struct Wanted {
  bool geographic;
  bool height;
};

void fill(Record& record, const Point& stated, const std::array<Unit, 3>& units,
          const Wanted& wanted) {
  record.height = stated.z;
  if (wanted.geographic) {
    record.geographic = {stated.x, stated.y, in_metric(stated.z, units[2])};
  }
}

void visit_table(const RecordSource& source, const std::vector<PointId>& ascending,
                 const Wanted& wanted, const Visit& visit) {
  const TableLayout& layout = *source.table;
  RecordWalk walk(source.text, layout.data_offset, layout);
  const char* const readable_end = source.text.data() + source.text.size();
  std::string id;
  for (const PointId point : ascending) {
    const std::uint64_t row = source.skipped.row_of(point);
    do {
      if (!walk.next()) return;
    } while (walk.row() < row);
    Record record{point, row, {}, walk.record(), {}};
    if (wanted.geographic || wanted.height) {
      Point stated = point_of(walk.record(), readable_end, layout);
      if (layout.choice.scaled_degrees) {
        stated.x /= kScaledPerDegree;
        stated.y /= kScaledPerDegree;
      }
      fill(record, stated, layout.choice.units, wanted);
    }
    if (layout.choice.id) {
      const Field field = field_at(walk.record(), layout.delimiter, *layout.choice.id);
      record.id = field.text;
      if (field.doubled_quotes) record.id = id = unquoted(field);
    }
    visit(record);
  }
}

void visit_array(const RecordSource& source, const std::vector<PointId>& ascending,
                 const Wanted& wanted, const Visit& visit) {
  const ArrayLayout& layout = *source.array;
  for (const PointId point : ascending) {
    const std::uint64_t row = source.skipped.row_of(point);
    const std::string text = layout.coordinate_text(row, 0) + "," + layout.coordinate_text(row, 1) +
                             "," + layout.coordinate_text(row, 2);
    Record record{point, row, {}, text, {}};
    if (wanted.geographic || wanted.height) {
      const Point stated{layout.coordinate(row, 0), layout.coordinate(row, 1),
                         layout.coordinate(row, 2)};
      fill(record, stated, layout.units, wanted);
    }
    visit(record);
  }
}

}  // namespace

void for_each_record(const LoadedPoints& loaded, const std::vector<PointId>& ascending,
                     const std::function<void(const Record&)>& visit) {
  if (loaded.records == nullptr) return;
  const Wanted wanted{loaded.frame == Frame::kWgs84, loaded.height_unit != Unit::kMetre};
  if (loaded.records->table) visit_table(*loaded.records, ascending, wanted, visit);
  if (loaded.records->array) visit_array(*loaded.records, ascending, wanted, visit);
}

std::span<const std::uint64_t> skipped_rows(const LoadedPoints& loaded) {
  if (loaded.records == nullptr) return {};
  return loaded.records->skipped.rows;
}

bool has_id_column(const LoadedPoints& loaded) {
  return loaded.records != nullptr && loaded.records->table &&
         loaded.records->table->choice.id.has_value();
}

std::string_view header_line(const LoadedPoints& loaded) {
  const bool table = loaded.records != nullptr && loaded.records->table;
  return table ? loaded.records->table->header : std::string_view();
}

char delimiter(const LoadedPoints& loaded) {
  const bool table = loaded.records != nullptr && loaded.records->table;
  return table ? loaded.records->table->delimiter : ',';
}

}  // namespace beespace::io
