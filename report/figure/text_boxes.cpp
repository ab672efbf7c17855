#include "report/figure/text_boxes.hpp"

#include "report/drawing/text_fit.hpp"

#include <variant>
#include <vector>

namespace beespace::report {

Box box_of_text(const Text& text) {
  constexpr double kBolder = 1.1;  // how much wider bold text is
  const double width = (text.bold ? kBolder : 1.0) * text_width(text.text, text.size);
  const double left = text.anchor == Anchor::kStart    ? text.at.x
                      : text.anchor == Anchor::kMiddle ? text.at.x - 0.5 * width
                                                       : text.at.x - width;
  return {left, text.at.y - 0.8 * text.size, width, 1.1 * text.size};
}

bool covers_part_of(const Box& a, const Box& b) {
  return a.left < b.right() && b.left < a.right() && a.top < b.bottom() && b.top < a.bottom();
}

std::vector<Box> boxes_of_texts(const Drawing& drawing) {
  std::vector<Box> boxes;
  for (const Shape& shape : drawing.shapes) {
    if (const auto* text = std::get_if<Text>(&shape)) boxes.push_back(box_of_text(*text));
  }
  return boxes;
}

}  // namespace beespace::report
