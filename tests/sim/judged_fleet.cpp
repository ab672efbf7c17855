#include "tests/sim/judged_fleet.hpp"

#include "sim/fleet_loop.hpp"

#include <algorithm>
#include <sstream>

namespace beespace::sim {

namespace {

// Of the check itself, in long doubles.
constexpr double kRounding = 1e-9;

class Judge {
 public:
  explicit Judge(JudgedFleet& judged) : judged_(judged) {}

  // A kind of fault once.
  template <class... Parts>
  void note(bool& noted, int tick, const Parts&... parts) {
    if (std::exchange(noted, true)) return;
    std::ostringstream sentence;
    sentence.precision(17);
    sentence << "tick " << tick << ": ";
    (sentence << ... << parts);
    judged_.broken.push_back(sentence.str());
  }

  void look(const FleetLoop& loop, int tick) {
    const FleetTally& tally = loop.tally();
    if (tally.losses > 0) {
      note(lost_, tick, "two that keep their contracts were too close, closest ",
           loop.verdict().closest_m.value_or(0.0), " m");
    }
    if (tally.false_namings > 0) note(named_, tick, "an agent was named that keeps its figures");
    if (tally.refused_messages > 0) note(refused_, tick, "a message was refused");
    if (loop.verdict().heights_left > 0) note(height_, tick, "an agent left its plane");
    if (loop.verdict().fence_losses > 0 && loop.options().weak_share == 0.0) {
      note(fence_, tick, "an agent came too close to a fence");
    }
    for (const std::size_t index : loop.joined()) {
      const FleetAgent& agent = loop.agents()[index];
      const double off_m = agent.truth->deviation_m();
      if (!agent.weak && off_m > agent.tube_m * (1.0 + kRounding) + 1e-11) {
        note(tube_, tick, "agent ", index, " is ", off_m, " m off, and its tube is ", agent.tube_m);
      }
    }
    look_at(loop.guidance(), tick);
  }

 private:
  void look_at(const Guidance& guidance, int tick) {
    const auto is_out = [](const AgentGuidance& told) { return told.contract == Contract::kOut; };
    out_ = out_ || std::any_of(guidance.agents.begin(), guidance.agents.end(), is_out);
    if (!out_ && !guidance.pairs.empty()) {
      note(pair_, tick, "agents ", guidance.pairs[0].first, " and ", guidance.pairs[0].second,
           " have no certificate, and all keep their contracts");
    }
    if (!guidance.near_fence.empty()) {
      note(near_, tick, "agent ", guidance.near_fence[0].agent, " may come too close to a fence");
    }
  }

  JudgedFleet& judged_;
  bool lost_ = false;
  bool named_ = false;
  bool refused_ = false;
  bool height_ = false;
  bool fence_ = false;
  bool tube_ = false;
  bool pair_ = false;
  bool near_ = false;
  bool out_ = false;
};

}  // namespace

JudgedFleet judge_fleet(const DrawnFleet& fleet) {
  JudgedFleet judged;
  const auto made = FleetLoop::make(fleet.mission, fleet.options);
  if (!made) {
    judged.broken.push_back("could not begin: " + made.error().message);
    return judged;
  }
  FleetLoop& loop = **made;
  Judge judge(judged);
  for (int tick = 0; tick < fleet.ticks; ++tick) {
    if (const Status done = loop.step(); !done) {
      judged.broken.push_back("tick " + std::to_string(tick) + ": " + done.error().message);
      break;
    }
    judge.look(loop, tick);
    judged.agent_ticks += loop.joined().size();
  }
  judged.agents = loop.joined().size();
  judged.arrived = loop.arrived();
  judged.named = loop.tally().named;
  return judged;
}

}  // namespace beespace::sim
