// Fuzzes the reader of DataFlash logs of ArduPilot: the walk over messages, layouts of definitions,
// and what becomes of them in a recording.
//
// The input is a log behind its first definition, which is put before it. Beyond the sanitizers, it
// checks that a message has the length that its layout says, that damage is no longer than the log,
// and that times ascend.
#include "io/ardupilot/dataflash_walk.hpp"
#include "io/load_recording.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace beespace::io {
namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void walk_through(std::string_view log) {
  DataflashWalk walk(log);
  while (walk.next()) {
    const DataflashLayout& layout = walk.layout();
    require(walk.message().size() + kDataflashFront == layout.size);
    for (const DataflashField& field : layout.fields) {
      static_cast<void>(dataflash_number(walk.message(), field));
      require(dataflash_text(walk.message(), field).size() <= walk.message().size());
    }
  }
  require(walk.losses().damaged_bytes <= log.size());
  require((walk.losses().damaged_places > 0) == (walk.losses().damaged_bytes > 0));
}

void check(const Recording& recording) {
  require(recording.bees.size() == 1 && recording.bees[0].id == "fuzz");
  const RecordedBee& bee = recording.bees[0];
  require(!bee.fixes.empty());
  for (std::size_t i = 0; i < bee.fixes.size(); ++i) {
    const Point& at = bee.fixes[i].position;
    require(std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z));
    require(i == 0 || bee.fixes[i - 1].time_s < bee.fixes[i].time_s);
  }
}

}  // namespace
}  // namespace beespace::io

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace beespace::io;
  if (size == 0) return 0;
  std::string log =
      "\xA3\x95\x80\x80\x59"
      "FMT";
  log.append(81, '\0');
  log.append(reinterpret_cast<const char*>(data) + 1, size - 1);
  walk_through(log);
  RecordingOptions options;
  options.skip_bad = data[0] % 2 == 1;
  options.grounded = (data[0] / 2) % 2 == 1;
  const auto loaded = load_recording_from_memory(log, "fuzz", options);
  if (loaded) check(loaded.value());
  return 0;
}
