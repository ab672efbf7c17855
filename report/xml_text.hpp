// Text as XML 1.0 wants it, in elements and in attributes.
#pragma once

#include <string>
#include <string_view>

namespace beespace::report {

// Escaped. What XML forbids (control characters, U+FFFE and U+FFFF) and bytes that are not UTF-8
// become U+FFFD, the replacement character.
void append_xml_text(std::string& out, std::string_view text);
std::string xml_text(std::string_view text);

// The same characters without the escapes, line ends and tabs as blanks: one line for people.
std::string one_line(std::string_view text);

}  // namespace beespace::report
