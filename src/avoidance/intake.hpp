// Checks the input: what is valid, and what is not, and why.
//
// One bad number never stops the advice: an invalid bee is left out and named, and the others are
// numbered anew without it. Values that are too small for the motion domain become zero here
// (motion/flush.hpp); SeparationMargins in agent_states.hpp allows for it.
#pragma once

#include <beespace/advise.hpp>
#include <beespace/mover.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace beespace::avoidance {

// The original numbers of a list from which some were left out.
class GivenNumbers {
 public:
  void clear() { numbers_.clear(), left_out_ = false; }
  // Takes the next one, whose original number is this.
  void take(std::size_t given) {
    if (left_out_) numbers_.push_back(given);
  }
  // Leaves one out, after so many that were taken.
  void leave_out(std::size_t taken) {
    if (left_out_) return;
    left_out_ = true;
    for (std::size_t k = 0; k < taken; ++k) numbers_.push_back(k);
  }
  [[nodiscard]] bool any_left_out() const { return left_out_; }
  [[nodiscard]] std::size_t operator[](std::size_t taken) const {
    return left_out_ ? numbers_[taken] : taken;
  }

 private:
  std::vector<std::size_t> numbers_;  // empty where none was left out
  bool left_out_ = false;
};

class Intake {
 public:
  // What check() of validate.hpp accepts. Sets `refused`.
  void take(const MoversView& movers, std::span<const Velocity> preferred,
            std::span<const FlightLimits> limits, const AdviseOptions& options,
            std::vector<Refused>& refused);

  [[nodiscard]] std::span<const Mover> movers() const { return movers_; }
  [[nodiscard]] std::span<const Velocity> preferred() const { return preferred_; }
  // One set of limits for each bee, or one for all.
  [[nodiscard]] std::span<const FlightLimits> limits() const { return limits_; }
  [[nodiscard]] const AdviseOptions& options() const { return options_; }

  // Whether a bee may be anywhere: one that is in no ball, or whose ball is invalid.
  [[nodiscard]] bool bee_anywhere() const { return bee_anywhere_; }
  [[nodiscard]] bool intruder_anywhere() const { return intruder_anywhere_; }

  [[nodiscard]] const GivenNumbers& given_bees() const { return given_bees_; }
  // How many bees were given, the invalid ones included.
  [[nodiscard]] std::size_t bees_given() const { return bees_; }

  // Replaces the numbers used here by the original ones, in all of an answer.
  void number_as_given(Advised& advised) const;

 private:
  void take_unknown(const AdviseOptions& options, std::size_t bees, std::vector<Refused>& refused);
  void take_bees(const MoversView& movers, std::span<const Velocity> preferred,
                 std::span<const FlightLimits> limits, const AdviseOptions& options,
                 std::vector<Refused>& refused);
  // The height of planar motion: that of most bees.
  void find_height(const MoversView& movers);
  void take_intruders(const AdviseOptions& options, std::vector<Refused>& refused);

  std::vector<Mover> movers_;
  std::vector<Velocity> preferred_;
  std::vector<FlightLimits> limits_;
  std::vector<Claim> claims_;  // their places are the caller's
  std::vector<Mover> intruders_;
  std::vector<double> intruder_margins_m_;
  std::vector<UnknownAgent> unknown_;
  AdviseOptions options_;  // as given, without invalid entries

  GivenNumbers given_bees_;
  GivenNumbers given_intruders_;
  GivenNumbers given_unknown_;
  std::size_t bees_ = 0;  // given
  bool bee_anywhere_ = false;
  bool intruder_anywhere_ = false;
  std::vector<char> is_unknown_;  // of the bees given, where any is
  double height_m_ = 0.0;         // of planar motion
  std::vector<double> heights_m_;
};

}  // namespace beespace::avoidance
