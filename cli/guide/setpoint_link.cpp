#include "cli/guide/setpoint_link.hpp"

#include "io/bytes/number_text.hpp"
#include "io/mavlink/setpoint_frame.hpp"

#include <cmath>
#include <optional>
#include <utility>
#include <variant>

namespace beespace::cli {
namespace {

// One system is one agent: "007" would be a second one of system 7.
std::optional<std::uint8_t> system_of(std::string_view id) {
  constexpr std::uint64_t kMost = 254;  // 255 is the planner
  const auto number = io::parse_whole(id);
  if (!number || *number == 0 || *number > kMost || id != std::to_string(*number)) {
    return std::nullopt;
  }
  return static_cast<std::uint8_t>(*number);
}

}  // namespace

Status SetpointLink::check(std::string_view id) {
  if (system_of(id)) return std::monostate{};
  return Error{
      ErrorCode::kInvalidArgument,
      "with --format mavlink the id of an agent is its system in MAVLink, 1 to 254 without "
      "zeros before it, and '" +
          std::string(id) + "' is none; name it so",
      {}};
}

Status SetpointLink::take(const io::FleetMessage& message, GuidedFleet& fleet, std::string& lines) {
  if (std::holds_alternative<io::JoinMessage>(message.content)) {
    if (Status fine = check(message.id); !fine) return fine;
  }
  // Where it is on its branch is known here alone, and was lost with the planner before.
  if (std::holds_alternative<io::AdoptMessage>(message.content)) {
    return Error{ErrorCode::kInvalidArgument,
                 "with --format mavlink agents are not adopted: this command flies their branches "
                 "itself; make sure where '" +
                     std::string(message.id) + "' is, let it leave, and it joins anew",
                 {}};
  }
  if (std::holds_alternative<io::LeaveMessage>(message.content)) {
    if (const auto agent = agents_.find(message.id); agent != agents_.end()) agents_.erase(agent);
  }
  const auto* const measured = std::get_if<io::MeasuredMessage>(&message.content);
  if (measured == nullptr) return fleet.take(message, lines);
  const auto agent = agents_.find(message.id);
  if (agent == agents_.end()) {
    return Error{ErrorCode::kInvalidArgument,
                 "agent '" + std::string(message.id) +
                     "' has got no setpoint yet; let it join, and report afterwards",
                 {}};
  }
  const Follower& follower = agent->second.follower;
  AgentReport report;
  report.held = follower.held();
  report.tick = measured->tick.value_or(follower.tick());
  report.after_s = measured->after_s;
  report.position = measured->position;
  report.velocity = measured->velocity;
  return fleet.take({message.id, report}, lines);
}

void SetpointLink::advance(Tick now) {
  for (auto& [id, agent] : agents_) agent.follower.advance(now);
}

Status SetpointLink::take_commands(Tick now, GuidedFleet& fleet, std::string& lines) {
  for (const beespace::Command& command : fleet.commands()) {
    const std::string& id = fleet.name(command.agent);
    const auto system = system_of(id);
    if (!system) continue;
    auto agent = agents_.find(id);
    if (agent == agents_.end()) {
      auto follower = Follower::make(command.agent, fleet.planned(command.agent), period_s_);
      if (!follower) return std::move(follower).error();
      follower->advance(now);
      agent = agents_.emplace(id, Agent{*std::move(follower), *system}).first;
    }
    const Acknowledgement ack = agent->second.follower.receive(command);
    if (Status taken = fleet.take({id, ack}, lines); !taken) return taken;
  }
  return std::monostate{};
}

Status SetpointLink::tell(Tick now, GuidedFleet& fleet, std::string& lines, std::string& frames) {
  if (Status taken = take_commands(now, fleet, lines); !taken) return taken;
  const double now_ms = 1000.0 * period_s_ * static_cast<double>(now);
  constexpr double kWrap = 4294967296.0;
  const double wrapped = now_ms - std::floor(now_ms / kWrap) * kWrap;
  for (const auto& [id, agent] : agents_) {
    if (agent.follower.held() == 0) continue;
    const Setpoint setpoint = agent.follower.setpoint(0.0);
    io::SetpointFrame frame;
    frame.sequence = sequence_++;
    frame.target_system = agent.system;
    frame.time_boot_ms = static_cast<std::uint32_t>(wrapped);
    frame.setpoint = setpoint.nominal;
    frame.setpoint.velocity.x += setpoint.correction.x;
    frame.setpoint.velocity.y += setpoint.correction.y;
    frame.setpoint.velocity.z += setpoint.correction.z;
    frame.velocity_only = velocity_only_;
    io::append_setpoint_frame(frames, frame);
  }
  return std::monostate{};
}

}  // namespace beespace::cli
