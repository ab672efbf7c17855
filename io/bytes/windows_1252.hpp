// Text that is no UTF-8, as spreadsheets and loggers of western Europe write it: in Windows-1252.
#pragma once

#include "io/bytes/byte_source.hpp"

#include <optional>
#include <string_view>

namespace beespace::io {

// The same in UTF-8, each byte taken for a character of Windows-1252, which ISO 8859-1 is part of;
// nothing where `text` is UTF-8.
std::optional<Bytes> from_windows_1252(std::string_view text);

// What is to be said then.
inline constexpr std::string_view kTakenForWindows1252 =
    "some text is no UTF-8: it is taken for Windows-1252; if names look wrong, save the table as "
    "UTF-8";

}  // namespace beespace::io
