#include "report/drawing/svg.hpp"

#include "report/xml_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>

namespace beespace::report {
namespace {

// In tenths of a unit, which are finer than a screen or a printer shows: "12.3".
void append_number(std::string& out, double value) {
  auto tenths = static_cast<std::int64_t>(std::llround(value * 10.0));
  if (tenths < 0) {
    out += '-';
    tenths = -tenths;
  }
  std::array<char, 24> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), tenths / 10).ptr;
  out.append(text.data(), end);
  if (tenths % 10 == 0) return;
  out += '.';
  out += static_cast<char>('0' + tenths % 10);
}

// After a letter or another number; a minus sign parts them as well as a blank.
void append_next(std::string& out, double value) {
  const std::size_t begin = out.size();
  append_number(out, value);
  if (out[begin] != '-') out.insert(begin, 1, ' ');
}

void append_attribute(std::string& out, std::string_view name, double value) {
  ((out += ' ') += name) += "=\"";
  append_number(out, value);
  out += '"';
}

void append_colour(std::string& out, std::uint32_t rgb) {
  constexpr std::string_view kHex = "0123456789abcdef";
  out += '#';
  for (unsigned shift = 24; shift > 0; shift -= 4) out += kHex[(rgb >> (shift - 4)) & 15u];
}

// fill="#d55e00" fill-opacity="0.5".
void append_ink(std::string& out, std::string_view name, const Ink& ink) {
  ((out += ' ') += name) += "=\"";
  append_colour(out, ink.rgb);
  out += '"';
  if (ink.opacity >= 1.0) return;
  ((out += ' ') += name) += "-opacity=\"0.";
  const auto hundredths = static_cast<unsigned>(std::lround(ink.opacity * 100.0));
  out += static_cast<char>('0' + hundredths / 10 % 10);
  out += static_cast<char>('0' + hundredths % 10);
  out += '"';
}

// Relative steps between spots that were rounded before, so that no error adds up.
void append_run(std::string& out, std::span<const Spot> spots) {
  const auto rounded = [](double value) { return std::round(value * 10.0) / 10.0; };
  Spot last;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const Spot next{rounded(spots[i].x), rounded(spots[i].y)};
    if (i < 2) out += i == 0 ? 'M' : 'l';
    const std::size_t begin = out.size();
    append_next(out, next.x - last.x);
    if (i < 2 && out[begin] == ' ') out.erase(begin, 1);
    append_next(out, next.y - last.y);
    last = next;
  }
}

void append(std::string& out, const Lines& lines) {
  out += "<path fill=\"none\"";
  append_ink(out, "stroke", lines.ink);
  append_attribute(out, "stroke-width", lines.width);
  if (lines.dashed) out += " stroke-dasharray=\"6 4\"";
  out += " d=\"";
  for (const auto& run : lines.runs) append_run(out, run);
  out += "\"/>\n";
}

void append(std::string& out, const Area& area) {
  out += "<path";
  append_ink(out, "fill", area.ink);
  out += " d=\"";
  append_run(out, area.corners);
  out += "z\"/>\n";
}

void append(std::string& out, const Dots& dots) {
  out += "<g";
  if (dots.outline > 0.0) {
    out += " fill=\"none\"";
    append_ink(out, "stroke", dots.ink);
    append_attribute(out, "stroke-width", dots.outline);
  } else {
    append_ink(out, "fill", dots.ink);
  }
  out += ">\n";
  for (const Spot& centre : dots.centres) {
    out += "<circle";
    append_attribute(out, "cx", centre.x);
    append_attribute(out, "cy", centre.y);
    append_attribute(out, "r", dots.radius);
    out += "/>\n";
  }
  out += "</g>\n";
}

void append(std::string& out, const Diamonds& diamonds) {
  out += "<g stroke=\"#ffffff\" stroke-width=\"0.6\"";
  append_ink(out, "fill", diamonds.ink);
  out += ">\n";
  for (const auto& [centre, radius, name] : diamonds.marks) {
    const std::array tips = {Spot{centre.x, centre.y - radius}, Spot{centre.x + radius, centre.y},
                             Spot{centre.x, centre.y + radius}, Spot{centre.x - radius, centre.y}};
    out += "<path d=\"";
    append_run(out, tips);
    if (name.empty()) {
      out += "z\"/>\n";
      continue;
    }
    out += "z\"><title>";
    append_xml_text(out, name);
    out += "</title></path>\n";
  }
  out += "</g>\n";
}

// Each level is one path of horizontal strokes, in units of cells.
void append(std::string& out, const Cells& cells) {
  out += "<g fill=\"none\" shape-rendering=\"crispEdges\" transform=\"translate(";
  append_number(out, cells.corner.x);
  append_next(out, cells.corner.y + cells.side / 2.0);
  out += ") scale(";
  append_number(out, cells.side);
  out += ")\">\n";
  for (std::size_t level = 1; level <= cells.inks.size(); ++level) {
    std::string strokes;
    for (std::size_t i = 0; i < cells.levels.size();) {
      const std::size_t begin = i;
      const std::size_t row_ends = (i / cells.columns + 1) * cells.columns;
      while (i < row_ends && cells.levels[i] == level) ++i;
      if (i == begin) {
        ++i;
        continue;
      }
      strokes += 'M' + std::to_string(begin % cells.columns) + ' ' +
                 std::to_string(begin / cells.columns) + 'h' + std::to_string(i - begin);
    }
    if (strokes.empty()) continue;
    out += "<path";
    append_ink(out, "stroke", cells.inks[level - 1]);
    out += " d=\"" + strokes + "\"/>\n";
  }
  out += "</g>\n";
}

void append(std::string& out, const Text& text) {
  out += "<text";
  if (text.upwards) {
    out += " transform=\"translate(";
    append_number(out, text.at.x);
    append_next(out, text.at.y);
    out += ") rotate(-90)\"";
  } else {
    append_attribute(out, "x", text.at.x);
    append_attribute(out, "y", text.at.y);
  }
  append_attribute(out, "font-size", text.size);
  if (text.anchor == Anchor::kMiddle) out += " text-anchor=\"middle\"";
  if (text.anchor == Anchor::kEnd) out += " text-anchor=\"end\"";
  if (text.bold) out += " font-weight=\"bold\"";
  append_ink(out, "fill", text.ink);
  if (text.halo) {
    out +=
        " stroke=\"#ffffff\" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\"";
  }
  out += '>';
  append_xml_text(out, text.text);
  out += "</text>\n";
}

}  // namespace

std::string svg(const Drawing& drawing, unsigned width) {
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  out += "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + std::to_string(width) + '"';
  append_attribute(out, "height", std::round(width * drawing.height / drawing.width));
  out += " viewBox=\"0 0";
  append_next(out, drawing.width);
  append_next(out, drawing.height);
  out +=
      "\" role=\"img\" stroke-linejoin=\"round\" font-family=\"Helvetica Neue, Helvetica, Arial, "
      "DejaVu Sans, sans-serif\">\n<title>";
  append_xml_text(out, drawing.title);
  out += "</title>\n<desc>";
  append_xml_text(out, drawing.description);
  out += "</desc>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  for (const Shape& shape : drawing.shapes) {
    std::visit([&out](const auto& of_some_kind) { append(out, of_some_kind); }, shape);
  }
  return out += "</svg>\n";
}

}  // namespace beespace::report
