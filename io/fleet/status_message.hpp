// What a planner says of an agent in a tick: "status".
#pragma once

#include "io/fleet/fleet_fields.hpp"

#include <beespace/guide.hpp>

#include <string>
#include <string_view>

namespace beespace::io {

// "kept", "doubted", "out".
std::string_view name_of(Contract contract);
// "none", "deviation", ...
std::string_view name_of(ContractReason reason);

struct StatusMessage {
  Tick tick = 0;
  AgentGuidance told;  // without the agent and the kind of advice
};

// Appends the line with its end. `advice` is the name of the kind of advice.
void append_status(std::string& out, std::string_view id, std::string_view advice, Tick tick,
                   const AgentGuidance& told);

// The members behind 'event' and 'id'.
StatusMessage read_status(FleetFields& fields);

}  // namespace beespace::io
