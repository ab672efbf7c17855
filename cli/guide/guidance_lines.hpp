// What a planner tells those who watch the fleet, in each tick.
#pragma once

#include "cli/guide/agent_names.hpp"
#include "cli/guide/guide_request.hpp"

#include <beespace/guide.hpp>

#include <string>
#include <unordered_map>

namespace beespace::cli {

class GuidanceLines {
 public:
  explicit GuidanceLines(StatusLines wanted) : wanted_(wanted) {}

  // Appends "status", "pair", "near_obstacle", "near_fence", "intruder_conflict", and "ticked",
  // which ends them.
  void append(std::string& out, const Guidance& guidance, const AgentNames& names);
  void forget(AgentId agent) { told_.erase(agent); }

 private:
  struct Told {
    Contract contract = Contract::kKept;
    ContractReason reason = ContractReason::kNone;
    bool certified = false;
    bool keeps_apart = false;
    bool clear_of_intruders = false;

    friend bool operator==(const Told&, const Told&) = default;
  };

  [[nodiscard]] bool is_new(const AgentGuidance& agent);

  StatusLines wanted_;
  std::unordered_map<AgentId, Told> told_;
};

}  // namespace beespace::cli
