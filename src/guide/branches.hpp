// The branches that one agent can be on, as its planner knows them.
//
// A branch is *live* until it is ruled out by what the agent says, and by nothing else: neither by
// time nor by a refusal. New branches depart from the newest live one, the *base*. So all live ones
// lie along the path of the base: each departs from it, or is it.
//
// The rules, and why the agent is always on a live branch, are in docs/prevention.md. After the
// first few ticks nothing is allocated.
#pragma once

#include "fleet/nominal_path.hpp"

#include <beespace/advise.hpp>
#include <beespace/agent_id.hpp>
#include <beespace/command.hpp>
#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace beespace::guide {

// What is known of a branch that an agent names.
enum class Heard : std::uint8_t {
  kLive,       // the agent can be on it
  kOld,        // it was sent once, and has been ruled out: the message is late
  kNeverSent,  // there never was such a branch: the agent, or who speaks for it, is wrong
  kNone,       // it names none: it has lost its branch, or has not joined yet
};

// One agent, and who plans for it.
struct BranchOptions {
  AgentId agent = 0;
  FlightLimits planned;       // a finite acceleration
  double period_s = 0.1;      // a tick
  int command_delay = 1;      // 1 to 32
  std::uint32_t epoch = 1;    // of this planner
  std::uint32_t earlier = 0;  // how many branches of this epoch were sent to this agent before
};

class Branches {
 public:
  // So many live ones are held at most.
  static constexpr std::size_t kMostLive = 12;
  static_assert(kMostLive <= Command::kMostAncestors);

  // Of an agent that holds a place and joins: a root, which it does not know yet.
  static Branches rooted(const BranchOptions& options, const Point& place, Tick now);
  // Of an agent that another planner has guided, and that has promised the epoch of this one.
  static Result<Branches> adopted(const BranchOptions& options, const StoredBranch& stored,
                                  Tick now);

  // The first tick of the planner, which was not known before: a root begins with it.
  void begin(Tick now);
  // Sets the tick. It does not run backwards, but where an agent that was adopted before the first
  // tick has a clock that is ahead.
  void advance(Tick now);

  [[nodiscard]] Tick now() const { return now_; }
  [[nodiscard]] std::size_t live_count() const { return live_count_; }
  [[nodiscard]] BranchNumber newest() const {
    return chain_.empty() ? trunk_.number : chain_.back().number;
  }
  [[nodiscard]] bool lives(BranchNumber number) const;
  // Whether such a branch was sent to the agent in this epoch, live or not; or was adopted.
  [[nodiscard]] bool knows(BranchNumber number) const;
  // Whether nothing more can be sent until something is ruled out.
  [[nodiscard]] bool full() const {
    return live_count_ >= kMostLive || count_ == std::numeric_limits<std::uint32_t>::max();
  }
  [[nodiscard]] std::uint32_t epoch() const { return options_.epoch; }
  // How many branches of this epoch were sent to the agent (BranchOptions::earlier, for the next
  // time that it joins).
  [[nodiscard]] std::uint32_t count() const { return count_; }

  // Whether it is not known yet that the agent has taken its root: so it is sent once more.
  [[nodiscard]] bool awaits_root() const { return is_rooted_ && trunk_.live && !is_confirmed_; }
  // Writes the root once more.
  void write_root(Command& command) const;

  // The nominal state on the base, at a tick of the history or later.
  [[nodiscard]] Mover base_state(Tick tick) const { return state_on(chain_.size(), tick).nominal; }
  // The tick at which a command of now departs from the base.
  [[nodiscard]] Tick departs() const { return now_ + options_.command_delay; }
  // Whether the base does not have this velocity a tick after departs() anyway.
  [[nodiscard]] bool would_change(const Velocity& next) const {
    return next != base_state(departs() + 1).velocity;
  }
  // Adds a branch, and writes its command: it departs from the base, and has this velocity and
  // correction a tick later. Once a tick at most, and not where it is full().
  void issue(const Velocity& next, const Velocity& correction, Command& command);

  // What the agent says, in any order and any number of times.
  Heard acknowledge(const Acknowledgement& acknowledgement);
  Heard report(BranchNumber held, Tick tick);

  // Appends places whose convex hull holds all nominal places from a tick on, up to rounding. The
  // tick is not before the history.
  void append_places(Tick from, std::vector<Point>& places) const;

  // Where the agent would be, on a branch that is live, or that the base has left not long ago.
  // Nothing: that branch or time is not known any more.
  [[nodiscard]] std::optional<Mover> nominal_at(BranchNumber number, Tick tick,
                                                double after_s) const;

 private:
  // The first path: the root, or the branch that was adopted. Of its states those of the history
  // and later ones are kept; none: it is forgotten.
  struct Trunk {
    BranchNumber number = 0;
    bool live = true;
    Tick starts = 0;
    std::vector<BranchState> states;
  };
  // A branch that departs from the one before it in the chain, of which this is its own: one state,
  // and the fallback after it.
  struct Link {
    BranchNumber number = 0;
    Tick sent = 0;
    Tick departs = 0;  // from the one before it
    Tick from = 0;     // of the state: the tick after, or a later one of the fallback
    bool live = true;
    BranchState state;
  };
  static constexpr Tick kForEver = std::numeric_limits<Tick>::max();

  explicit Branches(const BranchOptions& options, Tick now);

  [[nodiscard]] Tick oldest_kept() const;
  // Up to which tick the next one follows the branch of an index. Index 0 is the trunk, and i the
  // (i - 1)th link.
  [[nodiscard]] Tick left_at(std::size_t index) const {
    return index < chain_.size() ? chain_[index].departs : kForEver;
  }
  [[nodiscard]] BranchNumber number_of(std::size_t index) const {
    return index == 0 ? trunk_.number : chain_[index - 1].number;
  }
  [[nodiscard]] bool is_live(std::size_t index) const {
    return index == 0 ? trunk_.live : chain_[index - 1].live;
  }
  [[nodiscard]] std::optional<std::size_t> index_of(BranchNumber number) const;
  [[nodiscard]] BranchState state_of(const Link& link, Tick tick) const;
  // Of the branch of an index, which may follow others until then.
  [[nodiscard]] BranchState state_on(std::size_t index, Tick tick) const;
  [[nodiscard]] Heard status_of(BranchNumber number) const;
  void drop(std::size_t index);
  void drop_older(std::size_t index);
  void drop_what_cannot_be_reached(std::size_t index, Tick tick);
  void forget_after_base();
  void forget_history();
  void write_path(Tick last, Command& command) const;
  void write_ancestors(Command& command) const;
  void append_link(std::size_t index, Tick from, std::vector<Point>& places) const;
  void append_trunk(Tick from, std::vector<Point>& places) const;

  BranchOptions options_;
  fleet::Braking braking_;
  Tick now_ = 0;
  std::uint32_t count_ = 0;
  std::size_t live_count_ = 1;
  bool is_rooted_ = false;
  bool is_confirmed_ = false;
  Trunk trunk_;
  std::vector<Link> chain_;  // the last one is the base
};

}  // namespace beespace::guide
