// Of several columns of times in numbers: which one counts from 1970. The size of numbers tells it,
// but microseconds since a boot may be of the same; beside one that says its unit, and is none of
// 1970 in it, or counts from a boot by its name, it does not matter which.
#pragma once

#include "io/table/column_choice.hpp"
#include "io/tracks/first_fields.hpp"
#include "io/units/units.hpp"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace beespace::io {

// The unit in which all of them are times since 1970; kUnstated where there is none.
Unit common_unit_since_1970(const FirstFields& times);

// Whether times that may be milliseconds since 1970 can be nothing else: microseconds since a boot
// of more than a week ago, or nanoseconds since one of half an hour ago, would follow each other
// faster than anything tells where it is.
bool are_surely_milliseconds(const FirstFields& times);

// The only one of those columns that counts from 1970, the others being numbers that do not, as
// their units say; or the only one that says its unit and does, the others having none.
std::optional<std::size_t> only_since_1970(std::string_view text, const Header& header,
                                           const std::vector<std::size_t>& columns);

}  // namespace beespace::io
