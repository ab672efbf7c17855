// What is behind beespace_events.
#pragma once

#include "c/door/result.hpp"

#include <beespace.h>
#include <beespace/agent_id.hpp>
#include <beespace/swarm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_events {
  beespace::c::Column<std::int32_t> kinds;
  beespace::c::Column<double> times_s;
  beespace::c::Column<std::int64_t> first;
  beespace::c::Column<std::int64_t> second;
  beespace::c::Column<double> distances_m;
  beespace::c::Column<double> closest_s;
  beespace::c::Column<double> since_s;
  beespace::c::Column<std::int64_t> left_out;
  beespace::c::Column<std::int32_t> bounds;

  void resize(std::size_t size);
};

namespace beespace::c {

// Ids of C have a sign, those of C++ have none. Every one of the one is one of the other, and what
// ascends goes on ascending.
constexpr AgentId agent_of(std::int64_t id) {
  return static_cast<AgentId>(id) ^ (AgentId{1} << 63);
}
constexpr std::int64_t id_of(AgentId agent) {
  return static_cast<std::int64_t>(agent ^ (AgentId{1} << 63));
}

void write_events(std::span<const SwarmEvent> from, beespace_events& into);

}  // namespace beespace::c
