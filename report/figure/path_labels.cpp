#include "report/figure/path_labels.hpp"

#include "report/drawing/text_fit.hpp"
#include "report/figure/picture_names.hpp"
#include "report/figure/style.hpp"
#include "report/figure/text_boxes.hpp"
#include "report/xml_text.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace beespace::report {
namespace {

constexpr double kWidestName = 150.0;
constexpr double kNameAscent = 0.8 * kLabelSize;
constexpr double kNameDescent = 0.3 * kLabelSize;
constexpr double kBesideEnd = 6.0;

Box box_around(Spot spot, double radius) {
  return {spot.x - radius, spot.y - radius, 2.0 * radius, 2.0 * radius};
}

bool lies_within(const Box& inner, const Box& outer) {
  return inner.left >= outer.left && inner.right() <= outer.right() && inner.top >= outer.top &&
         inner.bottom() <= outer.bottom();
}

// To the right of the spot, to the left, above it and below, and so in the corners.
std::array<Text, 6> places_beside(const Text& label, Spot spot) {
  const double width = text_width(label.text, label.size);
  const auto at = [&label](double x, double y) {
    Text text = label;
    text.at = {x, y};
    return text;
  };
  const double middle = spot.y + 0.35 * kLabelSize;
  const double above = spot.y - kBesideEnd - kNameDescent;
  const double below = spot.y + kBesideEnd + kNameAscent;
  return {at(spot.x + kBesideEnd, middle), at(spot.x - kBesideEnd - width, middle),
          at(spot.x - 0.5 * width, above), at(spot.x - 0.5 * width, below),
          at(spot.x + kBesideEnd, above),  at(spot.x - kBesideEnd - width, below)};
}

}  // namespace

void draw_path_labels(const RecordingFacts& facts, const View& view, Drawing& drawing) {
  if (facts.tracks.empty() || facts.tracks.size() > kMostNamedPaths) return;
  std::vector<Box> taken;
  std::vector<Spot> ends;
  for (const Shape& shape : drawing.shapes) {
    if (const auto* text = std::get_if<Text>(&shape)) taken.push_back(box_of_text(*text));
    if (const auto* dots = std::get_if<Dots>(&shape)) {
      for (const Spot& at : dots->centres) taken.push_back(box_around(at, dots->radius));
    }
    if (const auto* diamonds = std::get_if<Diamonds>(&shape)) {
      for (const Diamond& mark : diamonds->marks) {
        taken.push_back(box_around(mark.centre, mark.radius));
      }
    }
  }
  for (const Track& track : facts.tracks) {
    if (!track.fixes.empty()) ends.push_back(view.spot_of(track.fixes.back().position));
  }
  constexpr double kEnd = 2.0;
  for (const Spot& end : ends) taken.push_back(box_around(end, kEnd));
  Dots dots{ends, kEnd, kText, 1.0};
  for (std::size_t bee = 0; bee < facts.tracks.size(); ++bee) {
    const Track& track = facts.tracks[bee];
    if (track.fixes.empty()) continue;
    const std::string name = one_line(picture_name(facts.swarm.names, static_cast<PointId>(bee)));
    const Text label{
        {},   fitted(name, kLabelSize, kWidestName), kLabelSize, Anchor::kStart, false, false, true,
        kText};
    for (const Text& text : places_beside(label, view.spot_of(track.fixes.back().position))) {
      const Box box = box_of_text(text);
      const bool free = lies_within(box, view.panel.box) &&
                        std::none_of(taken.begin(), taken.end(), [&box](const Box& other) {
                          return covers_part_of(box, other);
                        });
      if (!free) continue;
      taken.push_back(box);
      drawing.shapes.emplace_back(text);
      break;
    }
  }
  drawing.shapes.emplace_back(std::move(dots));
}

}  // namespace beespace::report
