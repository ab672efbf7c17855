// Numbers of agents: those of C have a sign, those of C++ have none.
#pragma once

#include <beespace/agent_id.hpp>
#include <beespace/result.hpp>

#include <cstdint>

namespace beespace::c {

// Every one of the one is one of the other, and what ascends goes on ascending.
constexpr AgentId agent_id_of(std::int64_t number) {
  return static_cast<AgentId>(number) ^ (AgentId{1} << 63);
}
constexpr std::int64_t agent_number_of(AgentId agent) {
  return static_cast<std::int64_t>(agent ^ (AgentId{1} << 63));
}

// An error of C++ about an agent, which has the number of the caller, as record and in words.
Error with_agent_number(Error error, AgentId agent);

}  // namespace beespace::c
