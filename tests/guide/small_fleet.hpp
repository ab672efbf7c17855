// A fleet in the room of a test: a Guide, a Follower for each agent, and a link that may lose.
//
// The truth is a place beside the nominal one, at an offset that a test sets. Distances of nominal
// places are worked out from the followers alone.
#pragma once

#include <beespace/command.hpp>
#include <beespace/follower.hpp>
#include <beespace/guide.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <random>
#include <vector>

namespace beespace {

inline GuideOptions small_options() {
  GuideOptions options;
  options.threshold_m = 5.0;
  options.link = {.period_s = 0.1, .command_delay = 2, .longest_loss = 4};
  options.limits = {10.0, 5.0};
  options.clearance_m = 1.0;
  return options;
}

// Bounds that leave a tube of about a metre.
inline FleetFigures some_figures() {
  FleetFigures figures;
  figures.report_error_m = 0.1;
  figures.report_age_s = 0.3;
  figures.sensing_error_m = 0.1;
  figures.loop_period_s = 0.02;
  figures.loop_delay_s = 0.02;
  figures.deviation_mps = 0.3;
  figures.correction_mps2 = 1.0;
  figures.correction_mps = 0.5;
  return figures;
}

class SmallFleet {
 public:
  explicit SmallFleet(const GuideOptions& options)
      : guide_(Guide::make(options).value()), options_(options) {}

  void join(AgentId id, const Point& place, double radius_m = 0.0) {
    const auto answer = guide_.join({.agent = id, .position = place, .radius_m = radius_m});
    ASSERT_TRUE(answer) << answer.error().message;
    ASSERT_TRUE(answer->joined) << id;
    followers_.emplace(
        id, Follower::make(id, guide_.tube(id).value().planned, options_.link.period_s).value());
  }

  // Loses each message with this probability, but no more than the link's figures say in a row.
  void lose(double probability, unsigned seed) {
    losses_ = probability;
    random_.seed(seed);
  }
  // Each agent is beside its nominal place by what this says.
  std::function<Point(AgentId, Tick)> offset = [](AgentId, Tick) { return Point{}; };
  // Those that neither hear nor speak.
  std::function<bool(AgentId, Tick)> silent = [](AgentId, Tick) { return false; };

  const Guidance& step() {
    ++now_;
    for (const Acknowledgement& reply : replies_) EXPECT_TRUE(guide_.take(reply));
    replies_.clear();
    for (auto& [id, follower] : followers_) {
      follower.advance(now_);
      if (follower.held() == 0 || silent(id, now_) || lost(id, 1)) continue;
      EXPECT_TRUE(guide_.take(report(id)));
    }
    EXPECT_TRUE(guide_.step(now_, guidance_));
    for (const Command& command : guidance_.commands) {
      if (silent(command.agent, now_) || lost(command.agent, 0)) continue;
      const Acknowledgement reply = followers_.at(command.agent).receive(command);
      if (!lost(command.agent, 2)) replies_.push_back(reply);
    }
    return guidance_;
  }

  [[nodiscard]] AgentReport report(AgentId id) const {
    const Follower& follower = followers_.at(id);
    const Mover nominal = follower.setpoint(0.0).nominal;
    const Point away = offset(id, now_);
    return {.agent = id,
            .held = follower.held(),
            .tick = now_,
            .position = {nominal.position.x + away.x, nominal.position.y + away.y,
                         nominal.position.z + away.z},
            .velocity = nominal.velocity};
  }

  // The least distance of two nominal places within the tick.
  [[nodiscard]] double closest_m() const {
    double closest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 4; ++k) {
      std::vector<Point> places;
      for (const auto& [id, follower] : followers_) {
        if (follower.held() == 0) continue;
        places.push_back(follower.setpoint(0.25 * k * options_.link.period_s).nominal.position);
      }
      for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          closest =
              std::min(closest, std::hypot(places[i].x - places[j].x, places[i].y - places[j].y,
                                           places[i].z - places[j].z));
        }
      }
    }
    return closest;
  }

  [[nodiscard]] const AgentGuidance& told(AgentId id) const {
    return *std::find_if(guidance_.agents.begin(), guidance_.agents.end(),
                         [&](const AgentGuidance& one) { return one.agent == id; });
  }
  [[nodiscard]] const Guidance& guidance() const { return guidance_; }
  [[nodiscard]] Guide& guide() { return guide_; }
  [[nodiscard]] Follower& follower(AgentId id) { return followers_.at(id); }
  [[nodiscard]] Point place(AgentId id) const {
    return followers_.at(id).setpoint(0.0).nominal.position;
  }
  [[nodiscard]] Tick now() const { return now_; }

 private:
  bool lost(AgentId id, int way) {
    int& run = runs_[{id, way}];
    const bool is_lost =
        std::uniform_real_distribution<>()(random_) < losses_ && run < options_.link.longest_loss;
    run = is_lost ? run + 1 : 0;
    return is_lost;
  }

  Guide guide_;
  GuideOptions options_;
  std::map<AgentId, Follower> followers_;
  std::vector<Acknowledgement> replies_;
  Guidance guidance_;
  Tick now_ = 0;
  double losses_ = 0.0;
  std::mt19937 random_{1};
  std::map<std::pair<AgentId, int>, int> runs_;
};

}  // namespace beespace
