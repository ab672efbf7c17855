// Is this text at all? Tells apart what people hand over by mistake, by the first bytes.
#pragma once

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// Without the UTF-8 byte-order mark, if there is one.
std::string_view without_byte_order_mark(std::string_view bytes);

// kUnsupportedFormat with what was found and where; empty for anything that may be a text table.
// `or_raw` says how to read it as a raw array, where such are read: "; raw float64 ...".
std::optional<Error> text_problem(std::string_view bytes, std::string_view or_raw = {});

}  // namespace beespace::io
