// Where a bee is if it does as advised: the path that advice is planned on.
//
// In each step it changes its velocity evenly, from the one that it has to the one that it is told,
// as near to that as its greatest acceleration lets it; told nothing it flies straight on; where no
// advice was given for a step at all, it brakes. Without a greatest acceleration it flies with the
// new velocity from the start of the step. Advice moves this path, reports only check it: so what
// was certified stays so, which it would not if each report moved it anew (see docs/prevention.md).
#pragma once

#include "cli/watch/advice_ticks.hpp"

#include <beespace/mover.hpp>

#include <deque>

namespace beespace::cli {

class NominalFlight {
 public:
  // Begins anew where a report says that the bee is. What it was told for later steps it is still
  // taken to do, from there.
  void anchor(double time_s, const Mover& mover, const AdviceTicks& ticks,
              double max_acceleration_mps2);

  // Until a tick that is later than where the path ends so far: what was not planned, it brakes,
  // or flies straight on before it has been `advised` of anything.
  void extend(Tick until, bool advised, const AdviceTicks& ticks, double max_acceleration_mps2);
  // One step more, towards what the bee is told; or straight on.
  void fly(const Velocity& velocity, bool told, const AdviceTicks& ticks,
           double max_acceleration_mps2);

  // At the end of the path.
  [[nodiscard]] Mover end() const { return nodes_.back().mover; }
  [[nodiscard]] Tick end_tick() const { return nodes_.back().tick; }

  // How far from the path a report is; and how far, in addition, its velocity would lead from it in
  // so many seconds.
  [[nodiscard]] double deviation_m(double time_s, const Mover& mover, double ahead_s,
                                   double max_acceleration_mps2) const;

 private:
  // Where pieces of the path meet: at ticks, but for the first.
  struct Node {
    double time_s;
    double lasts_s;  // the piece that ends here; 0 for the first
    Mover mover;
    Tick tick;  // of the first: the last one at or before it
    bool told;  // to have its velocity here
  };
  void add(const Velocity& aim, bool told, const AdviceTicks& ticks, double max_acceleration_mps2);

  std::deque<Node> nodes_;
};

}  // namespace beespace::cli
