// What is said between a planner (`beespace guide`), its agents (`beespace follow`) and those who
// tell where to go: one object of JSON a line. Every field is explained in docs/fleet-messages.md.
//
// An id is a text, or a whole number, which is taken as its text. AgentId within the contents is 0
// where it was read, and not written: who reads the message knows which number the id has.
#pragma once

#include <beespace/command.hpp>
#include <beespace/guide.hpp>
#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace beespace::io {

// To a planner.
struct JoinMessage {
  JoinRequest request;
  // The agent's tick, where it asks itself: what comes late must not count as asked anew.
  std::optional<Tick> tick = {};
  bool only_asks = false;  // "may_join"
};
struct LeaveMessage {};
struct AdoptMessage {
  JoinRequest request;  // without a position
  StoredBranch stored;
  double period_s = 0.0;      // with which its branch is flown, and its fallback: a planner that
  double braking_mps2 = 0.0;  // has others must not take it over
};
struct ExpectMessage {
  std::vector<std::string> ids;
};
struct GoalMessage {
  Point position;
};
struct PreferredMessage {
  Velocity velocity;
};
struct IntrudersMessage {
  std::vector<Intruder> intruders;
};

// To either.
struct TickMessage {
  Tick tick = 0;
};

// To an agent.
struct CommandMessage {
  Command command;
  double period_s = 0.0;      // with which its path was planned,
  double braking_mps2 = 0.0;  // and its fallback: an agent that has others must not take it
};
struct HelloMessage {
  std::uint32_t epoch = 0;
};
struct JoinedMessage {
  bool joined = false;
  double tube_m = 0.0;  // of it
  std::vector<std::string> touches = {};
  std::vector<std::size_t> obstacles = {};
  std::vector<std::size_t> fences = {};
};
struct MeasuredMessage {
  std::optional<Tick> tick = {};  // none: that of the agent
  double after_s = 0.0;
  Point position;
  std::optional<Velocity> velocity = {};
};
struct LoseMessage {};

// What a planner tells whom it concerns, and is for no agent to act upon: "status", "ticked", ...
struct ToldMessage {};

using FleetContent = std::variant<JoinMessage, LeaveMessage, AdoptMessage, ExpectMessage,
                                  GoalMessage, PreferredMessage, AgentReport, Acknowledgement,
                                  IntrudersMessage, TickMessage, CommandMessage, HelloMessage,
                                  JoinedMessage, MeasuredMessage, LoseMessage, ToldMessage>;

struct FleetMessage {
  std::string_view id = {};  // whom it is about; empty where it is about the fleet
  FleetContent content = ToldMessage{};
};

// "3.17": the 17th branch of epoch 3. Nothing where the text is no such number.
std::string branch_text(BranchNumber number);
std::optional<BranchNumber> parse_branch(std::string_view text);

// "taken", "too_late", ...
std::string_view name_of(CommandReply reply);
std::optional<CommandReply> parse_reply(std::string_view text);

}  // namespace beespace::io
