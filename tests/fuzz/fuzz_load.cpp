// Fuzzes everything that reads input: text tables, .npy, raw float64, gzip.
//
// The first byte chooses the options, the rest is the input. Beyond the sanitizers, it checks what
// must hold for any input: points are finite, every record can be found again, and the fast and
// the thorough way through a text table give the same answer in pieces of any size.
#include "io/frames/coordinate_frame.hpp"
#include "io/load_points.hpp"
#include "io/points/table_reading.hpp"
#include "io/problems/text_check.hpp"
#include "io/units/heights.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {
namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

LoadOptions options_from(unsigned choice) {
  LoadOptions options;
  options.frame = static_cast<Frame>(choice % 3);
  options.skip_bad = (choice / 3) % 2 == 1;
  const char* const columns[] = {"", "", "", "x=1,y=2,z=3", "lon=2,lat=1", "x=x,y=y,id=1"};
  options.columns = columns[(choice / 6) % 6];
  options.threads = 1 + (choice / 36) % 2;
  if (choice % 11 == 3) options.units.height = Unit::kFoot;
  if (choice % 13 == 5) options.units.position = Unit::kKilometre;
  options.heights = static_cast<HeightSource>((choice / 9) % 3);
  return options;
}

void check_loaded(const LoadedPoints& loaded) {
  require(!loaded.points.empty() && loaded.frame != Frame::kAuto);
  for (const Point& point : loaded.points) {
    require(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z));
  }
  std::vector<PointId> ids(loaded.points.size());
  std::iota(ids.begin(), ids.end(), PointId{0});
  std::size_t visited = 0;
  for_each_record(loaded, ids, [&visited](const Record& record) {
    require(record.point == visited && record.row >= visited);
    ++visited;
  });
  require(visited == ids.size());
}

// The same table in small pieces, with and without the fast path.
void check_ways(std::string_view text, const LoadOptions& options) {
  if (text_problem(text)) return;
  text = without_byte_order_mark(text);
  const auto layout = find_layout(text, {.frame = options.frame,
                                         .columns = options.columns,
                                         .units = options.units,
                                         .heights = options.heights});
  if (!layout) return;
  TableOptions table;
  table.skip_bad = options.skip_bad;
  table.piece_bytes = 1 + text.size() / 3;
  const auto fast = read_table(text, layout.value(), table);
  table.fast_path = false;
  table.piece_bytes = std::size_t{1} << 20;
  const auto thorough = read_table(text, layout.value(), table);
  require(fast.has_value() == thorough.has_value());
  if (!fast) {
    require(to_string(fast.error()) == to_string(thorough.error()));
    return;
  }
  require(fast.value().points == thorough.value().points);
  require(fast.value().skipped.rows == thorough.value().skipped.rows);
}

}  // namespace
}  // namespace beespace::io

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace beespace::io;
  if (size == 0) return 0;
  const LoadOptions options = options_from(data[0]);
  const std::string_view content(reinterpret_cast<const char*>(data) + 1, size - 1);
  const auto loaded =
      load_points_from_memory(content, data[0] >= 216 ? "fuzz.bin" : "fuzz.csv", options);
  if (loaded) check_loaded(loaded.value());
  check_ways(content, options);
  return 0;
}
