#include "cli/input/shape_value.hpp"

#include <cstddef>
#include <string>
#include <utility>

namespace beespace::cli {

Result<Separation> read_shape(const Typed& typed) {
  const std::string& text = typed.text;
  Separation shape;
  if (text == "sphere") return shape;
  const std::size_t colon = text.find(':');
  const std::string value = colon == std::string::npos ? "" : text.substr(colon + 1);
  // Errors show all that was typed.
  const auto in_full = [&](Result<Separation> read) {
    if (read) return read;
    Error error = std::move(read).error();
    const std::string quoted = "'" + value + "'";
    const std::size_t at = error.message.find(quoted);
    if (at != std::string::npos) error.message.replace(at, quoted.size(), "'" + text + "'");
    return Result<Separation>(std::move(error));
  };
  const Typed number{typed.command, typed.option, value};
  if (text.starts_with("ellipsoid:")) {
    shape.shape = SeparationShape::kEllipsoid;
    return in_full(amount("times", kAboveZero)(number).transform([&](double factor) {
      shape.vertical_factor = factor;
      return shape;
    }));
  }
  if (text.starts_with("cylinder:")) {
    shape.shape = SeparationShape::kCylinder;
    return in_full(length_from(kLeastLength_m)(number).transform([&](double half_height_m) {
      shape.vertical_m = half_height_m;
      return shape;
    }));
  }
  return usage_error(typed.command, std::string(typed.option) + " '" + text +
                                        "' is no shape; give sphere, ellipsoid:3 or cylinder:3");
}

}  // namespace beespace::cli
