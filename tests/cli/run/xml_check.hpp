// Whether a text is one well-formed XML document, as far as beespace writes it: no DTD, comments or
// CDATA.
#pragma once

#include <string_view>

namespace beespace::cli_test {

bool is_xml(std::string_view text);

}  // namespace beespace::cli_test
