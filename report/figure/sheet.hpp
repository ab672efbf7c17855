// What is around the panels of a figure: title, key, a list, notes.
#pragma once

#include "report/drawing/drawing.hpp"
#include "report/facts.hpp"
#include "report/figure/panel.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace beespace::report {

struct KeyEntry {
  enum class Sample : std::uint8_t {
    kBee,
    kAtRisk,
    kPair,
    kShades,
    kBinned,
    kPath,
    kInConflict,
    kStart,
    kBand,
    kUnknown,
    kAhead
  };

  Sample sample;
  std::string text;
};

struct Row {
  std::string left;
  std::string right;
  std::vector<Ink> inks = {};  // of the paths that it is about, where these have their own
};

struct Listing {
  std::string heading;
  std::vector<Row> rows;
  std::uint64_t count = 0;  // of all, also of those that are no row here
};

// A drawing with its title, the line below it, and the key; panels begin at kPanelsTop.
inline constexpr double kPanelsTop = 152.0;
Drawing begin_sheet(const SwarmFacts& swarm, const std::string& findings,
                    const std::vector<KeyEntry>& key);

// "closer than 100 m".
std::string too_close(const SwarmFacts& swarm);

// What a line at the threshold says: "threshold 100 m", or "horizontally 100 m" where heights are
// compared apart, as then it tells less of a distance in a straight line.
std::string threshold_name(const SwarmFacts& swarm);

// How much room its heading and so many of its rows take, if it has as many.
double listing_height(const Listing& listing, double width, std::size_t most);

// As many rows as there is room for, down to `bottom`; the heading says of how many.
void draw_listing(const Listing& listing, Spot corner, double width, double bottom,
                  Drawing& drawing);

// What must be told, below all; and sets the drawing's height.
void finish_sheet(const SwarmFacts& swarm, double bottom, Drawing& drawing);

}  // namespace beespace::report
