#include "cli/simulate/fleet_log_writer.hpp"

#include "cli/output/advice_words.hpp"
#include "io/fleet/fleet_writer.hpp"
#include "io/fleet/status_message.hpp"

namespace beespace::cli {

std::string FleetLogWriter::id_of(AgentId agent) const {
  return agent < names_.ids.size() ? names_.ids[agent] : std::to_string(agent);
}

void FleetLogWriter::add(const sim::FleetLoop& loop) {
  lines_.clear();
  const Guidance& guidance = loop.guidance();
  // All have the same limits.
  const double braking_mps2 = loop.tube().planned.max_acceleration_mps2;
  const double period_s = loop.options().link.period_s;
  for (const Command& command : guidance.commands) {
    io::append_message(lines_, id_of(command.agent),
                       io::CommandMessage{command, period_s, braking_mps2});
  }
  for (const AgentGuidance& told : guidance.agents) {
    io::append_status(lines_, id_of(told.agent), name_of(told.kind), guidance.tick, told);
  }
  output_.write(lines_);
}

}  // namespace beespace::cli
