#include "report/drawing/cairo.hpp"

#include <dlfcn.h>

#include <optional>

namespace beespace::report {
namespace {

constexpr const char* kLibrary = "libcairo.so.2";

template <class Function>
bool find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

bool find_all(void* library, Cairo& cairo) {
  bool found = true;
  found = find(library, "cairo_arc", cairo.arc) && found;
  found = find(library, "cairo_close_path", cairo.close_path) && found;
  found = find(library, "cairo_create", cairo.create) && found;
  found = find(library, "cairo_destroy", cairo.destroy) && found;
  found = find(library, "cairo_fill", cairo.fill) && found;
  found = find(library, "cairo_fill_preserve", cairo.fill_preserve) && found;
  found = find(library, "cairo_font_options_create", cairo.font_options_create) && found;
  found = find(library, "cairo_font_options_destroy", cairo.font_options_destroy) && found;
  found =
      find(library, "cairo_font_options_set_hint_metrics", cairo.font_options_set_hint_metrics) &&
      found;
  found = find(library, "cairo_font_options_set_hint_style", cairo.font_options_set_hint_style) &&
          found;
  found = find(library, "cairo_get_scaled_font", cairo.get_scaled_font) && found;
  found = find(library, "cairo_image_surface_create", cairo.image_surface_create) && found;
  found = find(library, "cairo_line_to", cairo.line_to) && found;
  found = find(library, "cairo_move_to", cairo.move_to) && found;
  found = find(library, "cairo_new_sub_path", cairo.new_sub_path) && found;
  found = find(library, "cairo_paint", cairo.paint) && found;
  found = find(library, "cairo_rectangle", cairo.rectangle) && found;
  found = find(library, "cairo_restore", cairo.restore) && found;
  found = find(library, "cairo_rotate", cairo.rotate) && found;
  found = find(library, "cairo_save", cairo.save) && found;
  found = find(library, "cairo_scale", cairo.scale) && found;
  found = find(library, "cairo_scaled_font_get_type", cairo.scaled_font_get_type) && found;
  found = find(library, "cairo_select_font_face", cairo.select_font_face) && found;
  found = find(library, "cairo_set_antialias", cairo.set_antialias) && found;
  found = find(library, "cairo_set_dash", cairo.set_dash) && found;
  found = find(library, "cairo_set_font_options", cairo.set_font_options) && found;
  found = find(library, "cairo_set_font_size", cairo.set_font_size) && found;
  found = find(library, "cairo_set_line_join", cairo.set_line_join) && found;
  found = find(library, "cairo_set_line_width", cairo.set_line_width) && found;
  found = find(library, "cairo_set_source_rgba", cairo.set_source_rgba) && found;
  found = find(library, "cairo_show_text", cairo.show_text) && found;
  found = find(library, "cairo_status", cairo.status) && found;
  found = find(library, "cairo_stroke", cairo.stroke) && found;
  found = find(library, "cairo_surface_destroy", cairo.surface_destroy) && found;
  found = find(library, "cairo_surface_write_to_png_stream", cairo.surface_write_to_png_stream) &&
          found;
  found = find(library, "cairo_text_extents", cairo.text_extents) && found;
  found = find(library, "cairo_text_path", cairo.text_path) && found;
  found = find(library, "cairo_translate", cairo.translate) && found;
  return found;
}

std::optional<Cairo> load() {
  void* const library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  Cairo cairo;
  if (library == nullptr || !find_all(library, cairo)) return std::nullopt;
  return cairo;
}

}  // namespace

const Cairo* loaded_cairo() {
  static const std::optional<Cairo> cairo = load();
  return cairo ? &*cairo : nullptr;
}

}  // namespace beespace::report

// What fonts were found is kept to the end by fontconfig, which cairo brings along.
#ifdef __has_feature
#define BEESPACE_HAS_FEATURE(feature) __has_feature(feature)
#else
#define BEESPACE_HAS_FEATURE(feature) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || BEESPACE_HAS_FEATURE(address_sanitizer)
extern "C" const char* __lsan_default_suppressions();   // NOLINT: the sanitizer's name
extern "C" const char* __lsan_default_suppressions() {  // NOLINT: the same
  return "leak:libfontconfig.so\n";
}
#endif
