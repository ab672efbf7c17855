// From values to places on a drawing, and the values worth a tick.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace beespace::report {

struct Range {
  double low = 0.0;
  double high = 1.0;

  [[nodiscard]] double size() const { return high - low; }
};

// Linear, or logarithmic, where the range is above zero.
class Scale {
 public:
  enum class Kind { kLinear, kLogarithmic };

  // `low_at` and `high_at` are where the ends of the range lie.
  Scale(Range values, double low_at, double high_at, Kind kind = Kind::kLinear)
      : values_(values), low_at_(low_at), high_at_(high_at), kind_(kind) {}

  // Values beyond the range lie at its ends.
  [[nodiscard]] double operator()(double value) const;
  // The other way round, for places from one end to the other.
  [[nodiscard]] double value_at(double place) const;

  [[nodiscard]] const Range& values() const { return values_; }
  [[nodiscard]] double low_at() const { return low_at_; }
  [[nodiscard]] double high_at() const { return high_at_; }
  [[nodiscard]] Kind kind() const { return kind_; }

 private:
  Range values_;
  double low_at_;
  double high_at_;
  Kind kind_;
};

struct Tick {
  double value = 0.0;
  std::string label;
};

// 1, 2 or 5 times a power of ten: the smallest step that makes at most `most` ticks.
double nice_step(double size, std::size_t most);

// At most `most`, in units of so many metres (1,000 for kilometres).
std::vector<Tick> nice_ticks(const Range& range, std::size_t most, double unit = 1.0);

// At the powers of ten; at 1, 2 and 5 times them where these are few.
std::vector<Tick> logarithmic_ticks(const Range& range, std::size_t most);

// The multiples of the step within the range; none where doubles cannot tell them apart.
std::vector<double> multiples(const Range& range, double step);

// Whole seconds, minutes, hours or days: the smallest step that makes at most `most` ticks.
double clock_step(double size_s, std::size_t most);

// Such ones; labels count from `zero`, as clocks do.
std::vector<Tick> clock_ticks(const Range& seconds, std::size_t most, double zero);

}  // namespace beespace::report
