#include "cli/watch/advice_line.hpp"

#include "cli/output/advice_words.hpp"
#include "io/bytes/number_text.hpp"
#include "io/json/json_text.hpp"
#include "report/local_axes.hpp"

namespace beespace::cli {
namespace {

void append_member(std::string& out, const char* key, const std::string& value) {
  out.append(", \"").append(key).append("\": ").append(value);
}

void append_times(std::string& out, const AdviceTimes& times) {
  append_member(out, "time_s", io::exact(times.time_s));
  append_member(out, "effective_s", io::exact(times.effective_s));
}

std::string velocity_text(const char* names, double a, double b, double c) {
  const std::string n(names);
  return "{\"v" + n.substr(0, 1) + "\": " + io::exact(a) + ", \"v" + n.substr(1, 1) +
         "\": " + io::exact(b) + ", \"v" + n.substr(2, 1) + "\": " + io::exact(c) + "}";
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
  const Velocity& v = advice.velocity;
  out += "{\"event\": \"advice\"";
  append_times(out, times);
  append_member(out, "id", io::json_string(name.id));
  if (advice.kind == AdviceKind::kNone) {
    // Told nothing.
  } else if (frame == io::Frame::kWgs84) {
    const LocalVelocity local = report::to_local_velocity(mover.position, v);
    append_member(out, "velocity",
                  velocity_text("enu", local.east_mps, local.north_mps, local.up_mps));
  } else {
    append_member(out, "velocity", velocity_text("xyz", v.x, v.y, v.z));
  }
  append_member(out, "advice", io::json_string(name_of(advice.kind)));
  append_member(out, "certified", doubt == Doubt::kNone ? "true" : "false");
  if (doubt != Doubt::kNone) append_member(out, "because", io::json_string(name_of(doubt)));
  if (!name.label.empty()) append_member(out, "label", io::json_string(name.label));
  out += "}\n";
}

void append_advised_line(std::string& out, const AdviceTimes& times, const LookCounts& counts) {
  out += "{\"event\": \"advised\"";
  append_times(out, times);
  append_member(out, "bees", std::to_string(counts.agents));
  append_member(out, "told", std::to_string(counts.told));
  append_member(out, "certified", std::to_string(counts.doubts[0]));
  std::string because;
  for (std::size_t i = 1; i < kDoubts; ++i) {
    if (counts.doubts[i] == 0) continue;
    because += (because.empty() ? "{\"" : ", \"") + std::string(name_of(static_cast<Doubt>(i))) +
               "\": " + std::to_string(counts.doubts[i]);
  }
  if (!because.empty()) append_member(out, "not_certified", because + "}");
  out += "}\n";
}

}  // namespace beespace::cli
