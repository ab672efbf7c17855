// Whether a text is one well-formed JSON document (RFC 8259).
#pragma once

#include <string_view>

namespace beespace::cli_test {

bool is_json(std::string_view text);

}  // namespace beespace::cli_test
