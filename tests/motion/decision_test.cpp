// Whether two movers come into conflict, against arithmetic that cannot round: on lattices, where
// very many are at the edge exactly; one ulp beside it; far out; and at both ends of the domain.
#include "tests/support/encounter_maker.hpp"
#include "tests/support/exact_motion_oracle.hpp"
#include "tests/support/rounds.hpp"

#include <beespace/closest_approach.hpp>

#include <gtest/gtest.h>

namespace beespace {
namespace {

using test::Encounter;
using test::EncounterMaker;
using test::ExactEncounter;
using test::rounds;

bool decided(const Encounter& e) {
  const Result<Approach> approach = closest_approach(e.first, e.second, e.options.approach());
  EXPECT_TRUE(approach.has_value()) << e << ": " << approach.error().message;
  return approach.has_value() && approach->conflict.has_value();
}

// How many of all were in conflict, and how many of them only when the threshold itself counts.
struct Tally {
  int conflicts = 0;
  int none = 0;
  int at_the_edge = 0;
};

class Decision : public testing::Test {
 protected:
  // Strict and inclusive, and seen from either of the two.
  void expect_exact(const Encounter& e) {
    bool strict = false;
    for (const bool inclusive : {false, true}) {
      const Encounter asked = e.inclusive(inclusive);
      const bool truly = ExactEncounter(e.first, e.second, asked.options).in_conflict();
      ASSERT_EQ(decided(asked), truly) << asked;
      ASSERT_EQ(decided(asked.swapped()), truly) << "swapped: " << asked;
      if (!inclusive) strict = truly;
      if (inclusive && truly && !strict) ++tally_.at_the_edge;
    }
    ++(strict ? tally_.conflicts : tally_.none);
  }

  void expect_at_least(int conflicts, int none, int at_the_edge) const {
    EXPECT_GE(tally_.conflicts, rounds(conflicts));
    EXPECT_GE(tally_.none, rounds(none));
    EXPECT_GE(tally_.at_the_edge, rounds(at_the_edge));
  }

  // A lattice encounter that is in conflict only inclusively.
  static Encounter at_the_edge(EncounterMaker& make) {
    for (;;) {
      const Encounter e = make.on_lattice();
      const auto truly = [&](bool inclusive) {
        return ExactEncounter(e.first, e.second, e.inclusive(inclusive).options).in_conflict();
      };
      if (truly(true) && !truly(false)) return e;
    }
  }

  Tally tally_;
};

TEST_F(Decision, IsExactOnALatticeOfSmallIntegers) {
  EncounterMaker make(1);
  for (int round = 0; round < rounds(60'000) && !HasFatalFailure(); ++round) {
    expect_exact(make.on_lattice());
  }
  expect_at_least(15'000, 15'000, 2000);
}

TEST_F(Decision, IsExactOneUlpBesideTheEdge) {
  EncounterMaker make(2);
  for (int round = 0; round < rounds(600) && !HasFatalFailure(); ++round) {
    const Encounter edge = at_the_edge(make);
    for (int times = 0; times < 20 && !HasFatalFailure(); ++times) {
      expect_exact(make.nudged(edge));
    }
  }
  expect_at_least(1400, 2000, 2000);
}

TEST_F(Decision, IsExactInAllUnitsThatTheDomainHas) {
  EncounterMaker make(3);
  for (int round = 0; round < rounds(6000) && !HasFatalFailure(); ++round) {
    expect_exact(make.rescaled(make.on_lattice()));
  }
  for (int round = 0; round < rounds(150) && !HasFatalFailure(); ++round) {
    const Encounter edge = make.rescaled(at_the_edge(make));
    expect_exact(edge);
    for (int times = 0; times < 10 && !HasFatalFailure(); ++times) {
      expect_exact(make.nudged(edge));
    }
  }
  expect_at_least(1800, 2000, 800);
}

// Where an ulp of a coordinate is 2^-23 m, and sums of squares have lost the lattice long ago.
TEST_F(Decision, IsExactABillionMetresFromTheOrigin) {
  EncounterMaker make(4);
  for (int round = 0; round < rounds(6000) && !HasFatalFailure(); ++round) {
    expect_exact(make.moved(make.on_lattice(), {1e9, -1e9, 1e9}));
  }
  for (int round = 0; round < rounds(150) && !HasFatalFailure(); ++round) {
    const Encounter edge = make.moved(at_the_edge(make), {-1e9, 1e9, 1e9});
    for (int times = 0; times < 10 && !HasFatalFailure(); ++times) {
      expect_exact(make.nudged(edge));
    }
  }
  expect_at_least(1700, 2000, 300);
}

TEST_F(Decision, IsExactForRandomDoubles) {
  EncounterMaker make(5);
  for (int round = 0; round < rounds(15'000) && !HasFatalFailure(); ++round) {
    expect_exact(make.ragged());
  }
  expect_at_least(3000, 3000, 0);
}

// What overflows or underflows in doubles is part of it: nothing of it may be believed.
TEST_F(Decision, IsExactWhereEveryNumberHasAMagnitudeOfItsOwn) {
  EncounterMaker make(6);
  for (int round = 0; round < rounds(6000) && !HasFatalFailure(); ++round) {
    expect_exact(make.of_any_magnitude());
  }
  expect_at_least(600, 2000, 0);
}

TEST_F(Decision, StopsAtTheHorizonExactly) {
  // Head-on at 2 m/s from 10 m: at 3 m after 3.5 s, and not before.
  const Mover still{{0, 0, 0}, {0, 0, 0}};
  const Mover coming{{10, 0, 0}, {-2, 0, 0}};
  const auto in_conflict = [&](double horizon, bool inclusive) {
    PredictOptions options;
    options.threshold_m = 3.0;
    options.horizon_s = horizon;
    options.inclusive = inclusive;
    return decided({still, coming, options});
  };
  EXPECT_FALSE(in_conflict(3.5, false));
  EXPECT_TRUE(in_conflict(3.5, true));
  EXPECT_TRUE(in_conflict(std::nextafter(3.5, 4.0), false));
  EXPECT_FALSE(in_conflict(std::nextafter(3.5, 3.0), true));
}

}  // namespace
}  // namespace beespace
