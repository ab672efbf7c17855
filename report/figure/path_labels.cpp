#include "report/figure/path_labels.hpp"

#include "report/drawing/text_fit.hpp"
#include "report/figure/picture_names.hpp"
#include "report/figure/style.hpp"
#include "report/figure/text_boxes.hpp"
#include "report/xml_text.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace beespace::report {
namespace {

constexpr double kWidestName = 300.0;  // where there is room
constexpr double kShorterName = 150.0;
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

// Right of the spot, left of it, above and below, and so in the corners; then farther and farther
// above and below, as far to the side as the view allows.
std::vector<Text> places_beside(const Text& label, Spot spot, const Box& view) {
  constexpr int kRows = 4;
  const double width = text_width(label.text, label.size);
  std::vector<Text> places;
  const auto at = [&](double x, double y) {
    Text text = label;
    text.at = {x, y};
    places.push_back(text);
  };
  const double right = spot.x + kBesideEnd;
  const double left = spot.x - kBesideEnd - width;
  const double middle = spot.y + 0.35 * kLabelSize;
  const double above = spot.y - kBesideEnd - kNameDescent;
  const double below = spot.y + kBesideEnd + kNameAscent;
  at(right, middle);
  at(left, middle);
  at(spot.x - 0.5 * width, above);
  at(spot.x - 0.5 * width, below);
  at(right, above);
  at(left, below);
  const double least = view.left + 1.0;
  const double within = std::max(least, std::min(spot.x - 0.5 * width, view.right() - width - 1.0));
  const double row = kLabelSize + 2.0;
  for (int i = 0; i < kRows; ++i) {
    const double far = row * static_cast<double>(i);
    for (const double y : {above - far, below + far}) {
      at(std::max(least, within), y);
      at(right, y);
      at(left, y);
    }
  }
  return places;
}

}  // namespace

std::vector<std::size_t> named_paths(const RecordingFacts& facts) {
  std::vector<bool> in_conflict(facts.tracks.size());
  for (const Conflict& conflict : facts.conflicts) {
    in_conflict[conflict.first] = in_conflict[conflict.second] = true;
  }
  std::vector<std::size_t> named;
  for (const bool first : {true, false}) {
    if (!first && facts.tracks.size() > kMostNamedPaths) break;
    for (std::size_t bee = 0; bee < in_conflict.size(); ++bee) {
      if (in_conflict[bee] == first) named.push_back(bee);
    }
  }
  return named.size() <= kMostNamedPaths ? named : std::vector<std::size_t>();
}

void draw_path_labels(const RecordingFacts& facts, const View& view, Drawing& drawing) {
  const std::vector<std::size_t> named = named_paths(facts);
  if (named.empty()) return;
  std::vector<Box> taken;
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
  constexpr double kEnd = 2.0;
  std::vector<Dots> dots;
  for (const std::size_t bee : named) {
    const Track& track = facts.tracks[bee];
    if (track.fixes.empty()) continue;
    const Spot end = view.spot_of(track.fixes.back().position);
    taken.push_back(box_around(end, kEnd));
    dots.push_back(Dots{{end}, kEnd, own_ink(bee, facts.tracks.size()).value_or(kText), 1.0});
  }
  const auto is_free = [&](const Box& box) {
    return lies_within(box, view.panel.box) &&
           std::none_of(taken.begin(), taken.end(),
                        [&box](const Box& other) { return covers_part_of(box, other); });
  };
  // As a whole where there is room, or shorter.
  const auto draw_name = [&](const std::string& name, Spot end) {
    for (const double widest : {kWidestName, kShorterName}) {
      const std::string shown = fitted(name, kLabelSize, widest);
      const Text label{{}, shown, kLabelSize, Anchor::kStart, false, false, true, kText};
      for (const Text& text : places_beside(label, end, view.panel.box)) {
        const Box box = box_of_text(text);
        if (!is_free(box)) continue;
        taken.push_back(box);
        drawing.shapes.emplace_back(text);
        return;
      }
    }
  };
  for (const std::size_t bee : named) {
    const Track& track = facts.tracks[bee];
    if (track.fixes.empty()) continue;
    draw_name(one_line(picture_name(facts.swarm.names, static_cast<PointId>(bee))),
              view.spot_of(track.fixes.back().position));
  }
  for (Dots& dot : dots) drawing.shapes.emplace_back(std::move(dot));
}

}  // namespace beespace::report
