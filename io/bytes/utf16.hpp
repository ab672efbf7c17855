// UTF-16 to UTF-8, as tables of tools for Windows come (EthoVision, "Unicode text" of Excel).
#pragma once

#include "io/bytes/byte_source.hpp"

#include <optional>
#include <string_view>

namespace beespace::io {

// What is noted of an input that was read so.
constexpr std::string_view kTakenForUtf16 = "the text is UTF-16, as its byte-order mark says";

// A copy in UTF-8, without the mark. Nothing where no byte-order mark says that it is UTF-16, or
// where it is none: half of a character, or of a pair of them.
std::optional<Bytes> from_utf16(std::string_view bytes);

}  // namespace beespace::io
