#include "cli/output/json_units.hpp"

namespace beespace::cli {

void write_units(io::JsonWriter& json, const std::vector<io::UnitTaken>& units) {
  json.begin_array();
  for (const io::UnitTaken& taken : units) {
    json.begin_object().member("of", taken.of);
    json.member("unit", io::symbol_of(taken.unit)).member("reason", taken.reason);
    json.end();
  }
  json.end();
}

void write_vertical(io::JsonWriter& json, const std::optional<io::StatedLength>& vertical,
                    io::Unit height_unit) {
  if (!vertical) return json.null();
  const io::Unit compared = compared_in(vertical, height_unit);
  json.begin_object();
  json.member("value", vertical->value).member("unit", io::symbol_of(vertical->unit));
  json.member("compared_in", io::symbol_of(compared));
  json.end();
}

}  // namespace beespace::cli
