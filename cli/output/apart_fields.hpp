// How far apart two are horizontally and vertically, as fields behind the others: of rows of pairs,
// where there is a vertical threshold.
#pragma once

#include "analysis/geometry/apart.hpp"
#include "io/json/json_writer.hpp"
#include "io/table/table_writer.hpp"
#include "io/units/units.hpp"

#include <optional>
#include <string_view>

namespace beespace::cli {

// Whether rows have them, and in nautical miles and feet too.
struct ApartFields {
  bool wanted = false;
  bool aviation = false;
};

inline std::string_view pair_header(const ApartFields& fields) {
  if (!fields.wanted) return "first,second,distance_m";
  return fields.aviation
             ? "first,second,distance_m,horizontal_m,vertical_m,horizontal_NM,vertical_ft"
             : "first,second,distance_m,horizontal_m,vertical_m";
}

inline void write_apart(io::TableWriter& table, const analysis::Apart& apart,
                        const ApartFields& fields) {
  if (!fields.wanted) return;
  table.field(apart.horizontal_m).field(apart.vertical_m);
  if (!fields.aviation) return;
  table.field(io::from_metric(apart.horizontal_m, io::Unit::kNauticalMile));
  table.field(io::from_metric(apart.vertical_m, io::Unit::kFoot));
}

inline void write_apart(io::JsonWriter& json, const analysis::Apart& apart,
                        const ApartFields& fields) {
  if (!fields.wanted) return;
  json.member("horizontal_m", apart.horizontal_m).member("vertical_m", apart.vertical_m);
  if (!fields.aviation) return;
  json.member("horizontal_NM", io::from_metric(apart.horizontal_m, io::Unit::kNauticalMile));
  json.member("vertical_ft", io::from_metric(apart.vertical_m, io::Unit::kFoot));
}

}  // namespace beespace::cli
