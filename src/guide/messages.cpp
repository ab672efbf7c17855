// What a Guide is told: goals, reports, acknowledgements.
#include "guide/guide_state.hpp"
#include "motion/flush.hpp"
#include "motion/validate.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace beespace {

namespace {

std::optional<Error> check_report(const AgentReport& report) {
  const Mover mover = motion::flushed({report.position, report.velocity.value_or(Velocity{})});
  if (auto error = motion::check_mover(mover, report.agent)) return error;
  if (std::isfinite(report.after_s) && report.after_s >= 0.0) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "the report is from " + std::to_string(report.after_s) +
                   " s after its tick; give a finite time, zero or more",
               {}};
}

std::optional<Error> check_intruder(const Intruder& intruder, std::size_t index) {
  if (auto error = motion::check_mover(intruder.mover, index)) {
    error->message.insert(0, "intruder: ");
    error->location.array = "intruders";
    return error;
  }
  for (const double size :
       {intruder.radius_m, intruder.position_error_m, intruder.speed_error_mps}) {
    if (size >= 0.0 && motion::in_motion_domain(size)) continue;
    Error error{ErrorCode::kInvalidArgument,
                "intruder " + std::to_string(index) + " has " + std::to_string(size) +
                    " for its radius or an error; give finite ones, zero or more",
                {}};
    error.location.array = "intruders";
    error.location.record = index;
    return error;
  }
  return std::nullopt;
}

// "3.17": the 17th branch of the third epoch.
std::string branch_text(BranchNumber number) {
  return std::to_string(epoch_of(number)) + '.' +
         std::to_string(static_cast<std::uint32_t>(number));
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

std::size_t Guide::State::place_of(AgentId agent) const {
  const auto found =
      std::lower_bound(by_id_.begin(), by_id_.end(), agent,
                       [](const Place& place, AgentId sought) { return place.id < sought; });
  return static_cast<std::size_t>(found - by_id_.begin());
}

Guide::State::Member* Guide::State::find(AgentId agent) {
  const std::size_t place = place_of(agent);
  return is_at(place, agent) ? &members_[by_id_[place].index] : nullptr;
}
const Guide::State::Member* Guide::State::find(AgentId agent) const {
  const std::size_t place = place_of(agent);
  return is_at(place, agent) ? &members_[by_id_[place].index] : nullptr;
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

Status Guide::State::check_tick(Tick tick) {
  constexpr Tick kMost = 1'000'000'000'000'000'000;
  if (-kMost <= tick && tick <= kMost) return std::monostate{};
  return Error{
      ErrorCode::kInvalidArgument,
      "tick " + std::to_string(tick) + " is beyond 10^18; count ticks from a time that is nearer",
      {}};
}

Tick Guide::State::clock_ticks(const FleetFigures& figures) const {
  return static_cast<Tick>(std::ceil(figures.clock_error_s / options_.link.period_s));
}

bool Guide::State::is_ahead(const Member& member, const AgentReport& report, Tick next) const {
  const double stamp = static_cast<double>(report.tick) + report.after_s / options_.link.period_s;
  return stamp > static_cast<double>(next + clock_ticks(member.figures) + 1);
}

// A planner that was held up has not counted its own ticks: a report that seems to lie ahead waits
// until the next step tells the time.
Status Guide::State::take(const AgentReport& report) {
  Member* const member = find(report.agent);
  if (member == nullptr) return unknown_agent(report.agent);
  if (auto error = check_report(report)) return about(*std::move(error), report.agent);
  if (Status fine = check_tick(report.tick); !fine) {
    return about(std::move(fine).error(), report.agent);
  }
  AgentReport flushed = report;
  flushed.position = motion::flushed(report.position);
  if (now_ && !is_ahead(*member, flushed, *now_ + 1)) return hear(*member, flushed, *now_ + 1);
  if (!member->early || member->early->tick <= report.tick) member->early = flushed;
  return std::monostate{};
}

// What a report says is used only where it can be true. What cannot names the agent, and is an
// error of the call: nothing else of it is believed.
Status Guide::State::hear(Member& member, const AgentReport& report, Tick next) {
  // Of another life, and come late: it names no agent.
  const bool is_earlier = report.tick <= member.since;
  if (report.held == 0) {
    // Made before it took its root, and come later: old news.
    const bool is_old = is_earlier ||
                        (member.taken.number != 0 && report.tick <= member.taken.tick) ||
                        (member.last && report.tick <= member.last->tick);
    if (!member.branches.awaits_root() && !is_old) member.monitor.name(ContractReason::kNoBranch);
    return std::monostate{};
  }
  if (!member.branches.knows(report.held)) {
    if (!is_earlier) member.monitor.name(ContractReason::kNoBranch);
    return about({ErrorCode::kInvalidArgument,
                  "agent " + std::to_string(report.agent) + " says that it is on branch " +
                      branch_text(report.held) + ", which was never sent to it",
                  {}},
                 report.agent);
  }
  // Its branches only grow newer. If it is on an older one than it took, it is not the same agent
  // any more, or its acknowledgement was forged: branches on which it may be have been ruled out.
  if (report.held < member.taken.number && report.tick > member.taken.tick) {
    member.monitor.name(ContractReason::kNoBranch);
    return about({ErrorCode::kInvalidArgument,
                  "agent " + std::to_string(report.agent) + " says that it is on branch " +
                      branch_text(report.held) + ", after it acknowledged branch " +
                      branch_text(member.taken.number) + "; let it leave and join anew",
                  {}},
                 report.agent);
  }
  if (is_earlier && !member.branches.lives(report.held)) return std::monostate{};
  member.heard = std::max(member.heard, next);
  // Where it should be, before what it tells rules branches out.
  const auto nominal = member.branches.nominal_at(report.held, report.tick, report.after_s);
  member.branches.report(report.held, report.tick);
  const auto& last = member.last;
  const bool is_newer = !last || report.tick > last->tick ||
                        (report.tick == last->tick && report.after_s > last->after_s);
  if (is_newer) member.last = report;
  if (!nominal) return std::monostate{};
  const double age_s = std::max(0.0, seconds(next - report.tick) - report.after_s);
  member.monitor.take(nominal->position, report, age_s);
  if (is_newer && member.is_on_ground_loop()) {
    member.corrections.measure(
        report.tick, report.after_s,
        core::vector_of(report.position) - core::vector_of(nominal->position));
  }
  return std::monostate{};
}

Status Guide::State::take(const Acknowledgement& acknowledgement) {
  const AgentId agent = acknowledgement.agent;
  Member* const member = find(agent);
  if (member == nullptr) return unknown_agent(agent);
  if (Status fine = check_tick(acknowledgement.tick); !fine) {
    return about(std::move(fine).error(), agent);
  }
  if (!member->branches.knows(acknowledgement.number)) {
    return about({ErrorCode::kInvalidArgument,
                  "agent " + std::to_string(agent) + " acknowledges branch " +
                      branch_text(acknowledgement.number) + ", which was never sent to it",
                  {}},
                 agent);
  }
  if (acknowledgement.reply == CommandReply::kNoBranch) {
    // Before it has its root it is on none; nor was it in another life.
    const bool is_earlier = acknowledgement.tick <= member->since;
    if (!member->branches.awaits_root() && !is_earlier) {
      member->monitor.name(ContractReason::kNoBranch);
    }
    return std::monostate{};
  }
  if (acknowledgement.reply == CommandReply::kTaken &&
      acknowledgement.number > member->taken.number) {
    // By a clock that is no more ahead than it may be: later reports are held against it.
    const Tick latest = now_.value_or(acknowledgement.tick) + 1 + clock_ticks(member->figures);
    member->taken = {acknowledgement.number, std::min(acknowledgement.tick, latest)};
  }
  member->branches.acknowledge(acknowledgement);
  if (now_) member->heard = std::max(member->heard, *now_ + 1);
  return std::monostate{};
}

// One that cannot be used may be anywhere; it must not stop the others from being given way to.
Status Guide::State::set_intruders(std::span<const Intruder> intruders) {
  intruders_.clear();
  intruder_numbers_.clear();
  intruders_at_.reset();
  intruder_anywhere_ = false;
  Status status = std::monostate{};
  for (std::size_t index = 0; index < intruders.size(); ++index) {
    auto error = check_intruder(intruders[index], index);
    if (!error) {
      intruders_.push_back(intruders[index]);
      intruder_numbers_.push_back(index);
      continue;
    }
    if (!intruder_anywhere_) status = *std::move(error);
    intruder_anywhere_ = true;
  }
  return status;
}

}  // namespace beespace
