// What was read of a snapshot: its points in metres, and its records as they stood in the input.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/units/heights.hpp"
#include "io/units/unit_taken.hpp"

#include <beespace/geodesy.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// The bytes behind the points, kept so that original records can be written out again.
class RecordSource;

struct LoadedPoints {
  std::vector<Point> points;       // metres: as given, or ECEF
  Frame frame = Frame::kMetres;    // what the input was taken for: never kAuto
  std::string frame_reason;        // why, as a phrase: "the header names longitude and latitude"
  std::string format_description;  // "text, comma-separated, gzip-compressed", "npy float64 (N, 3)"
  std::vector<UnitTaken> units;    // of what was read; heights (or z) are always among them
  Unit height_unit = Unit::kMetre;  // of Record::height
  HeightDatum heights = HeightDatum::kUnstated;
  std::vector<std::string> notes;  // what else was decided and must be told
  std::vector<Error> skipped;      // with skip_bad: the first bad records
  std::uint64_t skipped_count = 0;
  std::uint64_t repeated_headers = 0;  // lines that are the header again, and passed over
  std::uint64_t bytes = 0;             // size of the input as read (compressed, if it was)
  std::shared_ptr<const RecordSource> records;
};

// One record as it stood in the input.
struct Record {
  PointId point = 0;      // index into LoadedPoints::points
  std::uint64_t row = 0;  // 0-based data row of the file (skipped records counted)
  std::string_view id;    // the id column's text, unquoted; empty when there is no id column
  std::string_view text;  // the whole record without its line end; for arrays "x,y,z"
  GeographicPosition geographic;  // in metres; filled for Frame::kWgs84 only
  // Or z, as the input states it, in LoadedPoints::height_unit; filled for Frame::kWgs84, and where
  // that is not the metre.
  double height = 0.0;
};

// Calls `visit` for the given points, which must be ascending, in their order. The views are
// valid during the call only. Fast: one walk over the input.
void for_each_record(const LoadedPoints& loaded, const std::vector<PointId>& ascending,
                     const std::function<void(const Record&)>& visit);

// The 0-based data rows that were left out, ascending.
std::span<const std::uint64_t> skipped_rows(const LoadedPoints& loaded);

bool has_id_column(const LoadedPoints& loaded);
std::string_view header_line(const LoadedPoints& loaded);  // empty when there is none
char delimiter(const LoadedPoints& loaded);                // ',' for arrays

}  // namespace beespace::io
