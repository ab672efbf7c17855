// cairo, which draws pixels: loaded when it is needed, as it and what it needs take longer to load
// than most searches take.
#pragma once

#include <cairo.h>

namespace beespace::report {

// Its functions, by their names without "cairo_".
struct Cairo {
  decltype(&cairo_arc) arc = nullptr;
  decltype(&cairo_close_path) close_path = nullptr;
  decltype(&cairo_create) create = nullptr;
  decltype(&cairo_destroy) destroy = nullptr;
  decltype(&cairo_fill) fill = nullptr;
  decltype(&cairo_fill_preserve) fill_preserve = nullptr;
  decltype(&cairo_font_options_create) font_options_create = nullptr;
  decltype(&cairo_font_options_destroy) font_options_destroy = nullptr;
  decltype(&cairo_font_options_set_hint_metrics) font_options_set_hint_metrics = nullptr;
  decltype(&cairo_font_options_set_hint_style) font_options_set_hint_style = nullptr;
  decltype(&cairo_get_scaled_font) get_scaled_font = nullptr;
  decltype(&cairo_image_surface_create) image_surface_create = nullptr;
  decltype(&cairo_line_to) line_to = nullptr;
  decltype(&cairo_move_to) move_to = nullptr;
  decltype(&cairo_new_sub_path) new_sub_path = nullptr;
  decltype(&cairo_paint) paint = nullptr;
  decltype(&cairo_rectangle) rectangle = nullptr;
  decltype(&cairo_restore) restore = nullptr;
  decltype(&cairo_rotate) rotate = nullptr;
  decltype(&cairo_save) save = nullptr;
  decltype(&cairo_scale) scale = nullptr;
  decltype(&cairo_scaled_font_get_type) scaled_font_get_type = nullptr;
  decltype(&cairo_select_font_face) select_font_face = nullptr;
  decltype(&cairo_set_antialias) set_antialias = nullptr;
  decltype(&cairo_set_dash) set_dash = nullptr;
  decltype(&cairo_set_font_options) set_font_options = nullptr;
  decltype(&cairo_set_font_size) set_font_size = nullptr;
  decltype(&cairo_set_line_join) set_line_join = nullptr;
  decltype(&cairo_set_line_width) set_line_width = nullptr;
  decltype(&cairo_set_source_rgba) set_source_rgba = nullptr;
  decltype(&cairo_show_text) show_text = nullptr;
  decltype(&cairo_status) status = nullptr;
  decltype(&cairo_stroke) stroke = nullptr;
  decltype(&cairo_surface_destroy) surface_destroy = nullptr;
  decltype(&cairo_surface_write_to_png_stream) surface_write_to_png_stream = nullptr;
  decltype(&cairo_text_extents) text_extents = nullptr;
  decltype(&cairo_text_path) text_path = nullptr;
  decltype(&cairo_translate) translate = nullptr;
};

// Null where there is no cairo on this machine. Loaded once, and never unloaded. Thread-safe.
const Cairo* loaded_cairo();

}  // namespace beespace::report
