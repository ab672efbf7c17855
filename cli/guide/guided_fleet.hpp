// The fleet that a planner guides, by messages: what they say goes to the Guide, and what it says
// to whom it concerns. It knows no clock and no pipe.
#pragma once

#include "cli/guide/agent_names.hpp"
#include "cli/guide/fleet_store.hpp"
#include "cli/guide/guidance_lines.hpp"
#include "cli/guide/guide_request.hpp"
#include "io/fleet/fleet_message.hpp"

#include <beespace/guide.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::cli {

struct GuidedCounts {
  std::uint64_t ticks = 0;
  std::uint64_t commands = 0;
  std::uint64_t taken = 0;    // by agents
  std::uint64_t refused = 0;  // the same
};

class GuidedFleet {
 public:
  // `guide` is without agents, of the epoch of the store.
  GuidedFleet(const GuideRequest& request, Guide guide, FleetStore store);

  // Appends what there is to say at once. An error is about this message alone.
  Status take(const io::FleetMessage& message, std::string& out);

  // A list of intruders came and could not be read: none is clear of them until the next list, and
  // those of the last one are taken to fly on.
  void lose_intruders();

  // One tick. Errors: the tick does not come after the one before; or the store cannot be written,
  // kWriteFailed, and nothing may be said any more.
  Status step(Tick now, std::string& out);

  [[nodiscard]] const GuidedCounts& counts() const { return counts_; }
  [[nodiscard]] std::size_t size() const { return guide_.size(); }
  // Of the last step.
  [[nodiscard]] const std::vector<beespace::Command>& commands() const {
    return guidance_.commands;
  }
  // Of an agent that one of these commands is for.
  [[nodiscard]] const std::string& name(AgentId agent) const { return names_.name(agent); }
  [[nodiscard]] const FlightLimits& planned(AgentId agent) const {
    return members_.at(agent).planned;
  }
  // Of whom nothing was heard since the planner was started anew.
  [[nodiscard]] std::size_t missing() const { return missing_.size(); }

 private:
  // A planned acceleration, and what it was asked for with.
  struct Member {
    JoinRequest request;
    FlightLimits planned;
    double tube_m = 0.0;
    std::optional<Tick> taken = {};  // when it took its first command
  };

  Status take_content(std::string_view id, const io::JoinMessage& message, std::string& out);
  Status take_content(std::string_view id, const io::LeaveMessage& message, std::string& out);
  Status take_content(std::string_view id, const io::AdoptMessage& message, std::string& out);
  Status take_content(std::string_view id, const io::ExpectMessage& message, std::string& out);
  Status take_content(std::string_view id, const io::GoalMessage& message, std::string& out);
  Status take_content(std::string_view id, const io::PreferredMessage& message, std::string& out);
  Status take_content(std::string_view id, const AgentReport& report, std::string& out);
  Status take_content(std::string_view id, const Acknowledgement& ack, std::string& out);
  Status take_content(std::string_view id, const io::IntrudersMessage& message, std::string& out);
  template <class Other>
  Status take_content(std::string_view id, const Other& message, std::string& out);

  static Error in_its_words(Error error, std::string_view id, AgentId agent);
  [[nodiscard]] Result<AgentId> known(std::string_view id) const;
  Status check_plan(std::string_view id, const JoinRequest& request,
                    const io::AdoptMessage& message) const;
  Status join_again(std::string_view id, const io::JoinMessage& message, std::string& out);
  void answer(std::string_view id, const JoinAnswer& given, double tube_m, std::string& out) const;
  Status add(AgentId agent, const JoinRequest& request);
  void expect(const std::string& id);
  void say_hello(Tick now, std::string& out);
  void say_commands(std::string& out);

  Guide guide_;
  FleetStore store_;
  AgentNames names_;
  GuidanceLines lines_;
  double period_s_;
  LinkFigures link_;
  FleetFigures figures_;  // of each agent that has none of its own
  FlightLimits limits_;   // the same
  std::map<AgentId, Member> members_;
  std::map<AgentId, JoinRequest> missing_;  // who is in the fleet, and was not heard of since
  std::optional<Tick> hello_at_;
  std::vector<Intruder> intruders_;   // of the last list
  std::optional<Tick> intruders_at_;  // the first tick after that list; absent: not yet
  Tick stepped_ = 0;                  // the last tick
  Guidance guidance_;
  GuidedCounts counts_;
};

}  // namespace beespace::cli
