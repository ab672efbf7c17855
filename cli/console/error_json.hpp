// What went wrong, where a program looks for it.
#pragma once

#include "io/json/json_writer.hpp"

#include <beespace/result.hpp>

#include <string>

namespace beespace::cli {

// An object: what an error says and where it lies.
void write_error(io::JsonWriter& json, const Error& error);

// {"error": {...}}: what --json says instead of an answer.
std::string error_as_json(const Error& error);

}  // namespace beespace::cli
