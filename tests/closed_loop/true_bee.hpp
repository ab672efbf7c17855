// One bee of a closed loop: how it really flies, what it reports, and what goes wrong with it.
#pragma once

#include "tests/closed_loop/flight_plan.hpp"
#include "tests/closed_loop/flown.hpp"
#include "tests/closed_loop/looks.hpp"
#include "tests/closed_loop/random.hpp"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace beespace::closed_loop {

class TrueBee {
 public:
  TrueBee(std::string id, const Start& start, const FlightPlan& plan, std::uint64_t seed);

  // Flies step `step`. Without a look it brakes; without advice for it, it flies straight on.
  void fly(int step, bool has_look, const std::optional<Vector>& advised);

  // The lines of its reports in the step, each with the time at which it is made; those that are
  // late come with a later step.
  struct Line {
    double sent_s;
    double made_s;
    std::string text;
  };
  std::vector<Line> reports(int step);

  [[nodiscard]] const std::string& id() const { return id_; }
  [[nodiscard]] const Stretch& stretch() const { return stretch_; }
  [[nodiscard]] Vector position() const { return stretch_.position_at(stretch_.lasts_s); }
  [[nodiscard]] Vector velocity() const { return stretch_.velocity_at(stretch_.lasts_s); }
  // Whether it has flown as advised in all steps from one on, up to the last.
  [[nodiscard]] bool as_advised_since(int step) const { return otherwise_ < step; }

  double heard_s = -std::numeric_limits<double>::infinity();  // made: the latest that was sent
  double heard_before_s = heard_s;                            // the same, as the step began
  bool named = false;                                         // in any look so far

 private:
  // Whether something that lasts is under way, or begins: for `most` steps at most.
  bool lasts(int& until, int step, double probability, std::size_t most = 8);
  [[nodiscard]] std::string line(double made_s, long double passed_s);

  std::string id_;
  const FlightPlan& plan_;
  Random random_;
  Stretch stretch_;
  double phase_s_ = 0;
  int next_report_ = 0;
  int otherwise_ = -1;  // the last step that it flew otherwise than advised
  int own_will_until_ = -1;
  int weak_until_ = -1;
  int silent_until_ = -1;
  Vector own_aim_{};
};

}  // namespace beespace::closed_loop
