// A rectangle with axes, in which something is plotted.
#pragma once

#include "report/drawing/drawing.hpp"
#include "report/figure/scale.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace beespace::report {

struct Box {
  double left = 0.0;
  double top = 0.0;
  double width = 0.0;
  double height = 0.0;

  [[nodiscard]] double right() const { return left + width; }
  [[nodiscard]] double bottom() const { return top + height; }
};

struct Axis {
  Scale scale;
  std::vector<Tick> ticks;
  std::string title;  // with its unit: "East (m)"; empty where another panel's axis says it
};

struct Panel {
  Box box;
  std::string heading;
  Axis across;
  Axis upwards;
};

// Slanted lines through a box: what is not known.
Lines hatching(const Box& box);

// Ticks across, as many as have room for their labels; the maker is asked for at most so many.
using TickMaker = std::function<std::vector<Tick>(std::size_t)>;
std::vector<Tick> as_many_as_fit(double length, const TickMaker& make);

// Grid, axes, ticks and their titles: before what is plotted.
void draw_panel(const Panel& panel, Drawing& drawing);

// A dashed line at a value of an axis, with its name: after what is plotted.
// Across, the name is beside the heading, where it covers nothing; where there is no room, it is
// beside the line where least of `around` is in its way, as far to the right as that allows.
void draw_line_across(const Panel& panel, double value, const std::string& name,
                      const Lines& around, Drawing& drawing);
void draw_line_upwards(const Panel& panel, double value, const std::string& name, Drawing& drawing);

// How much a label of that width would cover that begins there: of paths and curves, and of marks,
// but not of what is behind all of them.
std::ptrdiff_t in_the_way(const Drawing& drawing, Spot at, double width);

// A ring, and what it says, if anything, on that side of it where there is room, and clear of a
// line across at `line_y`. Returns the baseline of what it says.
double draw_ring(const Box& box, Spot spot, const std::string& text, Drawing& drawing,
                 std::optional<double> line_y = {});

}  // namespace beespace::report
