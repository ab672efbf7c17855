// What a report found, as rows of values: the same for every form of the answer.
//
// The values are looked up when a row is written, in what the search returned, so that a long
// answer is not there twice.
#pragma once

#include "cli/output/apart_fields.hpp"

#include <beespace/id_rows.hpp>
#include <beespace/nearest.hpp>
#include <beespace/pairs.hpp>
#include <beespace/point.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace beespace::cli {

// Another bee, or one of the others; Nearest::kNone where there is none.
struct BeeCell {
  PointId id = Nearest::kNone;
};

// Metres; infinite where there is none.
struct DistanceCell {
  double distance_m = 0.0;
};

// The last are several bees, ascending.
using Cell = std::variant<std::uint64_t, BeeCell, DistanceCell, std::span<const PointId>>;

struct Column {
  const char* name;
  bool names_bees;  // its cells hold ids
  std::function<Cell(PointId)> cell;
};

// A row for each of these bees, ascending.
struct BeeTable {
  std::vector<PointId> bees;
  std::vector<Column> columns;
};

// A row for each pair. How far apart the two are follows from their positions; with a vertical
// threshold `apart` has it horizontally and vertically, of each pair.
struct PairTable {
  std::vector<Pair> pairs;
  std::vector<analysis::Apart> apart = {};
  ApartFields fields = {};

  [[nodiscard]] analysis::Apart apart_of(std::size_t pair) const {
    return pair < apart.size() ? apart[pair] : analysis::Apart();
  }
};

// A row for each group; or for each member, in the forms that give the records themselves.
struct GroupTable {
  IdRows groups;
  BeeTable members;
};

struct Table {
  std::variant<BeeTable, PairTable, GroupTable> rows;
  std::string finding = {};  // for the summary: what is worth knowing about it all
};

}  // namespace beespace::cli
