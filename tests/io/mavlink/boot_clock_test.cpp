// The clock of a vehicle beside that of the log: true times are known here, and what messages took.
#include "io/mavlink/boot_clock.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::int64_t kFirst_us = 1'714'564'800'000'000;

struct TrueMessage {
  SentMessage message;
  double true_s;
};

struct Flown {
  double lasts_s = 120.0;
  double every_s = 0.25;
  double up_s = 100.0;  // since when the vehicle was started, as the log begins
  std::function<double(double true_s)> boot_s = {};
  std::function<double(double true_s)> takes_s = {};
};

// In the order in which they come.
std::vector<TrueMessage> messages_of(const Flown& flown) {
  std::vector<TrueMessage> messages;
  for (int k = 0; k * flown.every_s < flown.lasts_s; ++k) {
    const double true_s = k * flown.every_s;
    const double boot_s = flown.boot_s ? flown.boot_s(true_s) : flown.up_s + true_s;
    const double takes_s = flown.takes_s ? flown.takes_s(true_s) : 0.05;
    messages.push_back(
        {{1000 * std::llround(1e3 * boot_s), kFirst_us + std::llround(1e6 * (true_s + takes_s))},
         true_s});
  }
  std::stable_sort(messages.begin(), messages.end(),
                   [](const TrueMessage& a, const TrueMessage& b) {
                     return a.message.came_us < b.message.came_us;
                   });
  return messages;
}

std::vector<SentMessage> only(const std::vector<TrueMessage>& messages) {
  std::vector<SentMessage> all;
  for (const TrueMessage& message : messages) all.push_back(message.message);
  return all;
}

// How far the times are from the true ones, at most.
double worst_s(const std::vector<TrueMessage>& messages, const std::vector<std::int64_t>& at_us) {
  double worst = 0.0;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    const double at_s = static_cast<double>(at_us[i] - kFirst_us) / 1e6;
    worst = std::max(worst, std::abs(at_s - messages[i].true_s));
  }
  return worst;
}

std::vector<std::int64_t> live_times(const std::vector<TrueMessage>& messages, BootClock& clock) {
  std::vector<std::int64_t> at_us;
  for (const TrueMessage& message : messages) at_us.push_back(clock.take(message.message));
  return at_us;
}

TEST(BootClocks, ALateMessageIsOfTheMomentWhenItWasSent) {
  Flown flown;
  flown.takes_s = [](double t) { return t == 50.0 ? 12.0 : t == 70.0 ? 3.0 : 0.05; };
  const auto messages = messages_of(flown);
  const SentTimes times = sent_times(only(messages));
  EXPECT_TRUE(times.believed);
  EXPECT_LT(worst_s(messages, times.at_us), 0.06);
  EXPECT_NEAR(static_cast<double>(times.latest_us) / 1e6, 11.95, 0.02);
  BootClock clock;
  EXPECT_LT(worst_s(messages, live_times(messages, clock)), 0.08);
  EXPECT_TRUE(clock.believed());
}

TEST(BootClocks, WhatMessagesTakeMayVaryAndClocksDrift) {
  for (const double drift : {0.0, 5e-5, -5e-5}) {
    std::mt19937 random(11);
    std::exponential_distribution<double> delay(5.0);
    Flown flown;
    flown.lasts_s = 3'600.0;
    flown.boot_s = [drift](double t) { return 100.0 + (1.0 + drift) * t; };
    flown.takes_s = [&](double) { return 0.02 + delay(random); };
    const auto messages = messages_of(flown);
    const SentTimes times = sent_times(only(messages));
    EXPECT_TRUE(times.believed) << drift;
    EXPECT_LT(worst_s(messages, times.at_us), 0.06) << drift;
    BootClock clock;
    const auto live = live_times(messages, clock);
    EXPECT_TRUE(clock.believed()) << drift;
    // None is later than it came; how fast a message can be is learnt on the way.
    for (std::size_t i = 0; i < messages.size(); ++i) {
      EXPECT_LE(live[i], messages[i].message.came_us);
      if (messages[i].true_s < 60.0) continue;
      EXPECT_NEAR(static_cast<double>(live[i] - kFirst_us) / 1e6, messages[i].true_s, 0.1);
    }
  }
}

TEST(BootClocks, AVehicleThatIsStartedAnewBeginsAnew) {
  for (const double up_s : {1.0, 5.0, 1'000.0}) {
    Flown flown;
    flown.boot_s = [up_s](double t) { return t < 60.0 ? up_s + t : t - 59.0; };
    flown.takes_s = [](double t) { return t == 80.0 ? 4.0 : 0.05; };
    const auto messages = messages_of(flown);
    const SentTimes times = sent_times(only(messages));
    EXPECT_TRUE(times.believed) << up_s;
    EXPECT_LT(worst_s(messages, times.at_us), 0.06) << up_s;
    BootClock clock;
    EXPECT_LT(worst_s(messages, live_times(messages, clock)), 0.08) << up_s;
  }
}

TEST(BootClocks, WhatDoesNotGoOnAsTheLogIsNoClock) {
  struct Case {
    const char* what;
    std::function<double(double)> boot_s;
  };
  for (const Case& wrong :
       {Case{"stands still", [](double) { return 123.456; }},
        Case{"a simulator at half the speed", [](double t) { return t / 2; }},
        Case{"at twice the speed", [](double t) { return 2.0 * t; }},
        Case{"a little slow", [](double t) { return 0.97 * t; }},
        Case{"another vehicle, in turn",
             [](double t) { return std::fmod(t, 0.5) < 0.1 ? 500.0 + t : 100.0 + t; }},
        Case{"another vehicle, that came later", [](double t) {
               return t > 100.0 && std::fmod(t, 0.5) < 0.1 ? 70.0 + t : 100.0 + t;
             }}}) {
    Flown flown;
    flown.boot_s = wrong.boot_s;
    const auto messages = messages_of(flown);
    EXPECT_FALSE(sent_times(only(messages)).believed) << wrong.what;
    BootClock clock;
    const auto live = live_times(messages, clock);
    // A clock that is fast says that each message was the fastest: as when they came.
    const bool as_they_came = live.back() == messages.back().message.came_us;
    EXPECT_TRUE(!clock.believed() || as_they_came) << wrong.what;
  }
}

TEST(BootClocks, TheSameByTwoLinksIsOfOneMoment) {
  Flown flown;
  auto messages = messages_of(flown);
  flown.takes_s = [](double) { return 0.8; };
  for (const TrueMessage& again : messages_of(flown)) messages.push_back(again);
  std::stable_sort(messages.begin(), messages.end(),
                   [](const TrueMessage& a, const TrueMessage& b) {
                     return a.message.came_us < b.message.came_us;
                   });
  const SentTimes times = sent_times(only(messages));
  EXPECT_TRUE(times.believed);
  EXPECT_LT(worst_s(messages, times.at_us), 0.06);
  BootClock clock;
  EXPECT_LT(worst_s(messages, live_times(messages, clock)), 0.08);
}

TEST(BootClocks, OneMessageIsOfWhenItCame) {
  EXPECT_EQ(sent_times({{5, kFirst_us}}).at_us, std::vector<std::int64_t>{kFirst_us});
  EXPECT_FALSE(sent_times({}).believed);
  BootClock clock;
  EXPECT_EQ(clock.take({5, kFirst_us}), kFirst_us);
}

}  // namespace
}  // namespace beespace::io
