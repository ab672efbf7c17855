// Fuzzes everything that reads recordings: tables of fixes, zip archives, shows in JSON, aircraft,
// telemetry logs.
//
// The first byte chooses the options and how the rest is handed over: as it is, as the only file of
// an archive, or as the trajectory that a show refers to. Beyond the sanitizers, it checks what
// must hold for any recording: ids differ, times ascend, and everything is in the motion domain.
#include "io/frames/coordinate_frame.hpp"
#include "io/frames/track_domain.hpp"
#include "io/load_recording.hpp"
#include "io/units/heights.hpp"

#include <zip.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <unordered_set>

namespace beespace::io {
namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

RecordingOptions options_from(unsigned choice) {
  RecordingOptions options;
  options.frame = static_cast<Frame>(choice % 3);
  options.skip_bad = (choice / 3) % 2 == 1;
  options.grounded = (choice / 3) % 2 == 1;
  const char* const columns[] = {
      "", "", "", "id=1,time=2,x=3,y=4,z=5", "time=2", "lon=1,lat=2,height=3,ve=4,vn=5"};
  options.heights = static_cast<HeightSource>((choice / 9) % 3);
  options.columns = columns[(choice / 6) % 6];
  options.time_unit = choice % 5 == 0 ? Unit::kMillisecond : Unit::kUnstated;
  options.format = choice % 7 == 0 ? RecordingFormat::kSkybrushCsv : RecordingFormat::kAuto;
  if (choice % 11 == 3) options.units.height = Unit::kFoot;
  if (choice % 13 == 5) options.units.climb = Unit::kFootPerMinute;
  return options;
}

// An archive that holds `content` as `name`, and a show that refers to it.
std::string archived(std::string_view content, const char* name) {
  constexpr std::string_view kShow =
      R"({"swarm": {"drones": [{"settings": {"trajectory": {"$ref": "a.json"}}}]}})";
  zip_error_t error = {};
  zip_source_t* const target = zip_source_buffer_create(nullptr, 0, 0, &error);
  zip_t* const archive = zip_open_from_source(target, ZIP_TRUNCATE, &error);
  require(archive != nullptr);
  zip_source_keep(target);
  const auto add = [archive](const char* member, std::string_view text) {
    zip_source_t* const source = zip_source_buffer(archive, text.data(), text.size(), 0);
    const zip_int64_t index = zip_file_add(archive, member, source, 0);
    zip_set_file_compression(archive, static_cast<zip_uint64_t>(index), ZIP_CM_STORE, 0);
  };
  add(name, content);
  if (std::string_view(name) == "a.json") add("show.json", kShow);
  require(zip_close(archive) == 0);
  std::string bytes;
  require(zip_source_open(target) == 0);
  zip_source_seek(target, 0, SEEK_END);
  bytes.resize(static_cast<std::size_t>(zip_source_tell(target)));
  zip_source_seek(target, 0, SEEK_SET);
  zip_source_read(target, bytes.data(), bytes.size());
  zip_source_close(target);
  zip_source_free(target);
  return bytes;
}

void check_point(const Point& point) {
  require(in_motion_domain(point.x) && in_motion_domain(point.y) && in_motion_domain(point.z));
}

// What is not known of it is not-a-number.
void check_velocity(const Velocity& velocity) {
  for (const double value : {velocity.x, velocity.y, velocity.z}) {
    require(std::isnan(value) || in_motion_domain(value));
  }
}

void check_path(const BezierPath& path) {
  check_point(path.begin);
  double time_s = path.begins_s;
  for (const BezierPiece& piece : path.pieces) {
    require(time_s < piece.ends_s && piece.control_count <= 2);
    check_point(piece.end);
    for (const Point& control : piece.controls) check_point(control);
    time_s = piece.ends_s;
  }
}

void check_recording(const Recording& recording) {
  require(!recording.bees.empty() && recording.frame != Frame::kAuto);
  std::unordered_set<std::string> ids;
  for (const RecordedBee& bee : recording.bees) {
    require(ids.insert(bee.id).second);
    require(bee.path.has_value() == bee.fixes.empty());
    require(bee.velocities.empty() || bee.velocities.size() == bee.fixes.size());
    if (bee.path) check_path(*bee.path);
    for (const Velocity& velocity : bee.velocities) check_velocity(velocity);
    for (std::size_t i = 0; i < bee.fixes.size(); ++i) {
      check_point(bee.fixes[i].position);
      require(in_motion_domain(bee.fixes[i].time_s));
      require(i == 0 || bee.fixes[i - 1].time_s < bee.fixes[i].time_s);
    }
  }
}

}  // namespace
}  // namespace beespace::io

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace beespace::io;
  if (size == 0) return 0;
  const RecordingOptions options = options_from(data[0]);
  const std::string_view content(reinterpret_cast<const char*>(data) + 1, size - 1);
  const unsigned wrapping = data[0] / 36u;
  const auto loaded =
      wrapping == 5   ? load_recording_from_memory(archived(content, "a.csv"), "fuzz", options)
      : wrapping == 6 ? load_recording_from_memory(archived(content, "a.json"), "fuzz", options)
                      : load_recording_from_memory(content, "fuzz", options);
  if (loaded) check_recording(loaded.value());
  return 0;
}
