// From a file, or standard input, to points in metres: the one door into the io room.
//
// Reads text tables (the course format, x,y,z, any delimiter), .npy arrays and raw float64, each
// plain or gzip-compressed. The format is told by the content where the content says it.
#pragma once

#include "io/unit_wishes.hpp"
#include "io/units.hpp"

#include <beespace/geodesy.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

enum class Frame : std::uint8_t { kAuto, kWgs84, kMetres };
enum class Format : std::uint8_t { kAuto, kText, kNpy, kRawFloat64 };

// What a height is counted from.
enum class HeightDatum : std::uint8_t {
  kUnstated,      // the file does not say
  kEllipsoid,     // WGS84
  kMeanSeaLevel,  // a geoid
  kPressure,      // barometric, of the standard atmosphere
  kHome,          // the place of take-off
};

// Of those who tell several heights, such as aircraft: never some of one kind and some of the
// other.
enum class HeightSource : std::uint8_t {
  kAuto,       // geometric where the format has it, otherwise by pressure
  kGeometric,  // by satellites, above the WGS84 ellipsoid
  kPressure,   // of the standard atmosphere
};

// What tells a unit.
enum class UnitEvidence : std::uint8_t {
  kNamed,   // the header, or the format
  kAsked,   // the caller
  kSource,  // that the whole header is the documented one of a known source
  kUsual,   // nothing: ours, where nothing speaks of another one
};

// The unit that some numbers of the input were taken for, and why: to be said aloud.
struct UnitTaken {
  std::string of;  // "heights", "speeds", "climb rates", "x and y"
  Unit unit = Unit::kMetre;
  UnitEvidence evidence = UnitEvidence::kUsual;
  std::string reason;  // as a phrase

  friend bool operator==(const UnitTaken&, const UnitTaken&) = default;
};

// How far a long read has come; written by the reader, read by whoever shows it.
struct Progress {
  std::atomic<std::uint64_t> done{0};   // bytes
  std::atomic<std::uint64_t> total{0};  // bytes; 0 while unknown
};

struct LoadOptions {
  Frame frame = Frame::kAuto;
  Format format = Format::kAuto;
  bool format_can_be_said = false;  // whether an error may advise to say --format
  std::string columns = {};  // "lon=1,lat=2,height=3", by number (from 1) or name; empty: automatic
  UnitWishes units = {};     // where the header names none
  HeightSource heights = HeightSource::kAuto;  // of tables that have several
  bool skip_bad = false;  // leave bad records out and list them, instead of failing at the first
  unsigned threads = 1;
  Progress* progress = nullptr;  // optional; must outlive the call
};

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
  std::vector<std::string> notes;  // what else was decided and must be said aloud
  std::vector<Error> skipped;      // with skip_bad: the first kMostSkippedListed bad records
  std::uint64_t skipped_count = 0;
  std::uint64_t bytes = 0;  // size of the input as read (compressed, if it was)
  std::shared_ptr<const RecordSource> records;

  static constexpr std::size_t kMostSkippedListed = 20;
};

// `path` is a file name, or "-" for standard input. Errors carry file, line and column.
Result<LoadedPoints> load_points(const std::string& path, const LoadOptions& options = {});

// The same for bytes in memory (copied); `name` stands for the file in messages, and its ending
// tells raw float64 (".bin") as a file's does.
Result<LoadedPoints> load_points_from_memory(std::string_view content, const std::string& name,
                                             const LoadOptions& options = {});

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

bool has_id_column(const LoadedPoints& loaded);
std::string_view header_line(const LoadedPoints& loaded);  // empty when there is none
char delimiter(const LoadedPoints& loaded);                // ',' for arrays

}  // namespace beespace::io
