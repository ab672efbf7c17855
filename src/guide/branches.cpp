#include "guide/branches.hpp"

#include "fleet/check_command.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>

namespace beespace::guide {

namespace {

using fleet::after_last;

// Links of the past are forgotten so many at a time.
constexpr std::size_t kForgottenTogether = 16;

// How many ticks back nominal places are known, for reports that come late.
Tick history_of(const BranchOptions& options) {
  return 2 * Tick{options.command_delay} + 16;
}

Error cannot_adopt(AgentId agent, const std::string& why) {
  Error error{ErrorCode::kInvalidArgument, "agent " + std::to_string(agent) + " " + why, {}};
  error.location.array = "agents";
  error.location.record = agent;
  return error;
}

}  // namespace

Branches::Branches(const BranchOptions& options, Tick now)
    : options_(options),
      braking_(options.planned, options.period_s),
      now_(now),
      count_(options.earlier) {
  const auto ticks = static_cast<std::size_t>(history_of(options) + options.command_delay + 2);
  chain_.reserve(ticks + kMostLive + kForgottenTogether);
}

Branches Branches::rooted(const BranchOptions& options, const Point& place, Tick now) {
  Branches branches(options, now);
  branches.is_rooted_ = true;
  branches.trunk_.number = branch_number(options.epoch, ++branches.count_);
  branches.trunk_.starts = now - 1;
  branches.trunk_.states = {BranchState{{place, {}}, {}}};
  return branches;
}

Result<Branches> Branches::adopted(const BranchOptions& options, const StoredBranch& stored,
                                   Tick now) {
  const Command& branch = stored.branch;
  const AgentId agent = options.agent;
  if (stored.promised != options.epoch) {
    return cannot_adopt(agent, "has promised epoch " + std::to_string(stored.promised) +
                                   ", and this planner has epoch " + std::to_string(options.epoch) +
                                   "; ask it for its promise, and take the answer to that");
  }
  if (branch.number == 0) return cannot_adopt(agent, "is on no branch; let it join");
  Branches branches(options, now);
  if (branch.agent != agent || !fleet::can_be(branch, options.planned, branches.braking_)) {
    return cannot_adopt(agent,
                        "says that it is on a branch that cannot be one of it with its limits and "
                        "the period; give those with which it was guided");
  }
  if (epoch_of(branch.number) >= options.epoch) {
    return cannot_adopt(agent, "is on a branch of epoch " +
                                   std::to_string(epoch_of(branch.number)) +
                                   "; give this planner a greater one");
  }
  // An agent takes no branch before it begins.
  if (branch.starts > stored.tick) {
    return cannot_adopt(
        agent, "says at tick " + std::to_string(stored.tick) +
                   " that it is on a branch that begins at tick " + std::to_string(branch.starts) +
                   "; one of both is wrong: make sure where it is, and let it join");
  }
  const auto path = branch.path();
  branches.trunk_ = {branch.number, true, branch.starts, {path.begin(), path.end()}};
  branches.is_confirmed_ = true;
  return branches;
}

Tick Branches::oldest_kept() const {
  return now_ - history_of(options_);
}

std::optional<std::size_t> Branches::index_of(BranchNumber number) const {
  for (std::size_t index = chain_.size(); index > 0; --index) {
    if (chain_[index - 1].number == number) return index;
  }
  if (trunk_.number == number && !trunk_.states.empty()) return 0;
  return std::nullopt;
}

bool Branches::lives(BranchNumber number) const {
  const auto index = index_of(number);
  return index && is_live(*index);
}

bool Branches::knows(BranchNumber number) const {
  const auto count = static_cast<std::uint32_t>(number);
  return number == trunk_.number ||
         (epoch_of(number) == options_.epoch && count > 0 && count <= count_);
}

Heard Branches::status_of(BranchNumber number) const {
  if (number == 0) return Heard::kNone;
  if (lives(number)) return Heard::kLive;
  // What an earlier planner sent cannot be told from what none did.
  const bool may_be_earlier = epoch_of(number) > 0 && epoch_of(number) < options_.epoch;
  return knows(number) || may_be_earlier ? Heard::kOld : Heard::kNeverSent;
}

// --- paths -----------------------------------------------------------------------------------

BranchState Branches::state_of(const Link& link, Tick tick) const {
  return after_last(link.state, fleet::ticks_between(link.from, tick), braking_);
}

BranchState Branches::state_on(std::size_t index, Tick tick) const {
  while (index > 0 && chain_[index - 1].from > tick) --index;
  if (index > 0) return state_of(chain_[index - 1], tick);
  if (trunk_.states.empty()) return chain_.front().state;  // before the history
  return fleet::Path{trunk_.starts, trunk_.states}.at(tick, braking_);
}

std::optional<Mover> Branches::nominal_at(BranchNumber number, Tick tick, double after_s) const {
  const auto index = index_of(number);
  if (!index || tick < oldest_kept() || tick > fleet::kLargestTick) return std::nullopt;
  // A report is rarely later than its tick by some ticks; more than this is nonsense.
  constexpr double kMostTicks = 1e6;
  const double ticks = after_s > 0.0 ? std::floor(after_s / options_.period_s) : 0.0;
  if (!(ticks <= kMostTicks)) return std::nullopt;
  const Tick begin = tick + static_cast<Tick>(ticks);
  const double left_s = std::max(0.0, std::max(after_s, 0.0) - ticks * options_.period_s);
  return fleet::within_tick(state_on(*index, begin), state_on(*index, begin + 1), left_s,
                            options_.period_s)
      .nominal;
}

// --- time ------------------------------------------------------------------------------------

void Branches::begin(Tick now) {
  if (is_rooted_) trunk_.starts = now - 1;
  now_ = now;
}

void Branches::advance(Tick now) {
  now_ = now;
  forget_history();
}

void Branches::forget_history() {
  const Tick oldest = oldest_kept();
  // The trunk's states that have passed.
  auto& states = trunk_.states;
  const auto passed = [&] { return trunk_.starts < std::min(oldest, left_at(0)); };
  while (states.size() > 1 && passed()) {
    states.erase(states.begin());
    ++trunk_.starts;
  }
  if (!states.empty() && passed()) {
    const Tick to = std::min(oldest, left_at(0));
    states.front() = after_last(states.front(), fleet::ticks_between(trunk_.starts, to), braking_);
    trunk_.starts = to;
  }
  if (chain_.empty()) return;
  if (!trunk_.live && chain_.front().from <= oldest) states.clear();
  // Fallbacks that have gone on for long.
  const auto roll = [&](Link& link, Tick until) {
    const Tick to = std::min(oldest, until);
    if (link.from >= to) return;
    link.state = state_of(link, to);
    link.from = to;
  };
  roll(chain_.front(), left_at(1));
  roll(chain_.back(), kForEver);
  if (!states.empty()) return;
  std::size_t forgotten = 0;
  while (forgotten + 1 < chain_.size() && !chain_[forgotten].live &&
         chain_[forgotten + 1].from <= oldest) {
    ++forgotten;
  }
  if (forgotten < kForgottenTogether) return;
  chain_.erase(chain_.begin(), chain_.begin() + static_cast<std::ptrdiff_t>(forgotten));
}

// --- commands --------------------------------------------------------------------------------

void Branches::write_root(Command& command) const {
  command.agent = options_.agent;
  command.number = trunk_.number;
  command.starts = now_ - 1;
  command.state_count = static_cast<std::uint32_t>(options_.command_delay + 3);
  command.ancestor_count = 0;
  std::fill_n(command.states.begin(), command.state_count, trunk_.states.front());
}

void Branches::issue(const Velocity& next, const Velocity& correction, Command& command) {
  assert(!full() && (chain_.empty() || chain_.back().sent < now_));
  const Tick leaves = departs();
  write_ancestors(command);
  const Mover base = base_state(leaves);
  Link link;
  link.number = branch_number(options_.epoch, ++count_);
  link.sent = now_;
  link.departs = leaves;
  link.from = leaves + 1;
  link.state = {fleet::step_to(base, next, options_.period_s), correction};
  chain_.push_back(link);
  ++live_count_;
  command.agent = options_.agent;
  command.number = link.number;
  write_path(link.from, command);
}

// From a tick before now, for agents whose clocks are behind.
void Branches::write_path(Tick last, Command& command) const {
  Tick starts = now_ - 1;
  if (!trunk_.states.empty()) starts = std::max(starts, trunk_.starts);
  command.starts = starts;
  command.state_count = static_cast<std::uint32_t>(last - starts + 1);
  std::size_t index = chain_.size();
  for (Tick tick = last; tick >= starts; --tick) {
    while (index > 0 && chain_[index - 1].from > tick) --index;
    command.states[static_cast<std::size_t>(tick - starts)] = state_on(index, tick);
  }
}

// Of the branch that is about to be sent: the base, and all other live ones that have not departed
// from it, by the clock of an agent that is a tick behind.
void Branches::write_ancestors(Command& command) const {
  std::uint32_t count = 0;
  Tick leaves = departs();
  for (std::size_t index = chain_.size() + 1; index-- > 0 && leaves >= now_;) {
    if (is_live(index)) command.ancestors[count++] = {number_of(index), leaves};
    if (index > 0) leaves = chain_[index - 1].departs;
  }
  command.ancestor_count = count;
}

// --- what the agent says ---------------------------------------------------------------------

void Branches::drop(std::size_t index) {
  bool& live = index == 0 ? trunk_.live : chain_[index - 1].live;
  if (live) --live_count_;
  live = false;
}

void Branches::drop_older(std::size_t index) {
  while (index > 0) drop(--index);
}

// An agent that was on this branch at the tick has since gone over to none that departs, from what
// it was on, at the tick or before. The departures grow along the chain: so of all branches that it
// may be on, the newest one is left the latest.
void Branches::drop_what_cannot_be_reached(std::size_t index, Tick tick) {
  std::size_t newest_reached = index;
  for (std::size_t other = index + 1; other <= chain_.size(); ++other) {
    if (!is_live(other)) continue;
    if (left_at(newest_reached) > tick) {
      newest_reached = other;
    } else {
      drop(other);
    }
  }
  forget_after_base();
}

void Branches::forget_after_base() {
  while (!chain_.empty() && !chain_.back().live) chain_.pop_back();
}

// An agent that was on a branch once is on it or on a newer one: numbers grow.
Heard Branches::acknowledge(const Acknowledgement& acknowledgement) {
  const Heard heard = status_of(acknowledgement.number);
  if (heard != Heard::kLive || acknowledgement.reply != CommandReply::kTaken) return heard;
  is_confirmed_ = true;
  drop_older(*index_of(acknowledgement.number));
  return heard;
}

// A report of a branch that is not live is a late one, and says nothing new.
Heard Branches::report(BranchNumber held, Tick tick) {
  const Heard heard = status_of(held);
  if (heard != Heard::kLive) return heard;
  is_confirmed_ = true;
  const std::size_t index = *index_of(held);
  drop_older(index);
  drop_what_cannot_be_reached(index, tick);
  return heard;
}

// --- the claim -------------------------------------------------------------------------------

// Few points are enough. With p and v of the state at tick T, the Bezier control points of the tick
// are p(T), m(T) = p(T) + v(T) dt/2 and p(T+1). As p(T+1) = m(T) + v(T+1) dt/2, each place at a
// tick between two others is the middle between m(T) and m(T+1), and needs not be given. While an
// agent brakes, all of them lie on one line; and from the last state on, on the segment to its
// latest stop, which begins at m of the tick before.
//
// So one point is given for each link: the latest stop where it is live, or the m at which the next
// one leaves it.
void Branches::append_places(Tick from, std::vector<Point>& places) const {
  std::size_t unseen = live_count_;
  for (std::size_t index = chain_.size(); index > 0; --index) {
    append_link(index, from, places);
    if (is_live(index)) --unseen;
    if (unseen == 0 && chain_[index - 1].from <= from) return;
  }
  append_trunk(from, places);
}

void Branches::append_link(std::size_t index, Tick from, std::vector<Point>& places) const {
  const Link& link = chain_[index - 1];
  const Tick left = left_at(index);
  if (!link.live && left < from) return;
  const bool has_begun = link.from <= from;
  const Mover first = has_begun ? state_of(link, from).nominal : link.state.nominal;
  if (has_begun) places.push_back(first.position);
  if (link.live) {
    places.push_back(fleet::latest_stop(first, braking_));
  } else {
    places.push_back(fleet::middle_of_tick(state_of(link, left).nominal, options_.period_s));
  }
}

void Branches::append_trunk(Tick from, std::vector<Point>& places) const {
  const Tick left = trunk_.live ? kForEver : left_at(0);
  if (trunk_.states.empty() || left < from) return;
  const fleet::Path path{trunk_.starts, trunk_.states};
  const Tick last = path.last_tick();
  places.push_back(path.at(from, braking_).nominal.position);
  const auto append_middle = [&](Tick tick) {
    const Mover state = path.at(tick, braking_).nominal;
    places.push_back(fleet::middle_of_tick(state, options_.period_s));
  };
  for (Tick tick = std::max(from, path.starts); tick < last && tick <= left; ++tick) {
    append_middle(tick);
  }
  if (trunk_.live) {
    const Mover end = path.at(std::max(from, last), braking_).nominal;
    places.push_back(fleet::latest_stop(end, braking_));
  } else if (left >= last) {
    append_middle(left);
  }
}

}  // namespace beespace::guide
