// Fuzzes live input: the first byte chooses the options, the rest is taken line by line.
//
// Beyond the sanitizers, it checks what must hold for every report, and that errors have a line.
#include "io/frames/track_domain.hpp"
#include "io/live/report_lines.hpp"

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

RecordingOptions options_from(unsigned choice) {
  RecordingOptions options;
  options.frame = static_cast<Frame>(choice % 3);
  options.heights = static_cast<HeightSource>((choice / 3) % 3);
  options.grounded = choice % 2 == 1;
  const char* const columns[] = {"", "", "", "id=1,time=2,x=3,y=4,z=5", "time=2"};
  options.columns = columns[choice % 5];
  options.time_unit = choice % 7 == 0 ? Unit::kMillisecond : Unit::kUnstated;
  if (choice % 11 == 3) options.units.height = Unit::kFoot;
  if (choice % 13 == 5) options.units.climb = Unit::kFootPerMinute;
  return options;
}

void check_report(const ReportLine& report) {
  require(!report.id.empty() && report.frame != Frame::kAuto);
  require(in_motion_domain(report.time_s));
  const Point& at = report.position;
  require(in_motion_domain(at.x) && in_motion_domain(at.y) && in_motion_domain(at.z));
  if (report.frame == Frame::kWgs84) {
    require(std::abs(at.x) <= 360.0 && std::abs(at.y) <= 90.0);
  }
  if (!report.velocity) return;
  const Velocity& velocity = *report.velocity;
  require(in_motion_domain(velocity.x) && in_motion_domain(velocity.y) &&
          in_motion_domain(velocity.z));
}

}  // namespace
}  // namespace beespace::io

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace beespace::io;
  if (size == 0) return 0;
  ReportLines lines(options_from(data[0]));
  std::string_view rest(reinterpret_cast<const char*>(data) + 1, size - 1);
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    const auto taken = lines.take(rest.substr(0, end));
    if (!taken) {
      require(taken.error().location.line.has_value() && !taken.error().message.empty());
    } else if (taken->has_value()) {
      check_report(**taken);
    }
    if (end == std::string_view::npos) break;
    rest.remove_prefix(end + 1);
  }
  for (const std::string& note : lines.notes()) require(!note.empty());
  return 0;
}
