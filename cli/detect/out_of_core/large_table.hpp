// The rows of an answer about many points, written one after the other: as text, CSV or JSON, as
// the same answer is written where all points are in memory.
#pragma once

#include "cli/detect/out_of_core/large_ids.hpp"
#include "cli/detect/out_of_core/large_input.hpp"
#include "cli/output/apart_fields.hpp"
#include "cli/output/block_writer.hpp"
#include "cli/output/output_form.hpp"
#include "cli/output/table.hpp"
#include "io/json/json_writer.hpp"
#include "io/table/table_writer.hpp"

#include <beespace/out_of_core.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace beespace::cli {

// Another bee; nothing where there is none.
struct LargeBeeCell {
  std::optional<LargeId> id;
};

// The last are several bees, ascending.
using LargeCell = std::variant<std::uint64_t, LargeBeeCell, DistanceCell, std::span<const LargeId>>;

struct LargeColumn {
  const char* name;
  bool names_bees;
};

// What rows are written with. All must outlive them.
struct LargeTableParts {
  BlockWriter& out;
  io::JsonWriter& json;  // into `out`; behind a key
  const LargeFile& file;
  const LargeIds& ids;
  TextStore* records;  // null: not wanted
};

class LargeTable {
 public:
  LargeTable() = default;
  LargeTable(const LargeTable&) = delete;
  LargeTable& operator=(const LargeTable&) = delete;
  virtual ~LargeTable() = default;

  // About bees, with these columns behind the bee itself; or of pairs.
  virtual void begin_bees(const std::vector<LargeColumn>& columns) = 0;
  virtual void bee(LargeId id, std::span<const LargeCell> cells) = 0;
  virtual void begin_pairs(const ApartFields& fields) = 0;
  virtual void pair(const LargePair& pair, double distance_m, const analysis::Apart& apart) = 0;
  virtual void end() {}

  // Text, CSV or JSON.
  static std::unique_ptr<LargeTable> make(Form form, const LargeTableParts& parts);
};

// The members of a pair in JSON.
void write_pair(io::JsonWriter& json, const LargeIds& ids, const LargePair& pair,
                double distance_m);

}  // namespace beespace::cli
