#include "cli/moving/live_advice.hpp"

#include "cli/advice_words.hpp"
#include "cli/number_text.hpp"
#include "io/json_text.hpp"
#include "report/local_axes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace beespace::cli {
namespace {

double speed_of(const Velocity& v) {
  return std::hypot(v.x, v.y, v.z);
}

}  // namespace

Result<std::string> LiveAdvice::lines(double time_s, const LiveFeed& feed) {
  if (last_s_ == time_s) return std::string();  // the end of the input looks again
  last_s_ = time_s;
  std::vector<LiveMover> bees = feed.movers(time_s);
  // As long as nobody knows where one of them goes, nothing is certain for the others.
  const std::size_t all = bees.size();
  std::erase_if(bees, [](const LiveMover& bee) { return !bee.moves; });
  const bool all_known = bees.size() == all;
  movers_.clear();
  preferred_.clear();
  limits_.clear();
  for (const LiveMover& bee : bees) {
    movers_.push_back(bee.mover);
    preferred_.push_back(bee.mover.velocity);
    FlightLimits limits = request_.limits;
    limits.max_speed_mps = std::max(limits.max_speed_mps, speed_of(bee.mover.velocity));
    limits_.push_back(limits);
  }
  std::string text;
  if (bees.empty()) return text;
  const Status advised = adviser_.advise(movers_, preferred_, limits_, request_.options, advised_);
  if (!advised) return advised.error();
  for (std::size_t i = 0; i < bees.size(); ++i) {
    Advice advice = advised_.advice[i];
    advice.certified = advice.certified && all_known;
    if (advice.kind == AdviceKind::kAsWished && advice.certified) continue;
    ++told_;
    if (!advice.certified) ++uncertified_;
    append_line(text, time_s, bees[i], advice, feed.name(bees[i].id));
  }
  return text;
}

void LiveAdvice::append_line(std::string& out, double time_s, const LiveMover& bee,
                             const Advice& advice, const BeeName& name) const {
  const auto member = [&out](const char* key, const std::string& value) {
    out.append(", \"").append(key).append("\": ").append(value);
  };
  const auto velocity = [](const char* names, double a, double b, double c) {
    const std::string n(names);
    return "{\"v" + n.substr(0, 1) + "\": " + exact(a) + ", \"v" + n.substr(1, 1) +
           "\": " + exact(b) + ", \"v" + n.substr(2, 1) + "\": " + exact(c) + "}";
  };
  const Velocity& v = advice.velocity;
  out += "{\"event\": \"advice\"";
  member("time_s", exact(time_s));
  member("id", io::json_string(name.id));
  if (frame_ == io::Frame::kWgs84) {
    const LocalVelocity local = report::to_local_velocity(bee.mover.position, v);
    member("velocity", velocity("enu", local.east_mps, local.north_mps, local.up_mps));
  } else {
    member("velocity", velocity("xyz", v.x, v.y, v.z));
  }
  member("advice", io::json_string(name_of(advice.kind)));
  member("certified", advice.certified ? "true" : "false");
  if (!name.label.empty()) member("label", io::json_string(name.label));
  out += "}\n";
}

}  // namespace beespace::cli
