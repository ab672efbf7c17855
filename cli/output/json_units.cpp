#include "cli/output/json_units.hpp"

#include "io/bytes/number_text.hpp"
#include "io/json/json_text.hpp"

namespace beespace::cli {

std::string json_units(const std::vector<io::UnitTaken>& units) {
  std::string out = "[";
  for (const io::UnitTaken& taken : units) {
    out += out.size() == 1 ? "{" : ", {";
    out += "\"of\": " + io::json_string(taken.of);
    out += ", \"unit\": " + io::json_string(io::symbol_of(taken.unit));
    out += ", \"reason\": " + io::json_string(taken.reason) + "}";
  }
  return out + "]";
}

std::string json_vertical(const std::optional<io::StatedLength>& vertical, io::Unit height_unit) {
  if (!vertical) return "null";
  const io::Unit compared =
      compares_as_stated(vertical, height_unit) ? height_unit : io::Unit::kMetre;
  return "{\"value\": " + io::exact(vertical->value) +
         ", \"unit\": " + io::json_string(io::symbol_of(vertical->unit)) +
         ", \"compared_in\": " + io::json_string(io::symbol_of(compared)) + "}";
}

}  // namespace beespace::cli
