#include "cli/advise/advise_output.hpp"

#include "cli/output/advice_words.hpp"
#include "cli/output/block_writer.hpp"
#include "cli/output/json_units.hpp"
#include "io/bytes/byte_source.hpp"
#include "io/bytes/number_text.hpp"
#include "io/json/json_writer.hpp"
#include "io/table/table_writer.hpp"

#include <beespace/version.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace beespace::cli {
namespace {

// "files" and what else is known of the input, as other subcommands have it.
void write_input(io::JsonWriter& json, const AdviceAnswer& answer) {
  const AdviceInput& given = answer.given;
  json.begin_object("input", io::JsonLayout::kLines);
  json.member("files", std::array{io::source_name(answer.request.input)});
  json.member("format", given.format_description).member("bees", given.movers.size());
  write_units(json.key("units"), given.units);
  json.member("notes", given.notes);
  json.end();
}

void write_head(io::JsonWriter& json, const AdviceAnswer& answer) {
  const AdviseRequest& request = answer.request;
  const AdviseOptions& advice = request.advice;
  const AdviceInput& given = answer.given;
  const bool limits = !given.own_limits;
  json.member("version", version()).member("command", "advise");
  write_input(json, answer);
  json.member("preferred", given.preferred_given ? "velocities" : "goals");
  json.member("method", name_of(advice.method)).member("threshold_m", advice.threshold_m);
  json.member("uncertainty_m", advice.uncertainty_m).member("own_limits", given.own_limits);
  json.member("max_speed_mps", io::known_if(limits, request.limits.max_speed_mps));
  json.member("max_acceleration_mps2", io::known_if(limits, request.limits.max_acceleration_mps2));
  json.member("step_s", advice.step_s).member("obstacles", given.obstacles.obstacles().size());
  json.member("clearance_m", io::known_if(!request.obstacles.empty(), advice.clearance_m));
  json.member("intruders", given.intruders.size());
  json.member("intruder_horizon_s",
              io::known_if(!request.intruders.empty(), advice.intruder_horizon_s));
  for (const AdviceKind kind : {AdviceKind::kAsPreferred, AdviceKind::kDeflected,
                                AdviceKind::kBraking, AdviceKind::kWaiting, AdviceKind::kNone}) {
    std::string name = std::string(name_of(kind)) + "_count";
    std::replace(name.begin(), name.end(), '-', '_');
    json.member(name, count(answer.advised, kind));
  }
  json.member("uncertified_count", count_uncertified(answer.advised));
}

// An array, an object a line: `write` writes its members.
template <class Item>
void write_list(BlockWriter& out, io::JsonWriter& json, const char* name,
                const std::vector<Item>& items, const auto& write) {
  json.begin_array(name, io::JsonLayout::kLines);
  for (const Item& item : items) {
    json.begin_object();
    write(item);
    json.end();
    out.pass_on();
  }
  json.end();
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

void write_as_csv(const AdviceAnswer& answer, io::AtomicOutput& output) {
  const auto& ids = answer.given.names.ids;
  BlockWriter out(output);
  io::TableWriter table(out.text, ',');
  table.header("id,vx,vy,vz,advice,certified").end_row();
  for (std::size_t bee = 0; bee < answer.advised.advice.size(); ++bee) {
    const Advice& advice = answer.advised.advice[bee];
    ids.empty() ? table.field(bee) : table.field(ids[bee]);
    table.field(advice.velocity.x).field(advice.velocity.y).field(advice.velocity.z);
    table.field(name_of(advice.kind)).field(advice.certified).end_row();
    out.pass_on();
  }
}

void write_as_json(const AdviceAnswer& answer, io::AtomicOutput& output) {
  const FlightNames& names = answer.given.names;
  const FlightNames& intruders = answer.given.intruder_names;
  const Advised& advised = answer.advised;
  BlockWriter out(output);
  io::JsonWriter json(out.text);
  json.begin_object(io::JsonLayout::kLines);
  write_head(json, answer);
  PointId bee = 0;
  write_list(out, json, "advice", advised.advice, [&](const Advice& advice) {
    names.write_bee(json.key("id"), bee++);
    json.member("vx", advice.velocity.x).member("vy", advice.velocity.y);
    json.member("vz", advice.velocity.z).member("advice", name_of(advice.kind));
    json.member("certified", advice.certified).member("keeps_apart", advice.keeps_apart);
    json.member("clear_of_intruders", advice.clear_of_intruders);
  });
  write_list(out, json, "too_close", advised.too_close, [&](const TooClose& close) {
    names.write_bee(json.key("first"), close.pair.first);
    names.write_bee(json.key("second"), close.pair.second);
    json.member("gap_m", close.gap_m).member("clear_s", close.clear_s);
  });
  write_list(out, json, "near_obstacle", advised.near_obstacle, [&](const NearObstacle& near) {
    names.write_bee(json.key("bee"), near.agent);
    json.member("obstacle", near.obstacle).member("gap_m", near.gap_m);
  });
  write_list(out, json, "intruder_conflicts", advised.intruder_conflicts,
             [&](const IntruderConflict& conflict) {
               names.write_bee(json.key("bee"), conflict.agent);
               intruders.write_bee(json.key("intruder"), static_cast<PointId>(conflict.intruder));
               json.member("begins_s", conflict.begins_s).member("closest_m", conflict.closest_m);
             });
  write_list(out, json, "refused", advised.refused, [&](const Refused& refused) {
    const bool is_bee =
        refused.kind == RefusedKind::kState || refused.kind == RefusedKind::kPreferred;
    json.member("kind", name_of(refused.kind));
    (is_bee ? names : intruders).write_bee(json.key("id"), static_cast<PointId>(refused.index));
    json.member("code", to_string(refused.error.code)).member("message", refused.error.message);
  });
  json.end();
  out.text += '\n';
}

}  // namespace beespace::cli
