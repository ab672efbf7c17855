// Which unit the numbers of a column have, and why: as the header names it, as the caller says, as
// a known source has it. Beside words of aviation nothing is assumed.
#pragma once

#include "io/table/table_sources.hpp"
#include "io/units/unit_overrides.hpp"
#include "io/units/unit_taken.hpp"
#include "io/units/units.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace beespace::io {

class UnitChoice {
 public:
  // Both must outlive it. `names` are those of the columns, or none.
  UnitChoice(const std::vector<std::string>& names, const UnitOverrides& overrides);

  // The known source that the header is of, or null.
  [[nodiscard]] const TableSource* source() const { return source_; }

  // A column of that role, whose name states `stated`; `of` says what it is in sentences
  // ("heights"). Errors: kInvalidArgument, with column, where the unit must be said, or where it is
  // said in two ways.
  Result<UnitTaken> choose(UnitRole role, const std::string& of, std::size_t column, Unit stated);

 private:
  [[nodiscard]] Error unknown(UnitRole role, std::size_t column) const;
  [[nodiscard]] bool units_differ() const {
    return source_ != nullptr && !source_->units_differ.empty();
  }
  [[nodiscard]] Unit by_convention(UnitRole role) const;
  [[nodiscard]] Error contradicts(const KnownColumn& known, Unit said, std::size_t column) const;

  const std::vector<std::string>& names_;
  const UnitOverrides& overrides_;
  const TableSource* source_;
  std::string aviation_;  // the columns that speak of it
};

// What is wrong where some of these columns name a unit that is not ours and others name none:
// it is unknown what the others are in. Errors: kInvalidArgument, with column.
struct ColumnUnit {
  std::size_t column;
  Unit unit;
  UnitEvidence evidence;
};
std::optional<Error> half_stated(const std::vector<std::string>& names,
                                 const std::vector<ColumnUnit>& units);

}  // namespace beespace::io
