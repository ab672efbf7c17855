#include "cli/watch/advice_line.hpp"

#include "cli/output/advice_words.hpp"
#include "io/json/json_writer.hpp"
#include "report/local_axes.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>

namespace beespace::cli {
namespace {

void write_times(io::JsonWriter& json, const AdviceTimes& times) {
  json.member("time_s", times.time_s).member("effective_s", times.effective_s);
}

void write_velocity(io::JsonWriter& json, const Mover& mover, Velocity v, io::Frame frame) {
  const bool degrees = frame == io::Frame::kWgs84;
  if (degrees) {
    const LocalVelocity local = report::to_local_velocity(mover.position, v);
    v = {local.east_mps, local.north_mps, local.up_mps};
  }
  json.begin_object("velocity").member(degrees ? "ve" : "vx", v.x);
  json.member(degrees ? "vn" : "vy", v.y);
  json.member(degrees ? "vu" : "vz", v.z);
  json.end();
}

}  // namespace

const char* name_of(Doubt doubt) {
  switch (doubt) {
    case Doubt::kNone:
      return "none";
    case Doubt::kHeardOnce:
      return "heard_once";
    case Doubt::kNoVelocity:
      return "no_velocity";
    case Doubt::kNotAsAdvised:
      return "not_as_advised";
    case Doubt::kOldReport:
      return "old_report";
    case Doubt::kStale:
      return "stale";
    case Doubt::kTooClose:
      return "too_close";
    case Doubt::kNearUnknown:
      return "near_unknown";
    case Doubt::kRefused:
      return "refused";
    case Doubt::kUnplaced:
      return "unplaced_bee";
    case Doubt::kClockOff:
      return "clock_off";
  }
  return "unknown";
}

void append_advice_line(std::string& out, const AdviceTimes& times, const analysis::BeeName& name,
                        const Mover& mover, const Advice& advice, Doubt doubt, io::Frame frame) {
  io::JsonWriter json(out);
  json.begin_object().member("event", "advice");
  write_times(json, times);
  json.member("id", name.id);
  if (advice.kind != AdviceKind::kNone) write_velocity(json, mover, advice.velocity, frame);
  json.member("advice", name_of(advice.kind)).member("certified", doubt == Doubt::kNone);
  if (doubt != Doubt::kNone) json.member("because", name_of(doubt));
  if (!name.label.empty()) json.member("label", name.label);
  json.end();
  out += '\n';
}

void append_advised_line(std::string& out, const AdviceTimes& times, const LookCounts& counts) {
  io::JsonWriter json(out);
  json.begin_object().member("event", "advised");
  write_times(json, times);
  json.member("bees", counts.bees).member("told", counts.told);
  json.member("certified", counts.doubts[0]);
  if (std::any_of(counts.doubts.begin() + 1, counts.doubts.end(), std::identity())) {
    json.begin_object("not_certified");
    for (std::size_t i = 1; i < kDoubts; ++i) {
      if (counts.doubts[i] > 0) json.member(name_of(static_cast<Doubt>(i)), counts.doubts[i]);
    }
    json.end();
  }
  json.end();
  out += '\n';
}

}  // namespace beespace::cli
