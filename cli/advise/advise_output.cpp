#include "cli/advise/advise_output.hpp"

#include "cli/output/advice_words.hpp"
#include "cli/output/block_writer.hpp"
#include "cli/output/json_units.hpp"
#include "io/bytes/byte_source.hpp"
#include "io/bytes/number_text.hpp"
#include "io/json/json_text.hpp"
#include "io/table/csv_field.hpp"

#include <beespace/version.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::cli {
namespace {

std::string finite_or_null(double value) {
  return std::isfinite(value) ? io::exact(value) : "null";
}

const char* true_or_false(bool yes) {
  return yes ? "true" : "false";
}

// "files" and what else is known of the input, as other subcommands have it.
std::string input_json(const Counsel& counsel) {
  std::string out = "{\n    \"files\": [" + io::json_string(io::source_name(counsel.request.input));
  out += "],\n    \"format\": " + io::json_string(counsel.situation.format_description);
  out += ",\n    \"bees\": " + std::to_string(counsel.situation.movers.size());
  out += ",\n    \"units\": " + json_units(counsel.situation.units);
  out += ",\n    \"notes\": [";
  std::string_view before;
  for (const std::string& note : counsel.situation.notes) {
    out.append(before).append(io::json_string(note));
    before = ", ";
  }
  return out + "]\n  }";
}

std::string head(const Counsel& counsel) {
  const AdviseRequest& request = counsel.request;
  const Situation& situation = counsel.situation;
  const Advised& advised = counsel.advised;
  std::string out = "{\n  \"version\": " + io::json_string(version());
  const auto member = [&out](const char* name, const std::string& value) {
    out.append(",\n  \"").append(name).append("\": ").append(value);
  };
  const bool own = situation.own_limits;
  const bool obstacles = !request.obstacles.empty();
  const bool intruders = !request.intruders.empty();
  member("command", "\"advise\"");
  member("input", input_json(counsel));
  member("preferred", situation.wishes ? "\"wishes\"" : "\"goals\"");
  member("method", io::json_string(name_of(request.advice.method)));
  member("threshold_m", io::exact(request.advice.threshold_m));
  member("uncertainty_m", io::exact(request.advice.uncertainty_m));
  member("own_limits", true_or_false(own));
  member("max_speed_mps", own ? "null" : io::exact(request.limits.max_speed_mps));
  member("max_acceleration_mps2",
         own ? "null" : finite_or_null(request.limits.max_acceleration_mps2));
  member("step_s", io::exact(request.advice.step_s));
  member("obstacles", std::to_string(situation.obstacles.obstacles().size()));
  member("clearance_m", obstacles ? io::exact(request.advice.clearance_m) : "null");
  member("intruders", std::to_string(situation.intruders.size()));
  member("intruder_horizon_s", intruders ? io::exact(request.advice.intruder_horizon_s) : "null");
  for (const AdviceKind kind : {AdviceKind::kAsPreferred, AdviceKind::kDeflected,
                                AdviceKind::kBraking, AdviceKind::kWaiting, AdviceKind::kNone}) {
    std::string name = std::string(name_of(kind)) + "_count";
    std::replace(name.begin(), name.end(), '-', '_');
    member(name.c_str(), std::to_string(count(advised, kind)));
  }
  member("uncertified_count", std::to_string(count_uncertified(advised)));
  return out;
}

// An array, an object a line.
template <class Item, class Text>
void write_list(BlockWriter& out, const char* name, const std::vector<Item>& items,
                const Text& text_of) {
  out.text.append(",\n  \"").append(name).append("\": [");
  for (std::size_t i = 0; i < items.size(); ++i) {
    out.text += i > 0 ? ",\n    " : "\n    ";
    out.text += text_of(items[i], i);
    out.pass_on();
  }
  out.text += items.empty() ? "]" : "\n  ]";
}

}  // namespace

std::uint64_t count(const Advised& advised, AdviceKind kind) {
  const auto found = std::count_if(advised.advice.begin(), advised.advice.end(),
                                   [kind](const Advice& advice) { return advice.kind == kind; });
  return static_cast<std::uint64_t>(found);
}

std::uint64_t count_uncertified(const Advised& advised) {
  const auto found = std::count_if(advised.advice.begin(), advised.advice.end(),
                                   [](const Advice& advice) { return !advice.certified; });
  return static_cast<std::uint64_t>(found);
}

void write_as_csv(const Counsel& counsel, io::AtomicOutput& output) {
  const auto& ids = counsel.situation.names.ids;
  BlockWriter out(output);
  out.text += "id,vx,vy,vz,advice,certified\n";
  for (std::size_t bee = 0; bee < counsel.advised.advice.size(); ++bee) {
    const Advice& advice = counsel.advised.advice[bee];
    if (ids.empty()) {
      io::append_exact(out.text, std::uint64_t{bee});
    } else {
      io::append_csv_field(out.text, ids[bee], ',');
    }
    for (const double speed : {advice.velocity.x, advice.velocity.y, advice.velocity.z}) {
      out.text += ',';
      io::append_exact(out.text, speed);
    }
    out.text.append(",").append(name_of(advice.kind)).append(advice.certified ? ",yes\n" : ",no\n");
    out.pass_on();
  }
}

void write_as_json(const Counsel& counsel, io::AtomicOutput& output) {
  const FlightNames& names = counsel.situation.names;
  const FlightNames& intruders = counsel.situation.intruder_names;
  const Advised& advised = counsel.advised;
  BlockWriter out(output);
  out.text += head(counsel);
  write_list(out, "advice", advised.advice, [&](const Advice& advice, std::size_t bee) {
    const Velocity& v = advice.velocity;
    return "{\"id\": " + names.bee_as_json(static_cast<PointId>(bee)) +
           ", \"vx\": " + io::exact(v.x) + ", \"vy\": " + io::exact(v.y) +
           ", \"vz\": " + io::exact(v.z) + ", \"advice\": \"" + name_of(advice.kind) +
           "\", \"certified\": " + true_or_false(advice.certified) +
           ", \"keeps_apart\": " + true_or_false(advice.keeps_apart) +
           ", \"clear_of_intruders\": " + true_or_false(advice.clear_of_intruders) + "}";
  });
  write_list(out, "too_close", advised.too_close, [&](const TooClose& close, std::size_t) {
    return "{\"first\": " + names.bee_as_json(close.pair.first) +
           ", \"second\": " + names.bee_as_json(close.pair.second) +
           ", \"gap_m\": " + io::exact(close.gap_m) +
           ", \"clear_s\": " + finite_or_null(close.clear_s) + "}";
  });
  write_list(out, "near_obstacle", advised.near_obstacle,
             [&](const NearObstacle& near, std::size_t) {
               return "{\"bee\": " + names.bee_as_json(near.agent) +
                      ", \"obstacle\": " + std::to_string(near.obstacle) +
                      ", \"gap_m\": " + io::exact(near.gap_m) + "}";
             });
  write_list(out, "intruder_conflicts", advised.intruder_conflicts,
             [&](const IntruderConflict& conflict, std::size_t) {
               return "{\"bee\": " + names.bee_as_json(conflict.agent) + ", \"intruder\": " +
                      intruders.bee_as_json(static_cast<PointId>(conflict.intruder)) +
                      ", \"begins_s\": " + io::exact(conflict.begins_s) +
                      ", \"closest_m\": " + io::exact(conflict.closest_m) + "}";
             });
  write_list(out, "refused", advised.refused, [&](const Refused& refused, std::size_t) {
    const bool is_bee =
        refused.kind == RefusedKind::kState || refused.kind == RefusedKind::kPreferred;
    const auto index = static_cast<PointId>(refused.index);
    return "{\"kind\": " + io::json_string(name_of(refused.kind)) +
           ", \"id\": " + (is_bee ? names : intruders).bee_as_json(index) +
           ", \"code\": " + io::json_string(to_string(refused.error.code)) +
           ", \"message\": " + io::json_string(refused.error.message) + "}";
  });
  out.text += "\n}\n";
}

}  // namespace beespace::cli
