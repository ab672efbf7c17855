// Fuzzes the reader of PX4 logs: the walk over messages, layouts of definitions, and what becomes
// of them in a recording.
//
// The input is a log behind its first sixteen bytes, which are put before it, so that nothing is
// wasted on the magic. Beyond the sanitizers, it checks that a message has the length that its
// layout says, that damage and messages together are no longer than the log, and that times ascend.
#include "io/load_recording.hpp"
#include "io/px4/ulog_walk.hpp"

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
  auto walk = UlogWalk::begin(log);
  if (!walk) return;
  std::size_t behind = 0;
  while (walk->next()) {
    const UlogTopic& topic = walk->topic();
    require(topic.layout.has_value());
    require(walk->message().size() >= topic.layout->least_size);
    require(walk->message().size() <= topic.layout->size);
    require(walk->offset() >= behind && walk->offset() < log.size());
    behind = walk->offset() + walk->message().size();
    for (const UlogField& field : topic.layout->fields) {
      if (topic.layout->number(field.name) != &field || field.name.starts_with("_padding"))
        continue;
      static_cast<void>(ulog_number(walk->message(), field));
    }
  }
  require(walk->losses().damaged_bytes <= log.size());
  require((walk->losses().damaged_places > 0) == (walk->losses().damaged_bytes > 0));
}

void check(const Recording& recording) {
  require(recording.bees.size() == 1 && recording.bees[0].id == "fuzz");
  const RecordedBee& bee = recording.bees[0];
  require(!bee.fixes.empty() && bee.velocities.size() == bee.fixes.size());
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
  const std::string log = std::string("ULog\x01\x12\x35\x01\0\0\0\0\0\0\0\0", 16) +
                          std::string(reinterpret_cast<const char*>(data) + 1, size - 1);
  walk_through(log);
  RecordingOptions options;
  options.frame = static_cast<Frame>(data[0] % 3);
  options.skip_bad = (data[0] / 3) % 2 == 1;
  options.heights = static_cast<HeightSource>((data[0] / 6) % 3);
  const auto loaded = load_recording_from_memory(log, "fuzz", options);
  if (loaded) check(loaded.value());
  return 0;
}
