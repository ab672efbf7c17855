// What went wrong, where a program looks for it.
#pragma once

#include <beespace/result.hpp>

#include <string>

namespace beespace::cli {

// What an error says and where it lies, as the members of an object.
void append_error_members(std::string& out, const Error& error);

// {"error": {...}}: what --json says instead of an answer.
std::string error_as_json(const Error& error);

}  // namespace beespace::cli
