#include "cli/guide/guidance_lines.hpp"

#include "cli/output/advice_words.hpp"
#include "io/fleet/status_message.hpp"
#include "io/json/json_writer.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace beespace::cli {
namespace {

void append_pair(std::string& out, Tick tick, const UncertifiedPair& pair,
                 const AgentNames& names) {
  {
    io::JsonWriter json(out);
    json.begin_object().member("event", "pair").member("tick", tick);
    json.member("first", names.name(pair.first)).member("second", names.name(pair.second));
    json.member("gap_m", pair.gap_m).member("clear_s", pair.clear_s).end();
  }
  out += '\n';
}

void append_objects(std::string& out, Tick tick, std::string_view event, std::string_view what,
                    const std::vector<AgentAndObject>& found, const AgentNames& names) {
  for (const AgentAndObject& one : found) {
    {
      io::JsonWriter json(out);
      json.begin_object().member("event", event).member("id", names.name(one.agent));
      json.member("tick", tick).member(what, one.object).member("gap_m", one.gap_m).end();
    }
    out += '\n';
  }
}

struct Counts {
  std::uint64_t certified = 0;
  std::uint64_t doubted = 0;
  std::uint64_t out_of_contract = 0;
  std::uint64_t waiting = 0;
};

Counts count(const Guidance& guidance) {
  Counts counts;
  for (const AgentGuidance& agent : guidance.agents) {
    counts.certified += agent.certified ? 1 : 0;
    counts.doubted += agent.contract == Contract::kDoubted ? 1 : 0;
    counts.out_of_contract += agent.contract == Contract::kOut ? 1 : 0;
    counts.waiting += agent.kind == AdviceKind::kWaiting ? 1 : 0;
  }
  return counts;
}

void append_ticked(std::string& out, const Guidance& guidance) {
  const Counts counts = count(guidance);
  {
    io::JsonWriter json(out);
    json.begin_object().member("event", "ticked").member("tick", guidance.tick);
    json.member("agents", guidance.agents.size()).member("commands", guidance.commands.size());
    json.member("certified", counts.certified).member("doubted", counts.doubted);
    json.member("out", counts.out_of_contract).member("waiting", counts.waiting);
    json.member("pairs", guidance.pairs.size()).end();
  }
  out += '\n';
}

}  // namespace

bool GuidanceLines::is_new(const AgentGuidance& agent) {
  if (wanted_ != StatusLines::kChanges) return wanted_ == StatusLines::kAll;
  const Told now{agent.contract, agent.reason, agent.certified, agent.keeps_apart,
                 agent.clear_of_intruders};
  const auto [told, first] = told_.try_emplace(agent.agent, now);
  if (!first && told->second == now) return false;
  told->second = now;
  return true;
}

void GuidanceLines::append(std::string& out, const Guidance& guidance, const AgentNames& names) {
  const Tick tick = guidance.tick;
  for (const AgentGuidance& agent : guidance.agents) {
    if (!is_new(agent)) continue;
    io::append_status(out, names.name(agent.agent), name_of(agent.kind), tick, agent);
  }
  for (const UncertifiedPair& pair : guidance.pairs) append_pair(out, tick, pair, names);
  append_objects(out, tick, "near_obstacle", "obstacle", guidance.near_obstacle, names);
  append_objects(out, tick, "near_fence", "fence", guidance.near_fence, names);
  append_objects(out, tick, "intruder_conflict", "intruder", guidance.intruder_conflicts, names);
  append_ticked(out, guidance);
}

}  // namespace beespace::cli
