// Guides and followers of C beside those of C++.
#pragma once

#include "tests/c/advice_scenes.hpp"

#include <beespace.h>
#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <memory>

namespace beespace::test {

struct FreeGuide {
  void operator()(beespace_guide* guide) const { beespace_guide_free(guide); }
  void operator()(beespace_guidance* guidance) const { beespace_guidance_free(guidance); }
  void operator()(beespace_follower* follower) const { beespace_follower_free(follower); }
};
template <class Handle>
using OwnedGuide = std::unique_ptr<Handle, FreeGuide>;

// The agent of C++ that has a number of C: the lowest number is 0.
inline AgentId cpp_agent(std::int64_t number) {
  return static_cast<AgentId>(number) + (AgentId{1} << 63U);
}

template <class Struct>
Struct sized() {
  Struct made{};
  made.struct_size = sizeof made;
  return made;
}

inline constexpr FleetFigures kFigures{.report_error_m = 0.1,
                                       .report_age_s = 0.3,
                                       .sensing_error_m = 0.1,
                                       .loop_period_s = 0.02,
                                       .loop_delay_s = 0.1,
                                       .deviation_mps = 0.3,
                                       .clock_error_s = 0.01,
                                       .correction_mps2 = 1.0,
                                       .correction_mps = 1.0};
inline constexpr LinkFigures kLink{.period_s = 0.1, .command_delay = 2, .longest_loss = 3};

inline beespace_fleet_figures c_figures() {
  auto figures = sized<beespace_fleet_figures>();
  figures.report_error_m = kFigures.report_error_m;
  figures.report_age_s = kFigures.report_age_s;
  figures.sensing_error_m = kFigures.sensing_error_m;
  figures.loop_period_s = kFigures.loop_period_s;
  figures.loop_delay_s = kFigures.loop_delay_s;
  figures.deviation_mps = kFigures.deviation_mps;
  figures.clock_error_s = kFigures.clock_error_s;
  figures.correction_mps2 = kFigures.correction_mps2;
  figures.correction_mps = kFigures.correction_mps;
  return figures;
}

inline beespace_link_figures c_link() {
  auto link = sized<beespace_link_figures>();
  link.command_delay = kLink.command_delay;  // the period is the default
  link.longest_loss = kLink.longest_loss;
  return link;
}

// Both sides of C and of C++.
class CGuide : public testing::Test {
 protected:
  CGuide() {
    options_.figures = &figures_;
    options_.link = &link_;
    options_.threshold_m = 1.5;
    options_.max_speed_mps = 6.0;
    options_.max_acceleration_mps2 = 4.0;
  }
  void make() {
    beespace_guide* made = nullptr;
    ASSERT_EQ(beespace_guide_create(&options_, &made, &error_), BEESPACE_OK) << error_.message;
    guide_.reset(made);
  }
  [[nodiscard]] static GuideOptions cpp_options() {
    GuideOptions options;
    options.threshold_m = 1.5;
    options.link = kLink;
    options.figures = kFigures;
    options.limits = {6.0, 4.0};
    return options;
  }
  void refuse_options(const char* place, beespace_code code = BEESPACE_INVALID_ARGUMENT) {
    beespace_guide* made = guide_.get();
    error_ = c_error();
    EXPECT_EQ(beespace_guide_create(&options_, &made, &error_), code);
    EXPECT_EQ(made, nullptr);
    EXPECT_STREQ(error_.place, place) << error_.message;
  }
  static beespace_join_request request(std::int64_t agent, const Point& place) {
    auto asked = sized<beespace_join_request>();
    asked.agent = agent;
    asked.position[0] = place.x;
    asked.position[1] = place.y;
    asked.position[2] = place.z;
    return asked;
  }
  bool join(std::int64_t agent, const Point& place) {
    const beespace_join_request asked = request(agent, place);
    answer_ = sized<beespace_join_answer>();
    EXPECT_EQ(beespace_guide_join(guide_.get(), &asked, &answer_, &error_), BEESPACE_OK)
        << error_.message;
    return answer_.joined == 1;
  }
  void step(std::int64_t tick) {
    ASSERT_EQ(beespace_guide_step(guide_.get(), tick, nullptr, guidance_.get(), &error_),
              BEESPACE_OK)
        << error_.message;
  }

  beespace_fleet_figures figures_ = c_figures();
  beespace_link_figures link_ = c_link();
  beespace_guide_options options_ = sized<beespace_guide_options>();
  beespace_join_answer answer_ = sized<beespace_join_answer>();
  beespace_error error_ = c_error();
  OwnedGuide<beespace_guide> guide_;
  OwnedGuide<beespace_guidance> guidance_{beespace_guidance_create()};
};

// An agent with a follower of C and one of C++, and what is under way to it.
struct Agent {
  OwnedGuide<beespace_follower> follower;
  Follower cpp;
  std::multimap<Tick, beespace_command> under_way;
};

inline Agent make_agent(std::int64_t id, const Tube& tube) {
  beespace_follower* made = nullptr;
  EXPECT_EQ(
      beespace_follower_create(id, tube.planned.max_speed_mps, tube.planned.max_acceleration_mps2,
                               kLink.period_s, &made, nullptr),
      BEESPACE_OK);
  return {OwnedGuide<beespace_follower>(made),
          *Follower::make(cpp_agent(id), tube.planned, kLink.period_s),
          {}};
}

}  // namespace beespace::test
