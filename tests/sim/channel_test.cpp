// The channel: what is lost, late, doubled and reordered, and that all bounds are kept.
#include "sim/channel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace beespace::sim {
namespace {

struct Numbered {
  std::size_t sender = 0;
  std::int64_t sent = 0;
};

constexpr std::size_t kSenders = 20;
constexpr std::int64_t kInstants = 5'000;

struct Come {
  Numbered message;
  std::int64_t at = 0;
};

// Each sender sends one message an instant.
std::vector<Come> all_that_come(const ChannelErrors& errors, std::uint64_t seed) {
  Channel<Numbered> channel(errors, seed);
  std::vector<Come> come;
  for (std::int64_t now = 0; now < kInstants + errors.most_latency; ++now) {
    for (std::size_t sender = 0; sender < kSenders && now < kInstants; ++sender) {
      channel.send(now, sender, {sender, now});
    }
    channel.deliver(now, [&](const Numbered& message) { come.push_back({message, now}); });
  }
  return come;
}

// How many of a sender are lost in a row at most.
std::int64_t longest_run(const std::vector<Come>& come) {
  std::int64_t longest = 0;
  for (std::size_t sender = 0; sender < kSenders; ++sender) {
    std::vector<std::int64_t> sent = {-1, kInstants};
    for (const Come& one : come) {
      if (one.message.sender == sender) sent.push_back(one.message.sent);
    }
    std::sort(sent.begin(), sent.end());
    for (std::size_t i = 0; i + 1 < sent.size(); ++i) {
      longest = std::max(longest, sent[i + 1] - sent[i] - 1);
    }
  }
  return longest;
}

TEST(Channel, WithoutErrorsDeliversAllAtOnceInOrder) {
  const auto come = all_that_come({}, 1);
  ASSERT_EQ(come.size(), kSenders * kInstants);
  for (std::size_t i = 0; i < come.size(); ++i) {
    EXPECT_EQ(come[i].message.sender, i % kSenders);
    EXPECT_EQ(come[i].at, come[i].message.sent);
  }
}

TEST(Channel, LosesTheShareThatItShouldInRunsOfAtMostSoMany) {
  for (const double loss : {0.01, 0.1, 0.3}) {
    ChannelErrors errors;
    errors.loss = loss;
    errors.longest_run = 8;
    const auto come = all_that_come(errors, 7);
    const double all = static_cast<double>(kSenders * kInstants);
    const double lost = 1.0 - static_cast<double>(come.size()) / all;
    EXPECT_NEAR(lost, loss, 0.1 * loss);
    EXPECT_LE(longest_run(come), 8);
    EXPECT_GE(longest_run(come), loss < 0.05 ? 4 : 8);
  }
}

TEST(Channel, RunsOfOneAreOfOne) {
  ChannelErrors errors;
  errors.loss = 0.3;
  errors.longest_run = 1;
  EXPECT_EQ(longest_run(all_that_come(errors, 3)), 1);
}

TEST(Channel, DelaysWithinBoundsDoublesAndReorders) {
  ChannelErrors errors;
  errors.least_latency = 2;
  errors.most_latency = 6;
  errors.duplicates = 0.2;
  const auto come = all_that_come(errors, 5);
  const double all = static_cast<double>(kSenders * kInstants);
  EXPECT_NEAR(static_cast<double>(come.size()) / all, 1.2, 0.01);
  std::vector<bool> seen(7, false);
  bool reordered = false;
  std::int64_t newest = 0;
  for (const Come& one : come) {
    const std::int64_t late = one.at - one.message.sent;
    ASSERT_GE(late, 2);
    ASSERT_LE(late, 6);
    seen[static_cast<std::size_t>(late)] = true;
    reordered = reordered || one.message.sent < newest;
    newest = std::max(newest, one.message.sent);
  }
  EXPECT_TRUE(reordered);
  EXPECT_EQ(std::count(seen.begin(), seen.end(), true), 5);
}

TEST(Channel, IsTheSameForTheSameSeed) {
  ChannelErrors errors{.most_latency = 3, .loss = 0.2, .duplicates = 0.1, .longest_run = 4};
  const auto first = all_that_come(errors, 11);
  const auto again = all_that_come(errors, 11);
  ASSERT_EQ(first.size(), again.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    ASSERT_EQ(first[i].message.sent, again[i].message.sent);
    ASSERT_EQ(first[i].at, again[i].at);
  }
  EXPECT_NE(first.size(), all_that_come(errors, 12).size());
}

}  // namespace
}  // namespace beespace::sim
