#include "report/figure/png.hpp"

#include <cairo.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>

namespace beespace::report {
namespace {

constexpr const char* kFont = "DejaVu Sans";

void set_ink(cairo_t* to, const Ink& ink) {
  const auto part = [&ink](unsigned shift) { return ((ink.rgb >> shift) & 255u) / 255.0; };
  cairo_set_source_rgba(to, part(16), part(8), part(0), ink.opacity);
}

void trace(cairo_t* to, const std::vector<Spot>& spots) {
  cairo_new_sub_path(to);
  for (const Spot& spot : spots) cairo_line_to(to, spot.x, spot.y);
}

void draw(cairo_t* to, const Lines& lines) {
  constexpr double kDashes[] = {6.0, 4.0};
  set_ink(to, lines.ink);
  cairo_set_line_width(to, lines.width);
  cairo_set_dash(to, kDashes, lines.dashed ? 2 : 0, 0.0);
  for (const auto& run : lines.runs) trace(to, run);
  cairo_stroke(to);
  cairo_set_dash(to, kDashes, 0, 0.0);
}

void draw(cairo_t* to, const Area& area) {
  set_ink(to, area.ink);
  trace(to, area.corners);
  cairo_fill(to);
}

void draw(cairo_t* to, const Dots& dots) {
  set_ink(to, dots.ink);
  cairo_set_line_width(to, dots.outline);
  for (const Spot& centre : dots.centres) {
    cairo_new_sub_path(to);
    cairo_arc(to, centre.x, centre.y, dots.radius, 0.0, 2.0 * std::numbers::pi);
    // One by one, so that where they overlap it shows, as in SVG.
    dots.outline > 0.0 ? cairo_stroke(to) : cairo_fill(to);
  }
}

void draw(cairo_t* to, const Diamonds& diamonds) {
  constexpr double kRim = 0.6;
  cairo_set_line_width(to, kRim);
  for (const auto& [centre, radius, name] : diamonds.marks) {
    trace(to, {{centre.x, centre.y - radius},
               {centre.x + radius, centre.y},
               {centre.x, centre.y + radius},
               {centre.x - radius, centre.y}});
    cairo_close_path(to);
    set_ink(to, diamonds.ink);
    cairo_fill_preserve(to);
    set_ink(to, {0xffffff});
    cairo_stroke(to);
  }
}

void draw(cairo_t* to, const Cells& cells) {
  cairo_set_antialias(to, CAIRO_ANTIALIAS_NONE);  // no seams between neighbours
  for (std::size_t level = 1; level <= cells.inks.size(); ++level) {
    set_ink(to, cells.inks[level - 1]);
    for (std::size_t i = 0; i < cells.levels.size(); ++i) {
      if (cells.levels[i] != level) continue;
      const auto column = static_cast<double>(i % cells.columns);
      const auto row = static_cast<double>(i / cells.columns);
      cairo_rectangle(to, cells.corner.x + column * cells.side, cells.corner.y + row * cells.side,
                      cells.side, cells.side);
    }
    cairo_fill(to);
  }
  cairo_set_antialias(to, CAIRO_ANTIALIAS_DEFAULT);
}

void draw(cairo_t* to, const Text& text) {
  constexpr double kHalo = 3.0;
  cairo_select_font_face(to, kFont, CAIRO_FONT_SLANT_NORMAL,
                         text.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(to, text.size);
  cairo_text_extents_t extents{};
  cairo_text_extents(to, text.text.c_str(), &extents);
  cairo_save(to);
  cairo_translate(to, text.at.x, text.at.y);
  if (text.upwards) cairo_rotate(to, -std::numbers::pi / 2.0);
  double before = 0.0;
  if (text.anchor == Anchor::kMiddle) before = extents.x_advance / 2.0;
  if (text.anchor == Anchor::kEnd) before = extents.x_advance;
  cairo_move_to(to, -before, 0.0);
  if (text.halo) {
    cairo_text_path(to, text.text.c_str());
    cairo_set_line_width(to, kHalo);
    set_ink(to, {0xffffff});
    cairo_stroke(to);
    cairo_move_to(to, -before, 0.0);
  }
  set_ink(to, text.ink);
  cairo_show_text(to, text.text.c_str());
  cairo_restore(to);
}

// And as they are, at any size: not fitted to whole pixels.
void leave_letters_as_wide_as_they_are(cairo_t* to) {
  cairo_font_options_t* const options = cairo_font_options_create();
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_set_font_options(to, options);
  cairo_font_options_destroy(options);
}

// Where there are no fonts cairo draws letters of its own.
bool found_a_font(cairo_t* to) {
  cairo_select_font_face(to, kFont, CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  return cairo_scaled_font_get_type(cairo_get_scaled_font(to)) != CAIRO_FONT_TYPE_USER;
}

struct Release {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

}  // namespace

bool can_draw_png() {
  return true;
}

std::optional<Png> png(const Drawing& drawing, unsigned width) {
  const double scale = width / drawing.width;
  const std::unique_ptr<cairo_surface_t, Release> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width),
                                 static_cast<int>(std::lround(drawing.height * scale))));
  const std::unique_ptr<cairo_t, Release> context(cairo_create(surface.get()));
  cairo_t* const to = context.get();
  cairo_scale(to, scale, scale);
  cairo_set_line_join(to, CAIRO_LINE_JOIN_ROUND);
  leave_letters_as_wide_as_they_are(to);
  set_ink(to, {0xffffff});
  cairo_paint(to);
  Png made;
  made.has_fonts = found_a_font(to);
  for (const Shape& shape : drawing.shapes) {
    std::visit([to](const auto& of_some_kind) { draw(to, of_some_kind); }, shape);
  }
  const auto keep = [](void* bytes, const unsigned char* data, unsigned size) {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
  };
  const bool drawn =
      cairo_status(to) == CAIRO_STATUS_SUCCESS &&
      cairo_surface_write_to_png_stream(surface.get(), keep, &made.bytes) == CAIRO_STATUS_SUCCESS;
  return drawn ? std::optional(std::move(made)) : std::nullopt;
}

}  // namespace beespace::report
