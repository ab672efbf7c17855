#include "report/drawing/png.hpp"

#include "report/drawing/cairo.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <string_view>
#include <utility>

namespace beespace::report {
namespace {

constexpr const char* kFont = "DejaVu Sans";

// What figures themselves say beyond ASCII.
std::string in_ascii(std::string text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kSpellings = {
      {{"\u2212", "-"}, {"\u2013", "-"}, {"\u2026", "..."}, {"\u00d7", "x"}, {"\u00b0", " deg"}}};
  for (const auto& [sign, spelling] : kSpellings) {
    for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign)) {
      text.replace(at, sign.size(), spelling);
    }
  }
  return text;
}

class Painter {
 public:
  Painter(const Cairo& cairo, cairo_surface_t* surface, double scale)
      : cairo_(cairo), to_(cairo.create(surface)), has_fonts_(false) {
    cairo_.scale(to_, scale, scale);
    cairo_.set_line_join(to_, CAIRO_LINE_JOIN_ROUND);
    leave_letters_as_they_are();
    has_fonts_ = found_fonts();
    set_ink({0xffffff});
    cairo_.paint(to_);
  }
  ~Painter() { cairo_.destroy(to_); }
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  void draw(const Lines& lines) {
    constexpr double kDashes[] = {6.0, 4.0};
    set_ink(lines.ink);
    cairo_.set_line_width(to_, lines.width);
    cairo_.set_dash(to_, kDashes, lines.dashed ? 2 : 0, 0.0);
    for (const auto& run : lines.runs) trace(run);
    cairo_.stroke(to_);
    cairo_.set_dash(to_, kDashes, 0, 0.0);
  }

  void draw(const Area& area) {
    set_ink(area.ink);
    trace(area.corners);
    cairo_.fill(to_);
  }

  void draw(const Dots& dots) {
    set_ink(dots.ink);
    cairo_.set_line_width(to_, dots.outline);
    for (const Spot& centre : dots.centres) {
      cairo_.new_sub_path(to_);
      cairo_.arc(to_, centre.x, centre.y, dots.radius, 0.0, 2.0 * std::numbers::pi);
      // One by one, so that where they overlap it shows, as in SVG.
      dots.outline > 0.0 ? cairo_.stroke(to_) : cairo_.fill(to_);
    }
  }

  void draw(const Diamonds& diamonds) {
    constexpr double kRim = 0.6;
    cairo_.set_line_width(to_, kRim);
    for (const auto& [centre, radius, name] : diamonds.marks) {
      trace({{centre.x, centre.y - radius},
             {centre.x + radius, centre.y},
             {centre.x, centre.y + radius},
             {centre.x - radius, centre.y}});
      cairo_.close_path(to_);
      set_ink(diamonds.ink);
      cairo_.fill_preserve(to_);
      set_ink({0xffffff});
      cairo_.stroke(to_);
    }
  }

  void draw(const Cells& cells) {
    cairo_.set_antialias(to_, CAIRO_ANTIALIAS_NONE);  // no seams between neighbours
    for (std::size_t level = 1; level <= cells.inks.size(); ++level) {
      set_ink(cells.inks[level - 1]);
      for (std::size_t i = 0; i < cells.levels.size(); ++i) {
        if (cells.levels[i] != level) continue;
        const std::size_t row = i / cells.columns;
        const std::size_t column = i % cells.columns;
        cairo_.rectangle(to_, cells.corner.x + static_cast<double>(column) * cells.side,
                         cells.corner.y + static_cast<double>(row) * cells.side, cells.side,
                         cells.side);
      }
      cairo_.fill(to_);
    }
    cairo_.set_antialias(to_, CAIRO_ANTIALIAS_DEFAULT);
  }

  void draw(const Text& text) {
    constexpr double kHalo = 3.0;
    const std::string shown = has_fonts_ ? text.text : in_ascii(text.text);
    const char* const letters = shown.c_str();
    select_font(text.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_.set_font_size(to_, text.size);
    cairo_text_extents_t extents{};
    cairo_.text_extents(to_, letters, &extents);
    double before = 0.0;
    if (text.anchor == Anchor::kMiddle) before = extents.x_advance / 2.0;
    if (text.anchor == Anchor::kEnd) before = extents.x_advance;
    cairo_.save(to_);
    cairo_.translate(to_, text.at.x, text.at.y);
    if (text.upwards) cairo_.rotate(to_, -std::numbers::pi / 2.0);
    cairo_.move_to(to_, -before, 0.0);
    if (text.halo) {
      cairo_.text_path(to_, letters);
      cairo_.set_line_width(to_, kHalo);
      set_ink({0xffffff});
      cairo_.stroke(to_);
      cairo_.move_to(to_, -before, 0.0);
    }
    set_ink(text.ink);
    cairo_.show_text(to_, letters);
    cairo_.restore(to_);
  }

  [[nodiscard]] bool has_fonts() const { return has_fonts_; }
  [[nodiscard]] bool went_well() const { return cairo_.status(to_) == CAIRO_STATUS_SUCCESS; }

 private:
  void set_ink(const Ink& ink) {
    const auto part = [&ink](unsigned shift) { return ((ink.rgb >> shift) & 255u) / 255.0; };
    cairo_.set_source_rgba(to_, part(16), part(8), part(0), ink.opacity);
  }

  void trace(const std::vector<Spot>& spots) {
    cairo_.new_sub_path(to_);
    for (const Spot& spot : spots) cairo_.line_to(to_, spot.x, spot.y);
  }

  void select_font(cairo_font_weight_t weight) const {
    cairo_.select_font_face(to_, kFont, CAIRO_FONT_SLANT_NORMAL, weight);
  }

  // At any size: not fitted to whole pixels.
  void leave_letters_as_they_are() {
    cairo_font_options_t* const options = cairo_.font_options_create();
    cairo_.font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_.font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_.set_font_options(to_, options);
    cairo_.font_options_destroy(options);
  }

  // Where there are no fonts cairo draws letters of its own, those of ASCII.
  [[nodiscard]] bool found_fonts() const {
    select_font(CAIRO_FONT_WEIGHT_NORMAL);
    return cairo_.scaled_font_get_type(cairo_.get_scaled_font(to_)) != CAIRO_FONT_TYPE_USER;
  }

  const Cairo& cairo_;
  cairo_t* to_;
  bool has_fonts_;
};

}  // namespace

std::string why_no_png() {
  if (loaded_cairo() != nullptr) return {};
  return "PNG is drawn by cairo, which is not installed (Debian: apt-get install libcairo2)";
}

std::optional<Png> png(const Drawing& drawing, unsigned width) {
  const Cairo& cairo = *loaded_cairo();
  const double scale = width / drawing.width;
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo.image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width),
                                 static_cast<int>(std::lround(drawing.height * scale))),
      cairo.surface_destroy);
  Painter painter(cairo, surface.get(), scale);
  Png made;
  made.has_fonts = painter.has_fonts();
  for (const Shape& shape : drawing.shapes) {
    std::visit([&painter](const auto& of_some_kind) { painter.draw(of_some_kind); }, shape);
  }
  const auto keep = [](void* bytes, const unsigned char* data, unsigned size) {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), size);
    return CAIRO_STATUS_SUCCESS;
  };
  const bool drawn =
      painter.went_well() &&
      cairo.surface_write_to_png_stream(surface.get(), keep, &made.bytes) == CAIRO_STATUS_SUCCESS;
  return drawn ? std::optional(std::move(made)) : std::nullopt;
}

}  // namespace beespace::report
