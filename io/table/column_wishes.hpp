// What the caller says of the columns: "lon=1,lat=2,height=3", by number (from 1) or by name.
#pragma once

#include "io/table/column_choice.hpp"
#include "io/table/header_words.hpp"

#include <beespace/result.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

struct Wish {
  Role role = Role::kNone;
  std::string column = {};
};

// Errors: kInvalidArgument for wishes that no file can fulfil, or that contradict `frame`.
Result<std::vector<Wish>> read_wishes(std::string_view text, Frame frame);

// Which column (0-based) is meant. Errors: kMissingColumn when there is none, or more than one.
Result<std::size_t> find_wished_column(const Wish& wish, const ColumnsSeen& seen);
// The same for a role that is no coordinate: `role` as the caller writes it.
Result<std::size_t> find_wished_column(std::string_view role, const std::string& wanted,
                                       const ColumnsSeen& seen);

// "lon", "lat", "height", "x", "y", "z" or "id".
std::string_view role_name(Role role);

// "the columns are 1 'a', 2 'b'".
std::string list_columns(const ColumnsSeen& seen);

}  // namespace beespace::io
