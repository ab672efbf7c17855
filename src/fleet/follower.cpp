#include <beespace/follower.hpp>

#include "fleet/check_command.hpp"
#include "fleet/nominal_path.hpp"

#include <algorithm>
#include <limits>
#include <string>

namespace beespace {

namespace {

using fleet::Braking;

// How far a clock that was set anew may be behind the one before the restart, in ticks: that one
// may have been a tick ahead, and this one a tick behind.
constexpr Tick kClockMayBeBack = 2;

Tick in_range(Tick tick) {
  return std::clamp(tick, -fleet::kLargestTick, fleet::kLargestTick);
}

// Roots alone begin from nothing: the agent holds a place.
bool is_hold(const Command& root) {
  const auto path = root.path();
  return std::all_of(path.begin(), path.end(),
                     [](const BranchState& state) { return fleet::stands(state.nominal); });
}

// Null: it is not listed.
const Ancestor* find_ancestor(const Command& command, BranchNumber number) {
  for (const Ancestor& ancestor : command.departs_from()) {
    if (ancestor.number == number) return &ancestor;
  }
  return nullptr;
}

}  // namespace

Result<Follower> Follower::make(AgentId agent, const FlightLimits& planned, double period_s) {
  if (auto error = fleet::check_planned(planned, period_s)) return *error;
  Follower follower;
  follower.agent_ = agent;
  follower.planned_ = planned;
  follower.period_s_ = period_s;
  return follower;
}

Status Follower::restore(const StoredBranch& stored) {
  const bool none = stored.branch.number == 0;
  if (!none && (stored.branch.agent != agent_ ||
                !fleet::can_be(stored.branch, planned_, Braking(planned_, period_s_)))) {
    return Error{ErrorCode::kInvalidArgument,
                 "what was stored is not a branch of agent " + std::to_string(agent_) +
                     " with its limits and period; let it join anew",
                 {.array = "agents"}};
  }
  stored_ = stored;
  if (none) stored_.branch = {};
  stored_.tick = in_range(stored.tick);
  if (!none) stored_.promised = std::max(stored.promised, epoch_of(stored.branch.number));
  now_ = at(stored_.tick);
  ticks_ = false;
  resumes_ = true;
  return std::monostate{};
}

void Follower::advance(Tick tick) {
  const Tick before = stored_.tick;
  stored_.tick = in_range(tick);
  if (ticks_ || resumes_) stored_.tick = std::max(stored_.tick, before);
  if (!ticks_) {
    takes_from_ = resumes_ ? stored_.tick + kClockMayBeBack : stored_.tick;
    ticks_ = true;
    resumes_ = false;
  }
  now_ = at(stored_.tick);
}

// Its state at a tick that is not before its own.
BranchState Follower::at(Tick tick) const {
  if (held() == 0) return {};
  const fleet::Path path = fleet::path_of(stored_.branch);
  return path.at(tick, Braking(planned_, period_s_));
}

CommandReply Follower::judge_root(const Command& root) const {
  if (held() != 0) return CommandReply::kNoAncestor;
  if (!is_hold(root)) return CommandReply::kInvalid;
  if (root.starts > tick()) return CommandReply::kTooEarly;
  // An old root that comes late must not be taken for a new one.
  if (tick() > fleet::path_of(root).last_tick()) return CommandReply::kTooLate;
  return CommandReply::kTaken;
}

CommandReply Follower::judge(const Command& command) const {
  const Braking braking(planned_, period_s_);
  if (command.agent != agent_ || !fleet::can_be(command, planned_, braking)) {
    return CommandReply::kInvalid;
  }
  if (command.number <= held() || epoch_of(command.number) < stored_.promised) {
    return CommandReply::kOlder;
  }
  if (!ticks_ || tick() < takes_from_) return CommandReply::kTooEarly;
  if (command.ancestor_count == 0) return judge_root(command);
  if (held() == 0) return CommandReply::kNoBranch;
  if (command.starts > tick()) return CommandReply::kTooEarly;
  const Ancestor* const ancestor = find_ancestor(command, held());
  if (ancestor == nullptr) return CommandReply::kNoAncestor;
  if (tick() >= ancestor->departs) return CommandReply::kTooLate;
  // Until then both lead the same way.
  const fleet::Path path = fleet::path_of(command);
  const bool same =
      fleet::nearly_same(path.at(tick(), braking).nominal, now_.nominal) &&
      fleet::nearly_same(path.at(tick() + 1, braking).nominal, at(tick() + 1).nominal);
  return same ? CommandReply::kTaken : CommandReply::kInvalid;
}

Acknowledgement Follower::receive(const Command& command) {
  const CommandReply reply = judge(command);
  if (reply == CommandReply::kTaken) {
    stored_.branch = command;
    stored_.promised = std::max(stored_.promised, epoch_of(command.number));
    now_ = at(tick());
  }
  return {agent_, command.number, reply, held(), tick()};
}

bool Follower::promise(std::uint32_t epoch) {
  if (epoch < stored_.promised) return false;
  stored_.promised = epoch;
  return true;
}

void Follower::lose() {
  // No root that is under way may be taken: the agent is not there.
  if (stored_.promised < std::numeric_limits<std::uint32_t>::max()) ++stored_.promised;
  stored_.branch = {};
  now_ = {};
}

Setpoint Follower::setpoint(double after_s) const {
  if (held() == 0) return {};
  const Braking braking(planned_, period_s_);
  const Tick last = fleet::path_of(stored_.branch).last_tick();
  const auto holds = [&](Tick tick, const BranchState& state) {
    return tick >= last && fleet::stands(state.nominal) && state.correction == Velocity{};
  };
  Tick tick = stored_.tick;
  BranchState from = now_;
  double left_s = after_s > 0.0 ? after_s : 0.0;  // zero where it is not a number
  while (left_s >= period_s_ && !holds(tick, from)) {
    ++tick;
    left_s -= period_s_;
    from = tick <= last ? at(tick) : fleet::after_last(from, 1, braking);
  }
  if (holds(tick, from)) return {from.nominal, from.correction, true};
  const BranchState next = tick < last ? at(tick + 1) : fleet::after_last(from, 1, braking);
  const BranchState state = fleet::within_tick(from, next, left_s, period_s_);
  return {state.nominal, state.correction, false};
}

}  // namespace beespace
