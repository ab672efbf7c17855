#include "io/fleet/status_message.hpp"

#include "io/fleet/fleet_writer.hpp"
#include "io/problems/excerpt.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace beespace::io {
namespace {

template <class Value>
struct Named {
  Value value;
  std::string_view name;
};

constexpr std::array<Named<Contract>, 3> kContracts = {
    {{Contract::kKept, "kept"}, {Contract::kDoubted, "doubted"}, {Contract::kOut, "out"}}};

constexpr std::array<Named<ContractReason>, 6> kReasons = {
    {{ContractReason::kNone, "none"},
     {ContractReason::kDeviation, "deviation"},
     {ContractReason::kRate, "rate"},
     {ContractReason::kSilent, "silent"},
     {ContractReason::kNoBranch, "no_branch"},
     {ContractReason::kFuture, "future"}}};

template <class Value, std::size_t Count>
std::string_view name_among(const std::array<Named<Value>, Count>& all, Value value) {
  for (const auto& named : all) {
    if (named.value == value) return named.name;
  }
  return "unknown";
}

template <class Value, std::size_t Count>
Value read_word(FleetFields& fields, std::string_view key,
                const std::array<Named<Value>, Count>& all) {
  const std::string_view word = fields.text(key);
  std::string known;
  for (const auto& named : all) {
    if (named.name == word) return named.value;
    known.append(known.empty() ? "" : ", ").append(named.name);
  }
  fields.fail(ErrorCode::kMalformedRecord,
              fields.name(key) + " is " + excerpt(word) + "; known are " + known);
  return all.front().value;
}

}  // namespace

std::string_view name_of(Contract contract) {
  return name_among(kContracts, contract);
}

std::string_view name_of(ContractReason reason) {
  return name_among(kReasons, reason);
}

void append_status(std::string& out, std::string_view id, std::string_view advice, Tick tick,
                   const AgentGuidance& told) {
  {
    JsonWriter json(out);
    json.begin_object().member("event", "status").member("id", id);
    write_tick(json, "tick", tick);
    json.member("contract", name_of(told.contract)).member("reason", name_of(told.reason));
    json.member("certified", told.certified).member("keeps_apart", told.keeps_apart);
    json.member("clear_of_intruders", told.clear_of_intruders);
    json.member("advice", advice).member("commanded", told.commanded);
    json.member("branches", told.branches);
    write_vector(json, "position", told.nominal.position);
    write_vector(json, "velocity", told.nominal.velocity);
    json.member("tube_m", told.tube_m).member("deviation_m", told.deviation_m).end();
  }
  out += '\n';
}

StatusMessage read_status(FleetFields& fields) {
  StatusMessage status;
  AgentGuidance& told = status.told;
  status.tick = fields.tick("tick");
  told.contract = read_word(fields, "contract", kContracts);
  told.reason = read_word(fields, "reason", kReasons);
  told.certified = fields.flag("certified");
  told.keeps_apart = fields.flag("keeps_apart");
  told.clear_of_intruders = fields.flag("clear_of_intruders");
  fields.text("advice");
  told.commanded = fields.flag("commanded");
  told.branches = fields.whole("branches");
  told.nominal.position = fields.point("position");
  const Point velocity = fields.point("velocity");
  told.nominal.velocity = {velocity.x, velocity.y, velocity.z};
  told.tube_m = fields.from_zero("tube_m");
  told.deviation_m = fields.from_zero("deviation_m");
  return status;
}

}  // namespace beespace::io
