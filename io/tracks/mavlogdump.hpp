// Tables and texts that mavlogdump of pymavlink makes of .tlog: they do not say which vehicle sent
// a message.
#pragma once

#include "io/table/table_layout.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// Of its CSV, where the times since boot of several vehicles come in turn. Errors: kMissingColumn.
std::optional<Error> mixed_vehicles(std::string_view text, const TableLayout& table);

// Of its text, and of its JSON. Errors: kUnsupportedFormat.
std::optional<Error> dumped_text_problem(std::string_view text);
Error dumped_json_problem();

}  // namespace beespace::io
