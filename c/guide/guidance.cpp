#include "c/guide/guidance.hpp"

#include "c/advice/advice.hpp"
#include "c/door/agents.hpp"
#include "c/door/door.hpp"
#include "c/door/points.hpp"
#include "c/guide/messages.hpp"

#include <cstddef>

namespace beespace::c {

namespace {

// C++ may number these anew; C may not.
std::int32_t contract_of(Contract contract) {
  switch (contract) {
    case Contract::kKept:
      return BEESPACE_CONTRACT_KEPT;
    case Contract::kDoubted:
      return BEESPACE_CONTRACT_DOUBTED;
    case Contract::kOut:
      return BEESPACE_CONTRACT_OUT;
  }
  return BEESPACE_CONTRACT_OUT;
}

std::int32_t reason_of(ContractReason reason) {
  switch (reason) {
    case ContractReason::kNone:
      return BEESPACE_REASON_NONE;
    case ContractReason::kDeviation:
      return BEESPACE_REASON_DEVIATION;
    case ContractReason::kRate:
      return BEESPACE_REASON_RATE;
    case ContractReason::kSilent:
      return BEESPACE_REASON_SILENT;
    case ContractReason::kNoBranch:
      return BEESPACE_REASON_NO_BRANCH;
    case ContractReason::kFuture:
      return BEESPACE_REASON_FUTURE;
  }
  return BEESPACE_REASON_NO_BRANCH;
}

Findings::Row row_of_object(const AgentAndObject& found) {
  return {agent_number_of(found.agent), static_cast<std::int64_t>(found.object), found.gap_m};
}

}  // namespace

}  // namespace beespace::c

using beespace::c::Findings;

void beespace_guidance::clear() {
  tick = 0;
  resize(0);
  for (Findings& list : findings) list.clear();
  commands.clear();
  given.clear();
}

void beespace_guidance::resize(std::size_t size) {
  agents.resize(size);
  for (auto* const numbers : {&contracts, &reasons, &kinds, &branches}) numbers->resize(size);
  for (auto* const flags : {&certified, &keeps_apart, &clear_of_intruders, &commanded})
    flags->resize(size);
  for (auto* const threes : {&positions, &velocities}) threes->resize(3 * size);
  for (auto* const lengths : {&tubes_m, &deviations_m}) lengths->resize(size);
}

void beespace_guidance::write() {
  tick = given.tick;
  resize(given.agents.size());
  for (std::size_t i = 0; i < given.agents.size(); ++i) {
    const beespace::AgentGuidance& agent = given.agents[i];
    agents[i] = beespace::c::agent_number_of(agent.agent);
    contracts[i] = beespace::c::contract_of(agent.contract);
    reasons[i] = beespace::c::reason_of(agent.reason);
    certified[i] = agent.certified ? 1 : 0;
    keeps_apart[i] = agent.keeps_apart ? 1 : 0;
    clear_of_intruders[i] = agent.clear_of_intruders ? 1 : 0;
    kinds[i] = beespace::c::kind_of(agent.kind);
    commanded[i] = agent.commanded ? 1 : 0;
    branches[i] = static_cast<std::int32_t>(agent.branches);
    beespace::c::write_three(agent.nominal.position, &positions[3 * i]);
    beespace::c::write_three(agent.nominal.velocity, &velocities[3 * i]);
    tubes_m[i] = agent.tube_m;
    deviations_m[i] = agent.deviation_m;
  }
  findings[BEESPACE_TOO_CLOSE].write(given.pairs, true, [](const auto& pair) {
    return Findings::Row{beespace::c::agent_number_of(pair.first),
                         beespace::c::agent_number_of(pair.second), pair.gap_m, pair.clear_s};
  });
  findings[BEESPACE_NEAR_OBSTACLE].write(given.near_obstacle, false, beespace::c::row_of_object);
  findings[BEESPACE_NEAR_FENCE].write(given.near_fence, false, beespace::c::row_of_object);
  findings[BEESPACE_INTRUDER_CONFLICTS].write(given.intruder_conflicts, false,
                                              beespace::c::row_of_object);
  commands.clear();
  for (const beespace::Command& command : given.commands) {
    commands.push_back(beespace::c::c_command_of(command));
  }
}

extern "C" {

beespace_guidance* beespace_guidance_create(void) {
  try {
    return new beespace_guidance;
  } catch (...) {
    return nullptr;
  }
}

void beespace_guidance_free(beespace_guidance* guidance) {
  delete guidance;
}

int64_t beespace_guidance_tick(const beespace_guidance* guidance) {
  return guidance == nullptr ? 0 : guidance->tick;
}

int64_t beespace_guidance_size(const beespace_guidance* guidance) {
  return guidance == nullptr ? 0 : static_cast<int64_t>(guidance->agents.size());
}

const int64_t* beespace_guidance_agents(const beespace_guidance* guidance) {
  return guidance == nullptr ? nullptr : guidance->agents.data();
}

const int32_t* beespace_guidance_contracts(const beespace_guidance* guidance) {
  return guidance == nullptr ? nullptr : guidance->contracts.data();
}

const int32_t* beespace_guidance_reasons(const beespace_guidance* guidance) {
  return guidance == nullptr ? nullptr : guidance->reasons.data();
}

const uint8_t* beespace_guidance_certified(const beespace_guidance* guidance) {
  return guidance == nullptr ? nullptr : guidance->certified.data();
}

const uint8_t* beespace_guidance_keeps_apart(const beespace_guidance* guidance) {
  return guidance == nullptr ? nullptr : guidance->keeps_apart.data();
}

const uint8_t* beespace_guidance_clear_of_intruders(const beespace_guidance* guidance) {
  return guidance == nullptr ? nullptr : guidance->clear_of_intruders.data();
}

const int32_t* beespace_guidance_kinds(const beespace_guidance* guidance) {
  return guidance == nullptr ? nullptr : guidance->kinds.data();
}

const uint8_t* beespace_guidance_commanded(const beespace_guidance* guidance) {
  return guidance == nullptr ? nullptr : guidance->commanded.data();
}

const int32_t* beespace_guidance_branches(const beespace_guidance* guidance) {
  return guidance == nullptr ? nullptr : guidance->branches.data();
}

const double* beespace_guidance_positions(const beespace_guidance* guidance) {
  return guidance == nullptr ? nullptr : guidance->positions.data();
}

const double* beespace_guidance_velocities(const beespace_guidance* guidance) {
  return guidance == nullptr ? nullptr : guidance->velocities.data();
}

const double* beespace_guidance_tubes_m(const beespace_guidance* guidance) {
  return guidance == nullptr ? nullptr : guidance->tubes_m.data();
}

const double* beespace_guidance_deviations_m(const beespace_guidance* guidance) {
  return guidance == nullptr ? nullptr : guidance->deviations_m.data();
}

int64_t beespace_guidance_command_count(const beespace_guidance* guidance) {
  return guidance == nullptr ? 0 : static_cast<int64_t>(guidance->commands.size());
}

const beespace_command* beespace_guidance_command(const beespace_guidance* guidance,
                                                  int64_t index) {
  if (index < 0 || index >= beespace_guidance_command_count(guidance)) return nullptr;
  return &guidance->commands[static_cast<std::size_t>(index)];
}

beespace_code beespace_guidance_findings(const beespace_guidance* guidance, int32_t what,
                                         beespace_findings* findings, beespace_error* error) {
  using beespace::c::invalid;
  return beespace::c::enter(error, [&]() -> beespace::Status {
    if (guidance == nullptr) return invalid("the pointer to the guidance is NULL", "guidance");
    return Findings::show(Findings::of(guidance->findings, what), findings);
  });
}

}  // extern "C"
