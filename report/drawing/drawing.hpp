// A picture as a list of shapes, before it is a file: drawn in their order, the later ones on top.
//
// Lengths are in units of the drawing, x to the right and y down, from the upper left corner. Plain
// values: what draws adds them, and svg() and png() tell them in a format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace beespace::report {

struct Spot {
  double x = 0.0;
  double y = 0.0;
};

struct Ink {
  std::uint32_t rgb = 0x000000;
  double opacity = 1.0;
};

// Open lines through some spots each, all drawn alike.
struct Lines {
  std::vector<std::vector<Spot>> runs;
  Ink ink;
  double width = 1.0;
  bool dashed = false;
};

struct Area {
  std::vector<Spot> corners;
  Ink ink;
};

// Circles: filled, or with an outline only.
struct Dots {
  std::vector<Spot> centres;
  double radius = 1.0;
  Ink ink;
  double outline = 0.0;  // how wide; 0: filled
};

// Squares on their tips, with a white rim that keeps them apart.
struct Diamond {
  Spot centre;
  double radius = 1.0;    // from the centre to a tip
  std::string name = {};  // whose it is, for those who point at it
};
struct Diamonds {
  std::vector<Diamond> marks;
  Ink ink;
};

// Small squares side by side, row by row: level 0 is empty, level k has inks[k - 1].
struct Cells {
  Spot corner;
  double side = 1.0;
  std::size_t columns = 0;
  std::vector<std::uint8_t> levels;
  std::vector<Ink> inks;
};

enum class Anchor : std::uint8_t { kStart, kMiddle, kEnd };

// One line of text, `at` where its baseline begins, has its middle, or ends. UTF-8.
struct Text {
  Spot at;
  std::string text;
  double size = 12.0;
  Anchor anchor = Anchor::kStart;
  bool bold = false;
  bool upwards = false;  // read from below
  bool halo = false;     // white around it, to be read over other shapes
  Ink ink;
};

using Shape = std::variant<Lines, Area, Dots, Diamonds, Cells, Text>;

struct Drawing {
  double width = 0.0;
  double height = 0.0;
  std::string title;  // for those who cannot see it, as is the description
  std::string description;
  std::vector<Shape> shapes;
};

}  // namespace beespace::report
