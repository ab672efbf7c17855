// Text that programs of robots print of messages for reading: `ros2 topic echo` and rostopic
// (YAML), and `gz topic -e`. It is not read, but made a table of by what is said.
#pragma once

#include "io/table/table_layout.hpp"

#include <beespace/result.hpp>

#include <optional>

namespace beespace::io {

// What to type, with FILE for the name of the text; nothing of other tables. Errors:
// kMissingColumn, as no column names a position.
std::optional<Error> echoed_messages(const TableLayout& table);

}  // namespace beespace::io
