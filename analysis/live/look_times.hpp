// When the swarm is looked at: at whole multiples of a step, counted by integers, so that no
// rounding skips a look or takes one twice.
#pragma once

#include <cstdint>
#include <optional>

namespace beespace::analysis {

class LookTimes {
 public:
  // Seconds, above 0.
  explicit LookTimes(double step_s);

  // When look `number` is: of steps of up to nine decimals the double that a report has which names
  // the same time in decimals.
  [[nodiscard]] double at(std::int64_t number) const;

  // The last look before a time: reports of its own time are in once one of a later time comes.
  // Nothing where there are more looks than can be counted.
  [[nodiscard]] std::optional<std::int64_t> last_before(double time_s) const;

 private:
  double step_s_;
  double parts_ = 0.0;  // of a second, of which the step has a whole number; 0: none such
  double step_in_parts_ = 0.0;
};

}  // namespace beespace::analysis
