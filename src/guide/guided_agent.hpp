// What a Guide knows about one agent.
#pragma once

#include "guide/ball.hpp"
#include "guide/branches.hpp"
#include "guide/contract_monitor.hpp"
#include "guide/ground_loop.hpp"

#include <beespace/advise.hpp>
#include <beespace/command.hpp>
#include <beespace/fleet.hpp>
#include <beespace/guide.hpp>

#include <optional>

namespace beespace::guide {

struct GuidedAgent {
  AgentId id = 0;
  FleetFigures figures;
  Tube tube;
  double radius_m = 0.0;
  Branches branches;
  ContractMonitor monitor;
  // Of a fleet whose loop is closed on the ground.
  fleet::CorrectionLoop loop = {};
  GroundLoop corrections = {};

  std::optional<Point> goal = {};
  Velocity preferred = {};

  // The newest report, by its stamp; and when it was last heard of, by the ticks of the planner.
  std::optional<AgentReport> last = {};
  Tick heard = 0;
  // By its own clock it is guided since then: what it says of earlier ticks is of another life.
  Tick since = 0;
  // A report of a tick that lies ahead of the planner, until the next step; the latest.
  std::optional<AgentReport> early = {};
  // Around its claim; none: not worked out since the last step. (What it says may make it smaller.)
  std::optional<Ball> around = {};
  struct Taken {
    BranchNumber number = 0;
    Tick tick = 0;
  };
  Taken taken = {};  // the newest command that it says it took, and when by its own tick

  [[nodiscard]] bool is_on_ground_loop() const { return figures.loop == LoopPlace::kGround; }
};

}  // namespace beespace::guide
