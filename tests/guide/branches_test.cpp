#include "tests/guide/branches_helpers.hpp"

#include <beespace/follower.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace beespace::guide {
namespace {

TEST(Branches, BeginsWithARootThatIsSentUntilItIsTaken) {
  Branches branches = Branches::rooted(options(), kPlace, 10);
  EXPECT_EQ(branches.newest(), number(1));
  EXPECT_EQ(branches.live_count(), 1U);
  EXPECT_EQ(branches.base_state(13), (Mover{kPlace, {}}));
  Follower follower = *Follower::make(kAgent, kPlanned, kPeriod_s);
  Command root;
  for (Tick now = 10; now < 200; now += 50) {
    branches.advance(now);
    EXPECT_TRUE(branches.awaits_root());
    branches.write_root(root);
  }
  follower.advance(160);
  const Acknowledgement reply = follower.receive(root);
  EXPECT_EQ(reply.reply, CommandReply::kTaken);
  EXPECT_EQ(branches.acknowledge(reply), Heard::kLive);
  EXPECT_FALSE(branches.awaits_root());
}

TEST(Branches, AReportOfTheRootOrOfWhatFollowedItConfirmsIt) {
  for (const std::uint32_t held : {1U, 2U}) {
    Branches branches = Branches::rooted(options(), kPlace, 10);
    issue(branches);
    EXPECT_TRUE(branches.awaits_root());
    EXPECT_EQ(branches.report(number(held), 10), Heard::kLive);
    EXPECT_FALSE(branches.awaits_root());
  }
}

TEST(Branches, ACommandHasThePathFromTheTickBeforeNowAndAllAncestors) {
  Branches branches = Branches::rooted(options(), kPlace, 10);
  issue(branches, 0.5);
  branches.advance(11);
  const Command command = issue(branches, 1.0);
  EXPECT_EQ(command.agent, kAgent);
  EXPECT_EQ(command.number, number(3));
  EXPECT_EQ(command.starts, 10);
  ASSERT_EQ(command.state_count, 5U);
  const Mover departs = {{1.125, 2, 3}, {0.5, 0, 0}};
  EXPECT_EQ(command.states[2].nominal, (Mover{kPlace, {}}));
  EXPECT_EQ(command.states[3].nominal, departs);
  EXPECT_EQ(command.states[4].nominal, (Mover{{1.625, 2, 3}, {1.5, 0, 0}}));
  ASSERT_EQ(command.ancestor_count, 2U);
  EXPECT_EQ(command.ancestors[0], (Ancestor{number(2), 13}));
  EXPECT_EQ(command.ancestors[1], (Ancestor{number(1), 12}));
  branches.advance(13);
  const Command later = issue(branches);
  ASSERT_EQ(later.ancestor_count, 2U) << "12 has passed";
  EXPECT_EQ(later.ancestors[0], (Ancestor{number(3), 15}));
  EXPECT_EQ(later.ancestors[1], (Ancestor{number(2), 13})) << "for a clock that is a tick behind";
}

TEST(Branches, SaysWhetherACommandWouldChangeAnything) {
  Branches branches = Branches::rooted(options(), kPlace, 10);
  EXPECT_FALSE(branches.would_change({}));
  EXPECT_TRUE(branches.would_change({0.25, 0, 0}));
  Command command;
  branches.issue({1.0, 0, 0}, {}, command);
  branches.advance(11);
  EXPECT_FALSE(branches.would_change({})) << "it brakes anyway";
  EXPECT_TRUE(branches.would_change({0.5, 0, 0}));
  EXPECT_TRUE(branches.would_change({1.0, 0, 0}));
}

TEST(Branches, CarriesCorrectionsAndTheFallbackHasNone) {
  Branches branches = Branches::rooted(options(), kPlace, 10);
  Command command;
  branches.issue({}, {0.5, 0, 0}, command);
  EXPECT_EQ(command.path().back().correction, (Velocity{0.5, 0, 0}));
  branches.advance(12);
  branches.issue({}, {0.25, 0, 0}, command);
  EXPECT_EQ(command.starts, 11);
  EXPECT_EQ(command.states[2].correction, (Velocity{0.5, 0, 0})) << "at 13";
  EXPECT_EQ(command.states[3].correction, Velocity{}) << "at 14";
  EXPECT_EQ(command.states[4].correction, (Velocity{0.25, 0, 0}));
}

TEST(Branches, AnAcknowledgementDropsWhatIsOlder) {
  Branches branches = Branches::rooted(options(4), kPlace, 10);
  for (Tick now = 11; now < 14; ++now) {
    branches.advance(now);
    issue(branches);
  }
  EXPECT_EQ(branches.live_count(), 4U);
  EXPECT_EQ(branches.acknowledge(taken(number(2))), Heard::kLive);
  EXPECT_EQ(branches.live_count(), 3U);
  EXPECT_FALSE(branches.lives(number(1)));
  EXPECT_TRUE(branches.lives(number(2)) && branches.lives(number(3)) && branches.lives(number(4)));
  EXPECT_EQ(branches.acknowledge(taken(number(1))), Heard::kOld) << "it is late";
  EXPECT_EQ(branches.acknowledge(taken(number(5))), Heard::kNeverSent);
  EXPECT_EQ(branches.acknowledge(taken(number(1, 2))), Heard::kNeverSent);
  EXPECT_EQ(branches.acknowledge(taken(0)), Heard::kNone);
  EXPECT_EQ(branches.live_count(), 3U);
}

TEST(Branches, ARefusalDropsNothing) {
  Branches branches = Branches::rooted(options(), kPlace, 10);
  issue(branches);
  for (const CommandReply reply :
       {CommandReply::kOlder, CommandReply::kTooLate, CommandReply::kTooEarly,
        CommandReply::kNoAncestor, CommandReply::kNoBranch, CommandReply::kInvalid}) {
    EXPECT_EQ(branches.acknowledge({kAgent, number(2), reply, number(1), 99}), Heard::kLive);
    EXPECT_EQ(branches.live_count(), 2U);
  }
}

TEST(Branches, AReportDropsWhatCannotBeReached) {
  Branches branches = Branches::rooted(options(2), kPlace, 10);
  issue(branches);  // departs from 1 at 12
  branches.advance(11);
  issue(branches);  // from 2 at 13, from 1 at 12
  branches.advance(13);
  issue(branches);  // from 3 at 15, from 2 at 13
  const auto after = [&](std::uint32_t held, Tick tick) {
    Branches copy = branches;
    EXPECT_EQ(copy.report(number(held), tick), Heard::kLive);
    std::string live;
    for (std::uint32_t count = 1; count <= 4; ++count) {
      if (copy.lives(number(count))) live += std::to_string(count);
    }
    EXPECT_EQ(copy.live_count(), live.size());
    return live;
  };
  EXPECT_EQ(after(1, 11), "1234");
  EXPECT_EQ(after(1, 12), "1") << "it can take none of them any more";
  EXPECT_EQ(after(2, 12), "234");
  EXPECT_EQ(after(2, 13), "2");
  EXPECT_EQ(after(3, 14), "34");
  EXPECT_EQ(after(3, 15), "3");
  EXPECT_EQ(after(4, kLast), "4");
  EXPECT_EQ(after(1, std::numeric_limits<Tick>::min()), "1234");
}

TEST(Branches, ReportsOfOtherBranchesChangeNothing) {
  Branches branches = Branches::rooted(options(2), kPlace, 10);
  issue(branches);
  branches.acknowledge(taken(number(2)));
  EXPECT_EQ(branches.report(number(1), 50), Heard::kOld);
  EXPECT_EQ(branches.report(number(3), 50), Heard::kNeverSent);
  EXPECT_EQ(branches.report(number(1, 2), 50), Heard::kNeverSent);
  EXPECT_EQ(branches.report(0, 50), Heard::kNone);
  EXPECT_EQ(branches.live_count(), 1U);
  EXPECT_TRUE(branches.knows(number(1)) && branches.knows(number(2)));
  EXPECT_FALSE(branches.knows(number(3)) || branches.knows(number(0)));
}

// A base that the agent never got is given up as soon as it says so.
TEST(Branches, TheBaseIsTheNewestThatIsLeft) {
  Branches branches = Branches::rooted(options(1), kPlace, 10);
  issue(branches);
  branches.advance(14);
  EXPECT_EQ(branches.newest(), number(2));
  branches.report(number(1), 13);
  EXPECT_EQ(branches.newest(), number(1));
  EXPECT_EQ(branches.base_state(15), (Mover{kPlace, {}}));
  const Command command = issue(branches);
  EXPECT_EQ(command.number, number(3)) << "a number is used once";
  ASSERT_EQ(command.ancestor_count, 1U);
  EXPECT_EQ(command.ancestors[0], (Ancestor{number(1), 15}));
  EXPECT_EQ(branches.report(number(2), 14), Heard::kOld);
}

TEST(Branches, HoldsSoManyAndTimeDropsNone) {
  Branches branches = Branches::rooted(options(3), kPlace, 10);
  while (!branches.full()) {
    branches.advance(branches.now() + 1);
    issue(branches, 0.25);
  }
  EXPECT_EQ(branches.live_count(), Branches::kMostLive);
  const Tick sent = branches.now();
  branches.advance(sent + 500);
  EXPECT_EQ(branches.live_count(), Branches::kMostLive);
  EXPECT_EQ(branches.report(number(12), sent + 500), Heard::kLive);
  EXPECT_EQ(branches.live_count(), 1U);
  EXPECT_EQ(issue(branches).ancestor_count, 1U);
}

// The last number of an epoch is never passed.
TEST(Branches, IsFullWhereNoNumberIsLeft) {
  BranchOptions last = options();
  last.earlier = std::numeric_limits<std::uint32_t>::max() - 2;
  Branches branches = Branches::rooted(last, kPlace, 10);
  EXPECT_FALSE(branches.full());
  EXPECT_EQ(epoch_of(issue(branches).number), 1U);
  EXPECT_TRUE(branches.full());
}

TEST(Branches, AnAgentThatJoinsAgainGetsOtherNumbers) {
  BranchOptions again = options();
  again.earlier = 5;
  Branches branches = Branches::rooted(again, kPlace, 10);
  EXPECT_EQ(branches.newest(), number(6));
  EXPECT_EQ(branches.report(number(5), 10), Heard::kOld);
  EXPECT_TRUE(branches.awaits_root());
  EXPECT_EQ(branches.count(), 6U);
}

// --- adopted ---

TEST(Branches, AdoptsABranchAndLeavesItInItsMiddle) {
  Branches before = Branches::rooted(options(8), kPlace, 10);  // a planner with a longer delay
  Command command;
  before.issue({1.0, 0, 0}, {}, command);  // at 19
  StoredBranch stored{command, 2, 10};
  BranchOptions next = options(2);
  next.epoch = 2;
  auto adopted = Branches::adopted(next, stored, 11);
  ASSERT_TRUE(adopted) << adopted.error().message;
  Branches& branches = *adopted;
  EXPECT_FALSE(branches.awaits_root());
  EXPECT_EQ(branches.newest(), number(2));
  EXPECT_EQ(branches.base_state(19).velocity, (Velocity{1, 0, 0}));
  const Command first = issue(branches, -0.5);
  EXPECT_EQ(first.number, number(1, 2));
  ASSERT_EQ(first.ancestor_count, 1U);
  EXPECT_EQ(first.ancestors[0], (Ancestor{number(2), 13}));
  // Both go on from there, one forth and one back.
  double low = kPlace.x;
  double high = kPlace.x;
  for (const Point& place : places_from(branches, 11)) {
    low = std::min(low, place.x);
    high = std::max(high, place.x);
  }
  EXPECT_LT(low, kPlace.x - 0.1);
  EXPECT_GT(high, kPlace.x + 0.4);
  EXPECT_EQ(branches.report(number(1), 10), Heard::kOld) << "of the planner before";
  EXPECT_EQ(branches.acknowledge(taken(number(1, 2))), Heard::kLive);
  EXPECT_EQ(branches.live_count(), 1U);
  for (const Point& place : places_from(branches, 11)) EXPECT_LE(place.x, kPlace.x);
}

TEST(Branches, AdoptsOnlyWhatWasPromised) {
  Branches before = Branches::rooted(options(), kPlace, 10);
  const StoredBranch stored{issue(before), 2, 10};
  BranchOptions next = options();
  next.epoch = 2;
  ASSERT_TRUE(Branches::adopted(next, stored, 11));
  const auto says = [&](const BranchOptions& planner, const StoredBranch& answer,
                        const std::string& what) {
    const auto adopted = Branches::adopted(planner, answer, 11);
    ASSERT_FALSE(adopted) << what;
    EXPECT_EQ(adopted.error().code, ErrorCode::kInvalidArgument);
    EXPECT_EQ(adopted.error().location.record, kAgent);
    EXPECT_NE(adopted.error().message.find(what), std::string::npos) << adopted.error().message;
  };
  for (const std::uint32_t promised : {0U, 1U, 3U}) {
    StoredBranch other = stored;
    other.promised = promised;
    says(next, other, "has promised epoch " + std::to_string(promised));
  }
  StoredBranch none = stored;
  none.branch.number = 0;
  says(next, none, "on no branch");
  StoredBranch broken = stored;
  broken.branch.state_count = 99;
  says(next, broken, "cannot be one");
  StoredBranch newer = stored;
  newer.branch.number = number(1, 2);
  says(next, newer, "is on a branch of epoch 2");
  next.agent = 8;
  StoredBranch of_another = stored;
  const auto adopted = Branches::adopted(next, of_another, 11);
  EXPECT_FALSE(adopted);
}

// --- the history ---

TEST(Branches, KnowsNominalPlacesForLateReports) {
  const int delay = 3;
  Branches branches = Branches::rooted(options(delay), kPlace, 0);
  Follower follower = *Follower::make(kAgent, kPlanned, kPeriod_s);
  std::vector<std::pair<BranchNumber, Mover>> was;
  Command command;
  for (Tick now = 0; now < 200; ++now) {
    branches.advance(now);
    follower.advance(now);
    if (now == 0) {
      branches.write_root(command);
      branches.acknowledge(follower.receive(command));
    }
    command = issue(branches, now % 12 < 6 ? 0.5 : -0.5);
    if (now % 5 != 0) follower.receive(command);
    branches.report(follower.held(), now);
    was.emplace_back(follower.held(), follower.setpoint(0.125).nominal);
    for (Tick late = 0; late <= std::min<Tick>(now, 2 * delay + 16); ++late) {
      const auto& [held, nominal] = was[static_cast<std::size_t>(now - late)];
      const auto known = branches.nominal_at(held, now - late, 0.125);
      // A branch that the base never followed is forgotten.
      if (held != follower.held() && !known) continue;
      ASSERT_TRUE(known) << "tick " << now << ", " << late << " late";
      ASSERT_EQ(*known, nominal) << "tick " << now << ", " << late << " late";
    }
    ASSERT_EQ(branches.nominal_at(follower.held(), now, 0.125)->position,
              follower.setpoint(0.125).nominal.position);
  }
  EXPECT_FALSE(branches.nominal_at(follower.held(), 199 - 100, 0.0));
  EXPECT_FALSE(branches.nominal_at(number(9, 9), 199, 0.0));
  EXPECT_FALSE(branches.nominal_at(follower.held(), kLast, 0.0));
  EXPECT_FALSE(branches.nominal_at(follower.held(), std::numeric_limits<Tick>::min(), 0.0));
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(branches.nominal_at(follower.held(), 199, infinity));
  EXPECT_EQ(branches.nominal_at(follower.held(), 199, std::nan("")),
            branches.nominal_at(follower.held(), 199, 0.0));
  EXPECT_EQ(branches.nominal_at(follower.held(), 199, 2.25 * kPeriod_s),
            branches.nominal_at(follower.held(), 201, 0.25 * kPeriod_s));
}

}  // namespace
}  // namespace beespace::guide
