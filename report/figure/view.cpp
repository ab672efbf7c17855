#include "report/figure/view.hpp"

#include "report/drawing/text_fit.hpp"
#include "report/figure/style.hpp"
#include "report/number_label.hpp"
#include "report/separation_words.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace beespace::report {
namespace {

constexpr double kLeastTop = 264.0;
constexpr double kGreatestTop = 660.0;
constexpr double kLeastSide = 120.0;
constexpr double kGreatestSide = 240.0;
constexpr double kBetween = 44.0;  // with the heading of the lower one
constexpr double kPadding = 1.06;

double in_steps(double length) {
  return kViewStep * std::ceil(length / kViewStep - 1e-9);
}

Range around(double low, double high, double size) {
  const double middle = 0.5 * (low + high);
  return {middle - 0.5 * size, middle + 0.5 * size};
}

Axis axis_across(const char* name, const Scale& scale, const AxisUnit& unit) {
  const auto make = [&](std::size_t most) { return nice_ticks(scale.values(), most, unit.metres); };
  return {scale, as_many_as_fit(scale.high_at() - scale.low_at(), make),
          std::string(name) + " (" + unit.name + ")"};
}

Axis axis_upwards(const char* name, const Scale& scale, const AxisUnit& unit) {
  const double height = std::abs(scale.low_at() - scale.high_at());
  const double room = (height > kGreatestSide ? 3.2 : 2.2) * kLabelSize;
  return {scale, nice_ticks(scale.values(), static_cast<std::size_t>(height / room), unit.metres),
          std::string(name) + " (" + unit.name + ")"};
}

std::string stretch_label(double stretch) {
  const bool larger = stretch > 1.0;
  const double times = larger ? stretch : 1.0 / stretch;
  if (times < 1.05) return {};  // it would be told as 1.0
  return ", heights drawn " + decimal_label(times, times < 10.0 ? 1 : 0) + "\u00d7 " +
         (larger ? "larger" : "smaller");
}

// No narrower than doubles of this size are apart.
double size_of(double low, double high) {
  return std::max(high - low, 1e-9 * std::max(std::abs(low), std::abs(high)));
}

}  // namespace

void Extent::add(const Point& point) {
  low_ = {std::min(low_.x, point.x), std::min(low_.y, point.y), std::min(low_.z, point.z)};
  high_ = {std::max(high_.x, point.x), std::max(high_.y, point.y), std::max(high_.z, point.z)};
}

Density density_over(const View& view, double side) {
  const Box& box = view.panel.box;
  return {{box.left, box.top}, box.width, box.height, side};
}

std::vector<View> views_of(const Extent& extent, const SwarmFacts& swarm, Spot corner,
                           double width) {
  const Point low = extent.empty() ? Point{} : extent.low();
  const Point high = extent.empty() ? Point{} : extent.high();
  const double least_m = swarm.threshold_m > 0.0 ? swarm.threshold_m : 1.0;
  double across_m = size_of(low.x, high.x);
  double along_m = size_of(low.y, high.y);
  if (std::max(high.x - low.x, high.y - low.y) <= 1e-6 * least_m) {
    across_m = std::max(across_m, least_m);
  }
  const double unit_m = kPadding * std::max(across_m / width, along_m / kGreatestTop);
  const double top = in_steps(std::clamp(kPadding * along_m / unit_m, kLeastTop, kGreatestTop));

  const double up_m = size_of(low.z, high.z);
  const double side = in_steps(std::clamp(1.15 * up_m / unit_m, kLeastSide, kGreatestSide));
  // As it is where that fits and can be seen; otherwise it fills the panel.
  const bool flat = up_m <= 1e-3 * unit_m * width;
  const bool true_to_scale = flat || (up_m <= 0.9 * side * unit_m && up_m >= 0.3 * side * unit_m);
  const double up_unit_m = true_to_scale ? unit_m : 1.15 * up_m / side;

  const Box above{corner.x, corner.y, width, top};
  const Box beside{corner.x, above.bottom() + kBetween, width, side};
  const Scale x(around(low.x, high.x, unit_m * width), above.left, above.right());
  const double y_begins = swarm.y_is_down ? above.top : above.bottom();
  const double y_ends = swarm.y_is_down ? above.bottom() : above.top;
  const Scale y(around(low.y, high.y, unit_m * top), y_begins, y_ends);
  const Scale z(around(low.z, high.z, up_unit_m * side), beside.bottom(), beside.top);
  const bool on_earth = swarm.origin.has_value();
  // One unit across and along.
  const AxisUnit plane = axis_unit(swarm, std::max(x.values().size(), y.values().size()));
  const Axis east = axis_across(on_earth ? "East" : "x", x, plane);
  const AxisUnit up = swarm.aviation ? height_unit(swarm) : axis_unit(swarm, z.values().size());
  const std::string heading = swarm.y_is_down ? "As in the video, y downward" : "From above";
  Axis unnamed = east;
  unnamed.title.clear();
  if (swarm.flat) {
    const Axis north = axis_upwards(on_earth ? "North" : "y", y, plane);
    return {{View::From::kAbove, {above, heading, east, north}}};
  }
  return {{View::From::kAbove,
           {above, heading, unnamed, axis_upwards(on_earth ? "North" : "y", y, plane)}},
          {View::From::kSide,
           {beside, "From the side" + stretch_label(unit_m / up_unit_m), east,
            axis_upwards(on_earth ? "Height" : "z", z, up)}}};
}

}  // namespace beespace::report
