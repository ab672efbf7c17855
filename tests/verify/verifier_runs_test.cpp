// How a Verifier goes on: after time that was not seen, and after a call that was stopped.
#include <beespace/verify.hpp>

#include <gtest/gtest.h>

#include <stop_token>
#include <vector>

namespace beespace {
namespace {

// Two that fly through each other between 0 s and 1 s.
const std::vector<Mover> kBefore = {{{0, 0, 0}, {10, 0, 0}}, {{10, 0, 0}, {-10, 0, 0}}};
const std::vector<Mover> kAfter = {{{10, 0, 0}, {10, 0, 0}}, {{0, 0, 0}, {-10, 0, 0}}};

TEST(VerifierRuns, WhatWasNotSeenIsNotChecked) {
  Verifier verifier({.threshold_m = 2.0, .max_speed_mps = 5.0});
  ASSERT_TRUE(verifier.add(0.0, kBefore));
  verifier.skip();
  ASSERT_TRUE(verifier.add(1.0, kAfter));
  EXPECT_EQ(verifier.verdict().steps, 0U);
  EXPECT_TRUE(verifier.verdict().holds());
  // What is seen later is, and what was found stays.
  ASSERT_TRUE(verifier.add(2.0, kBefore));
  EXPECT_EQ(verifier.verdict().steps, 1U);
  EXPECT_EQ(verifier.verdict().losses, 1U);
  EXPECT_EQ(verifier.verdict().breaches, 2U);
  verifier.skip();
  verifier.skip();
  ASSERT_TRUE(verifier.add(-5.0, std::vector{kBefore[0]}));  // times begin anew, with others
  EXPECT_EQ(verifier.verdict().losses, 1U);
  EXPECT_EQ(verifier.verdict().steps, 1U);
}

TEST(VerifierRuns, AStopOfOneCallIsNoneOfTheNext) {
  Verifier verifier({.threshold_m = 2.0});
  ASSERT_TRUE(verifier.add(0.0, kBefore));
  std::stop_source source;
  source.request_stop();
  const Status stopped = verifier.add(1.0, kAfter, {1, source.get_token()});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::kStopped);
  EXPECT_EQ(verifier.verdict().losses, 0U);
  ASSERT_TRUE(verifier.add(1.0, kAfter, 2));
  EXPECT_EQ(verifier.verdict().losses, 1U);
}

}  // namespace
}  // namespace beespace
