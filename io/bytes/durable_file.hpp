// Small files that must outlive a crash: what was to be remembered before something was said.
#pragma once

#include <beespace/result.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

// Replaces the file (a link stays one): afterwards it holds all of the text, on the disk, even if
// the machine fails at once; before, what it held. Errors: kWriteFailed.
Status write_durably(const std::string& path, std::string_view text);

// The file that a path leads to, through links, whether it is there yet or not. Who works with a
// file by two names works with one.
std::string file_behind(const std::string& path);

// All of a file; nothing where there is none. Errors: kReadFailed; kMalformedRecord where it is
// larger.
Result<std::optional<std::string>> read_small_file(const std::string& path, std::size_t most);

}  // namespace beespace::io
