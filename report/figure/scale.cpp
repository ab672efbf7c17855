#include "report/figure/scale.hpp"

#include "report/number_label.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace beespace::report {
namespace {

int decimals_for(double step) {
  return std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
}

}  // namespace

double Scale::operator()(double value) const {
  const double within = std::clamp(value, values_.low, values_.high);
  const double share = kind_ == Kind::kLinear
                           ? (within - values_.low) / values_.size()
                           : std::log(within / values_.low) / std::log(values_.high / values_.low);
  return low_at_ + share * (high_at_ - low_at_);
}

double Scale::value_at(double place) const {
  const double share = (place - low_at_) / (high_at_ - low_at_);
  return kind_ == Kind::kLinear ? values_.low + share * values_.size()
                                : values_.low * std::pow(values_.high / values_.low, share);
}

double nice_step(double size, std::size_t most) {
  const double least = size / static_cast<double>(std::max<std::size_t>(1, most));
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

std::vector<double> multiples(const Range& range, double step) {
  std::vector<double> values;
  const double slack = 1e-9 * step;
  const double first = std::ceil((range.low - slack) / step);
  const double last = std::floor((range.high + slack) / step);
  if (!(std::max(std::abs(first), std::abs(last)) < 0x1p53)) return values;
  for (auto k = static_cast<std::int64_t>(first); static_cast<double>(k) <= last; ++k) {
    values.push_back(static_cast<double>(k) * step);
  }
  return values;
}

std::vector<Tick> nice_ticks(const Range& range, std::size_t most, double unit) {
  const Range in_units{range.low / unit, range.high / unit};
  const double step = nice_step(in_units.size(), most);
  std::vector<Tick> ticks;
  for (const double value : multiples(in_units, step)) {
    ticks.push_back({value * unit, decimal_label(value, decimals_for(step))});
  }
  return ticks;
}

std::vector<Tick> logarithmic_ticks(const Range& range, std::size_t most) {
  const int first = static_cast<int>(std::floor(std::log10(range.low) + 1e-9));
  const int last = static_cast<int>(std::ceil(std::log10(range.high) - 1e-9));
  const int every = 1 + (last - first) / static_cast<int>(most);
  const std::vector<double> factors =
      3.0 * std::log10(range.high / range.low) + 1.0 <= static_cast<double>(most)
          ? std::vector{1.0, 2.0, 5.0}
          : std::vector{1.0};
  std::vector<Tick> ticks;
  for (int power = first; power <= last; power += every) {
    for (const double factor : factors) {
      const double value = factor * std::pow(10.0, power);
      if (value < range.low * (1.0 - 1e-9) || value > range.high * (1.0 + 1e-9)) continue;
      ticks.push_back({value, short_label(value)});
    }
  }
  return ticks;
}

double clock_step(double size_s, std::size_t most) {
  constexpr std::array kSteps_s = {1.0,     2.0,     5.0,      10.0,     15.0,     30.0,
                                   60.0,    120.0,   300.0,    600.0,    900.0,    1'800.0,
                                   3'600.0, 7'200.0, 10'800.0, 21'600.0, 43'200.0, 86'400.0};
  const double least = size_s / static_cast<double>(std::max<std::size_t>(1, most));
  if (least <= kSteps_s.front()) return nice_step(size_s, most);
  if (least <= kSteps_s.back()) return *std::lower_bound(kSteps_s.begin(), kSteps_s.end(), least);
  return kSteps_s.back() * std::ceil(least / kSteps_s.back());
}

std::vector<Tick> clock_ticks(const Range& seconds, std::size_t most, double zero) {
  const double step = clock_step(seconds.size(), most);
  std::vector<Tick> ticks;
  for (const double value : multiples({seconds.low - zero, seconds.high - zero}, step)) {
    ticks.push_back({value + zero, clock_label(value, step)});
  }
  return ticks;
}

}  // namespace beespace::report
