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

// An error of C++ that is about an agent, as record and in its words, with the caller's number of
// it.
Error with_agent_number(Error error, AgentId agent);

}  // namespace beespace::c
