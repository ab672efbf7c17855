#include "tests/guide/branch_model.hpp"

#include "fleet/nominal_path.hpp"
#include "guide/branches.hpp"

#include <beespace/command.hpp>
#include <beespace/follower.hpp>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace beespace::test {

namespace {

using guide::Branches;
using guide::BranchOptions;
using guide::Heard;

constexpr AgentId kAgent = 5;
constexpr double kPeriod_s = 1.0;
constexpr FlightLimits kPlanned{.max_speed_mps = 8.0, .max_acceleration_mps2 = 1.0};
constexpr Tick kFirstTick = 10;
constexpr double kRounding_m = 1e-12;
constexpr Point kPlace = {0.0, 0.0, 0.0};

// What was said by the agent about itself.
struct Said {
  Tick tick = 0;
  BranchNumber held = 0;
  friend bool operator==(const Said&, const Said&) = default;
  friend bool operator<(const Said& a, const Said& b) {
    return a.tick != b.tick ? a.tick < b.tick : a.held < b.held;
  }
};

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  [[nodiscard]] bool holds(const Interval& other) const {
    return other.low >= low - kRounding_m && other.high <= high + kRounding_m;
  }
};

template <class Value>
void insert_once(std::vector<Value>& sorted, const Value& value) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), value);
  if (at == sorted.end() || !(*at == value)) sorted.insert(at, value);
}

struct World {
  explicit World(const Follower& fresh) : agent(fresh) {}

  Follower agent;
  Tick now = kFirstTick;
  std::uint32_t epoch = 1;
  std::optional<Branches> planner;  // none: it has started anew, and has not adopted the agent
  std::vector<std::shared_ptr<const Command>> sent;
  std::vector<Said> reports;
  std::vector<BranchNumber> taken;  // and acknowledged
  std::vector<BranchNumber> refused;
  std::shared_ptr<const StoredBranch> stored;
  std::vector<std::shared_ptr<const StoredBranch>> answers;  // to promises
  Tick last_issue = 0;
  Tick takes_from = 0;
  int commands_left = 0;
  int roots_left = 0;
  int agent_starts_left = 0;
  int planner_starts_left = 0;
  int losses_left = 0;
  int rejoins_left = 0;
  Interval claimed;  // now
};

class Model {
 public:
  Model(const ModelBounds& bounds, Fault fault) : bounds_(bounds), fault_(fault) {}

  ModelResult check() {
    World world(*Follower::make(kAgent, kPlanned, kPeriod_s));
    world.planner = Branches::rooted(options(1), kPlace, kFirstTick);
    world.commands_left = bounds_.commands;
    world.roots_left = bounds_.knows_root ? 1 : 2;
    world.agent_starts_left = bounds_.agent_starts;
    world.planner_starts_left = bounds_.planner_starts;
    world.losses_left = bounds_.losses;
    world.rejoins_left = bounds_.rejoins;
    world.agent.advance(kFirstTick);
    world.takes_from = kFirstTick;
    store(world);
    if (bounds_.knows_root) {
      send_root(world);
      deliver(world, 0);
    }
    note_report(world);
    world.claimed = claim(world);
    visit(world);
    return std::move(result_);
  }

 private:
  [[nodiscard]] BranchOptions options(std::uint32_t epoch) const {
    return {kAgent, kPlanned, kPeriod_s, bounds_.command_delay, epoch, 0};
  }
  [[nodiscard]] Tick off() const { return bounds_.clock_is_off ? 1 : 0; }

  // --- the search ---

  // An event that is tried on a copy; where it changes the world, the search goes on from there.
  template <class Event>
  void attempt(const World& world, std::string label, const Event& event) {
    if (!result_.violation.empty()) return;
    World next = world;
    trace_.push_back(std::move(label));
    ++result_.events;
    extra_ = {};
    event(next);
    next.claimed = claim(next);
    check_claim(world, next);
    visit(next);
    trace_.pop_back();
  }

  void visit(const World& world) {
    if (!result_.violation.empty() || !seen_.insert(key_of(world)).second) return;
    ++result_.states;
    check_state(world);
    if (!result_.violation.empty()) return;
    if (world.planner) result_.most_live = std::max(result_.most_live, world.planner->live_count());
    check_progress(world);
    try_time(world);
    try_planner(world);
    try_channel(world);
    try_starts(world);
  }

  void try_time(const World& world) {
    if (world.now < kFirstTick + bounds_.ticks && world.agent.tick() >= world.now + 1 - off()) {
      attempt(world, "planner's tick", [&](World& w) { tick(w); });
    }
    for (Tick at = std::max(world.agent.tick() + 1, world.now - off()); at <= world.now + off();
         ++at) {
      attempt(world, "agent's tick " + std::to_string(at), [&](World& w) {
        w.agent.advance(at);
        note_report(w);
      });
    }
    // Without an error of the clock both tick together.
    if (!bounds_.clock_is_off && world.now < kFirstTick + bounds_.ticks) {
      attempt(world, "tick", [&](World& w) {
        tick(w);
        w.agent.advance(w.now);
        note_report(w);
      });
    }
  }

  void try_planner(const World& world) {
    if (!world.planner) return;
    if (world.roots_left > 0 && world.planner->awaits_root()) {
      attempt(world, "root", [&](World& w) { send_root(w); });
    }
    if (world.commands_left > 0 && world.last_issue < world.now) {
      attempt(world, "command", [&](World& w) { issue(w); });
    }
  }

  void try_channel(const World& world) {
    for (std::size_t i = 0; i < world.sent.size(); ++i) {
      attempt(world, "deliver " + shown(world.sent[i]->number), [&](World& w) { deliver(w, i); });
    }
    for (std::uint32_t epoch = 2; epoch <= world.epoch; ++epoch) {
      attempt(world, "promise " + std::to_string(epoch), [&](World& w) { promise(w, epoch); });
    }
    for (std::size_t i = 0; i < world.answers.size() && !world.planner; ++i) {
      attempt(world, "answer", [&](World& w) { adopt(w, *world.answers[i]); });
    }
    if (!world.planner) return;
    for (const BranchNumber number : world.taken) {
      attempt(world, "taken " + shown(number), [&](World& w) { hear_taken(w, number); });
    }
    for (const Said& said : world.reports) {
      attempt(world, "report " + shown(said.held) + " at " + std::to_string(said.tick),
              [&](World& w) { hear_report(w, said); });
    }
    for (const BranchNumber number : world.refused) {
      attempt(world, "refused " + shown(number), [&](World& w) { hear_refused(w, number); });
    }
  }

  void try_starts(const World& world) {
    if (world.agent_starts_left > 0) {
      for (Tick at = world.now - off(); at <= world.now + off(); ++at) {
        attempt(world, "agent starts anew at " + std::to_string(at),
                [&](World& w) { start_agent(w, at); });
      }
    }
    if (world.planner_starts_left > 0) {
      attempt(world, "planner starts anew", [&](World& w) {
        --w.planner_starts_left;
        ++w.epoch;
        w.planner.reset();
      });
    }
    if (world.losses_left > 0 && world.agent.held() != 0) {
      attempt(world, "agent loses its branch", [&](World& w) {
        --w.losses_left;
        w.agent.lose();
        store(w);
      });
    }
    // Once no root is under way that could still be taken.
    const auto is_over = [&](const auto& command) {
      return command->ancestor_count > 0 ||
             fleet::path_of(*command).last_tick() < world.now - off();
    };
    if (world.rejoins_left > 0 && world.planner &&
        std::all_of(world.sent.begin(), world.sent.end(), is_over)) {
      attempt(world, "agent joins anew", [&](World& w) { rejoin(w); });
    }
    if (fault_ == Fault::kAdoptsUnpromised && !world.planner) {
      attempt(world, "adopt", [&](World& w) { adopt(w, w.agent.stored()); });
    }
  }

  // --- events ---

  void tick(World& w) {
    ++w.now;
    if (!w.planner) return;
    w.planner->advance(w.now);
    if (fault_ != Fault::kClockDrops) return;
    for (const auto& command : w.sent) {
      if (command->ancestor_count == 0 || command->ancestors[0].departs > w.now) continue;
      w.planner->acknowledge({kAgent, command->number, CommandReply::kTaken, 0, w.now});
    }
  }

  void send_root(World& w) {
    --w.roots_left;
    const auto root = std::make_shared<Command>();
    w.planner->write_root(*root);
    w.sent.push_back(root);
  }

  // Up and down, by less than braking: so branches are told apart.
  void issue(World& w) {
    const double v = w.planner->base_state(w.planner->departs()).velocity.x;
    const Velocity next{w.planner->count() % 2 == 1 ? v + 1.0 : v - 0.5, 0.0, 0.0};
    if (!w.planner->would_change(next)) return;
    const auto command = std::make_shared<Command>();
    w.planner->issue(next, {}, *command);
    --w.commands_left;
    w.last_issue = w.now;
    if (fault_ == Fault::kNoAncestorTicks) {
      for (Ancestor& ancestor : command->ancestors) ancestor.departs = w.planner->departs();
    }
    w.sent.push_back(command);
    // The only new place: after it, the agent stops.
    const auto [p, last] = command->path().back().nominal;
    extra_ = fleet::latest_stop({p, last}, fleet::Braking(kPlanned, kPeriod_s)).x;
  }

  void deliver(World& w, std::size_t index) {
    Command command = *w.sent[index];
    if (fault_ == Fault::kRootsStay && command.ancestor_count == 0) {
      command.starts = w.agent.tick();
    }
    if (fault_ == Fault::kTakesAtDeparture) {
      for (Ancestor& ancestor : command.ancestors) ++ancestor.departs;
    }
    const bool had_branch = w.agent.held() != 0;
    const Interval before = places_of_tick(w.agent, w.agent.tick());
    const Acknowledgement reply = w.agent.receive(command);
    if (reply.reply == CommandReply::kInvalid) return fail("a command that was sent is invalid");
    if (reply.reply != CommandReply::kTaken) {
      if (fault_ == Fault::kRefusalDrops && reply.reply != CommandReply::kOlder) {
        insert_once(w.refused, reply.number);
      }
      return;
    }
    ++result_.taken;
    const Interval after = places_of_tick(w.agent, w.agent.tick());
    if (had_branch && !(before.holds(after) && after.holds(before))) {
      return fail("the agent jumps as it takes a command");
    }
    if (fault_ != Fault::kStoresLate) store(w);
    insert_once(w.taken, reply.number);
    note_report(w);
  }

  void promise(World& w, std::uint32_t epoch) {
    if (!w.agent.promise(epoch)) return;
    if (fault_ != Fault::kForgetsPromise) store(w);
    const auto answer = std::make_shared<StoredBranch>(w.agent.stored());
    const auto same = [&](const auto& other) {
      return other->promised == answer->promised && other->branch.number == answer->branch.number;
    };
    if (std::none_of(w.answers.begin(), w.answers.end(), same)) w.answers.push_back(answer);
  }

  void adopt(World& w, StoredBranch answer) {
    if (fault_ == Fault::kAdoptsUnpromised || fault_ == Fault::kAdoptsOldAnswer) {
      answer.promised = w.epoch;
    }
    if (answer.branch.number == 0 && answer.promised == w.epoch) {
      w.planner = Branches::rooted(options(w.epoch), kPlace, w.now);
      ++w.roots_left;
      return;
    }
    auto adopted = Branches::adopted(options(w.epoch), answer, w.now);
    if (!adopted) return;
    w.planner = std::move(*adopted);
    w.last_issue = w.now - 1;
  }

  void hear_taken(World& w, BranchNumber number) {
    if (fault_ == Fault::kTakenDropsNewer) {
      w.planner->report(number, std::numeric_limits<Tick>::max());
      return;
    }
    const Heard heard =
        w.planner->acknowledge({kAgent, number, CommandReply::kTaken, number, w.now});
    if (heard == Heard::kNeverSent) fail("an acknowledgement of what was sent is not known");
  }

  void hear_report(World& w, const Said& said) {
    const Tick tick = fault_ == Fault::kLateReportIsOfNow ? w.now : said.tick;
    if (w.planner->report(said.held, tick) == Heard::kNeverSent) {
      fail("a branch that was sent is not known");
    }
  }

  // Only with a fault. What was refused is then dropped: the branch before it counts as held.
  void hear_refused(World& w, BranchNumber number) {
    if (!w.planner->lives(number)) return;
    for (const auto& command : w.sent) {
      if (command->number != number || command->ancestor_count == 0) continue;
      w.planner->report(command->ancestors[0].number, std::numeric_limits<Tick>::max());
    }
  }

  void start_agent(World& w, Tick at) {
    --w.agent_starts_left;
    w.agent = *Follower::make(kAgent, kPlanned, kPeriod_s);
    StoredBranch stored = *w.stored;
    if (fault_ == Fault::kTakesAtOnce) {
      stored.tick = std::min(stored.tick, at - 2);
      if (!w.agent.restore(stored)) return fail("what was stored is not taken");
      w.agent.advance(at - 2);
    } else if (!w.agent.restore(stored)) {
      return fail("what was stored is not taken");
    }
    w.agent.advance(at);
    w.takes_from = w.agent.tick() + 2;
    note_report(w);
  }

  void rejoin(World& w) {
    --w.rejoins_left;
    ++w.roots_left;
    BranchOptions rejoined = options(w.epoch);
    rejoined.earlier = w.planner->count();
    w.planner = Branches::rooted(rejoined, kPlace, w.now);
    w.agent = *Follower::make(kAgent, kPlanned, kPeriod_s);
    w.agent.advance(w.now);
    w.takes_from = w.now;
    store(w);
  }

  static void store(World& w) { w.stored = std::make_shared<StoredBranch>(w.agent.stored()); }

  // What it says now can be heard at any later time.
  static void note_report(World& w) {
    if (w.agent.held() != 0) insert_once(w.reports, Said{w.agent.tick(), w.agent.held()});
  }

  // --- what must be so ---

  void fail(const std::string& why) {
    if (!result_.violation.empty()) return;
    result_.violation = why + " after:";
    for (const std::string& event : trace_) result_.violation += " [" + event + "]";
  }

  [[nodiscard]] Interval claim(const World& world) const {
    Interval claim;
    if (!world.planner) return claim;
    std::vector<Point> places;
    world.planner->append_places(world.now - off(), places);
    for (const Point& place : places) claim.add(place.x);
    return claim;
  }

  // All places of a tick.
  static Interval places_of_tick(const Follower& agent, Tick tick) {
    Interval places;
    if (agent.held() == 0) return places;
    const fleet::Path path = fleet::path_of(agent.stored().branch);
    const fleet::Braking braking(kPlanned, kPeriod_s);
    const Mover state = path.at(tick, braking).nominal;
    places.add(state.position.x);
    places.add(fleet::middle_of_tick(state, kPeriod_s).x);
    places.add(path.at(tick + 1, braking).nominal.position.x);
    return places;
  }

  void check_state(const World& w) {
    if (!w.planner || w.agent.held() == 0) return;
    if (!w.planner->lives(w.agent.held())) {
      return fail("the agent is on branch " + shown(w.agent.held()) + ", which was dropped,");
    }
    // Wherever it comes to if it hears nothing any more.
    for (Tick tick = w.agent.tick(); tick < w.now + 12; ++tick) {
      if (!w.claimed.holds(places_of_tick(w.agent, tick))) fail("the agent leaves its claim");
    }
  }

  // A claim grows by what a command adds, and by nothing else.
  void check_claim(const World& before, const World& after) {
    if (!before.planner || !after.planner || before.epoch != after.epoch) return;
    if (before.rejoins_left != after.rejoins_left) return;
    Interval claimed = before.claimed;
    if (extra_) claimed.add(*extra_);
    if (!claimed.holds(after.claimed)) fail("the claim grows");
  }

  // Once both have heard each other, a new command is taken.
  void check_progress(const World& world) {
    if (fault_ != Fault::kNone || !world.planner || world.agent.held() == 0) return;
    if (world.agent.tick() < world.takes_from || world.last_issue >= world.now) return;
    // A clock that is ahead takes as much of the delay.
    if (world.agent.tick() >= world.now + bounds_.command_delay) return;
    Branches planner = *world.planner;
    Follower agent = world.agent;
    planner.report(agent.held(), agent.tick());
    Command command;
    planner.issue({planner.base_state(planner.departs()).velocity.x + 0.25, 0.0, 0.0}, {}, command);
    if (agent.tick() < world.now - 1 || agent.receive(command).reply != CommandReply::kTaken) {
      fail("a command is refused by an agent that was heard just before");
    }
  }

  // --- states that were seen ---

  static std::string shown(BranchNumber number) {
    return std::to_string(epoch_of(number)) + "." +
           std::to_string(static_cast<std::uint32_t>(number));
  }

  // All that the future depends on: the planner's state follows from what it sent, and from what of
  // that is live.
  static std::string key_of(const World& w) {
    std::string key;
    const auto add = [&](std::uint64_t value) {
      key.append(reinterpret_cast<const char*>(&value), 3);  // small numbers
    };
    const auto add_number = [&](BranchNumber number) {
      add((static_cast<std::uint64_t>(epoch_of(number)) << 8U) |
          static_cast<std::uint32_t>(number));
    };
    const auto add_tick = [&](Tick tick) { add(static_cast<std::uint64_t>(tick)); };
    add_tick(w.now);
    add(w.epoch | (w.planner ? 256U : 0U));
    add_tick(w.last_issue);
    add_tick(std::max(w.takes_from, w.agent.tick()));
    for (const int left : {w.roots_left, w.agent_starts_left, w.planner_starts_left, w.losses_left,
                           w.rejoins_left}) {
      add(static_cast<std::uint64_t>(left));
    }
    add_tick(w.agent.tick());
    add_number(w.agent.held());
    add(w.agent.stored().promised);
    add_tick(w.stored->tick);
    add_number(w.stored->branch.number);
    add(w.stored->promised);
    for (const auto& command : w.sent) {
      add_number(command->number);
      add_tick(command->starts);
      const bool live = w.planner && w.planner->lives(command->number);
      add((command->ancestor_count << 1U) | (live ? 1U : 0U));
      for (const Ancestor& ancestor : command->departs_from()) {
        add_number(ancestor.number);
        add_tick(ancestor.departs);
      }
    }
    add(0xFFFFFF);
    for (const Said& said : w.reports) {
      add_tick(said.tick);
      add_number(said.held);
    }
    add(0xFFFFFF);
    for (const BranchNumber number : w.taken) add_number(number);
    add(0xFFFFFF);
    for (const BranchNumber number : w.refused) add_number(number);
    add(0xFFFFFF);
    for (const auto& answer : w.answers) {
      add_number(answer->branch.number);
      add(answer->promised);
    }
    return key;
  }

  ModelBounds bounds_;
  Fault fault_;
  ModelResult result_;
  std::unordered_set<std::string> seen_;
  std::vector<std::string> trace_;
  std::optional<double> extra_;  // what the event adds to the claim
};

}  // namespace

ModelResult check_model(const ModelBounds& bounds, Fault fault) {
  return Model(bounds, fault).check();
}

}  // namespace beespace::test
