// One value of a delimited table.
#pragma once

#include <string>
#include <string_view>

namespace beespace::io {

// The text, in quotes where it would otherwise be read as something else (RFC 4180, for any
// delimiter); an empty one also between blanks, where nothing would be left of it.
void append_csv_field(std::string& out, std::string_view text, char delimiter);

}  // namespace beespace::io
