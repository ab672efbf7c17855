// What a Guide is told: goals, reports, acknowledgements.
#include "guide/guide_state.hpp"
#include "motion/flush.hpp"
#include "motion/validate.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace beespace {

namespace {

using core::Vector3;

std::optional<Error> check_report(const AgentReport& report) {
  const Mover mover{report.position, report.velocity.value_or(Velocity{})};
  if (auto error = motion::check_mover(mover, report.agent)) return error;
  if (std::isfinite(report.after_s) && report.after_s >= 0.0) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "the report is from " + std::to_string(report.after_s) +
                   " s after its tick; give a finite time, zero or more",
               {}};
}

Error about(Error error, AgentId agent) {
  error.location.array = "agents";
  error.location.record = agent;
  return error;
}

}  // namespace

Error Guide::State::unknown_agent(AgentId agent) {
  return about({ErrorCode::kInvalidArgument,
                "agent " + std::to_string(agent) + " is not in the fleet; let it join first",
                {}},
               agent);
}

Guide::State::Member* Guide::State::find(AgentId agent) {
  const auto found = by_id_.find(agent);
  return found == by_id_.end() ? nullptr : &members_[found->second];
}
const Guide::State::Member* Guide::State::find(AgentId agent) const {
  const auto found = by_id_.find(agent);
  return found == by_id_.end() ? nullptr : &members_[found->second];
}

Status Guide::State::set_goal(AgentId agent, const Point& goal) {
  Member* const member = find(agent);
  if (member == nullptr) return unknown_agent(agent);
  if (auto error = motion::check_position(goal, agent)) return about(*std::move(error), agent);
  member->goal = motion::flushed(goal);
  return std::monostate{};
}

Status Guide::State::set_preferred(AgentId agent, const Velocity& velocity) {
  Member* const member = find(agent);
  if (member == nullptr) return unknown_agent(agent);
  if (auto error = motion::check_mover({{}, velocity}, agent)) {
    return about(*std::move(error), agent);
  }
  member->goal.reset();
  member->preferred = motion::flushed(velocity);
  return std::monostate{};
}

// What a report says is used only where it can be true. What cannot names the agent, and is an
// error of the call: nothing else of it is believed.
Status Guide::State::take(const AgentReport& report) {
  Member* const member = find(report.agent);
  if (member == nullptr) return unknown_agent(report.agent);
  if (auto error = check_report(report)) return about(*std::move(error), report.agent);
  const double clock_s = member->figures.clock_error_s;
  // Until the step that it comes before; and as far as its clock may be ahead.
  const auto ahead = static_cast<Tick>(std::ceil(clock_s / options_.link.period_s)) + 1;
  if (now_ && report.tick > *now_ + ahead) {
    member->monitor.name(ContractReason::kFuture);
    return about({ErrorCode::kInvalidArgument,
                  "the report of agent " + std::to_string(report.agent) + " is of tick " +
                      std::to_string(report.tick) + ", and the last step was of tick " +
                      std::to_string(*now_) + ": its clock is wrong, or that of the planner",
                  {}},
                 report.agent);
  }
  if (report.held == 0) {
    // Made before it took its root, and come later: old news.
    const bool is_old = (member->taken.number != 0 && report.tick <= member->taken.tick) ||
                        (member->last && report.tick <= member->last->tick);
    if (!member->branches.awaits_root() && !is_old) {
      member->monitor.name(ContractReason::kNoBranch);
    }
    return std::monostate{};
  }
  if (!member->branches.knows(report.held)) {
    member->monitor.name(ContractReason::kNoBranch);
    return about({ErrorCode::kInvalidArgument,
                  "agent " + std::to_string(report.agent) + " says that it is on branch " +
                      std::to_string(report.held) + ", which was never sent to it",
                  {}},
                 report.agent);
  }
  // Its branches only grow newer. If it is on an older one than it took, it is not the same agent
  // any more, or its acknowledgement was forged: branches on which it may be have been ruled out.
  if (report.held < member->taken.number && report.tick > member->taken.tick) {
    member->monitor.name(ContractReason::kNoBranch);
    return about({ErrorCode::kInvalidArgument,
                  "agent " + std::to_string(report.agent) + " says that it is on branch " +
                      std::to_string(report.held) + ", after it acknowledged branch " +
                      std::to_string(member->taken.number) + "; let it leave and join anew",
                  {}},
                 report.agent);
  }
  if (now_) member->heard = std::max(member->heard, *now_ + 1);
  // Where it should be, before what it tells rules branches out.
  const auto nominal = member->branches.nominal_at(report.held, report.tick, report.after_s);
  member->branches.report(report.held, report.tick);
  const auto& last = member->last;
  const bool is_newer = !last || report.tick > last->tick ||
                        (report.tick == last->tick && report.after_s > last->after_s);
  if (is_newer) member->last = report;
  if (!nominal) return std::monostate{};
  const Tick now = now_.value_or(report.tick) + 1;
  const double age_s = std::max(0.0, seconds(now - report.tick) - report.after_s);
  member->monitor.take(nominal->position, report, age_s);
  if (is_newer && member->is_on_ground_loop()) {
    member->corrections.measure(
        report.tick, report.after_s,
        core::vector_of(report.position) - core::vector_of(nominal->position));
  }
  return std::monostate{};
}

Status Guide::State::take(const Acknowledgement& acknowledgement) {
  const AgentId agent = acknowledgement.agent;
  Member* const member = find(agent);
  if (member == nullptr) return unknown_agent(agent);
  if (!member->branches.knows(acknowledgement.number)) {
    return about({ErrorCode::kInvalidArgument,
                  "agent " + std::to_string(agent) + " acknowledges branch " +
                      std::to_string(acknowledgement.number) + ", which was never sent to it",
                  {}},
                 agent);
  }
  if (acknowledgement.reply == CommandReply::kNoBranch) {
    member->monitor.name(ContractReason::kNoBranch);
    return std::monostate{};
  }
  if (acknowledgement.reply == CommandReply::kTaken &&
      acknowledgement.number > member->taken.number) {
    member->taken = {acknowledgement.number, acknowledgement.tick};
  }
  member->branches.acknowledge(acknowledgement);
  if (now_) member->heard = std::max(member->heard, *now_ + 1);
  return std::monostate{};
}

void Guide::State::set_intruders(std::span<const Intruder> intruders) {
  intruders_.assign(intruders.begin(), intruders.end());
  intruders_at_.reset();
}

}  // namespace beespace
