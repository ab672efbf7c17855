// The page that web/ builds, put into the program by the assembler: no compiler is made to read
// hundreds of thousands of numbers.
#include "report/page.hpp"

#include <cstddef>

// BEESPACE_PAGE is the file's name, as a string.
__asm__(
    ".section .rodata\n"
    ".global beespace_page_begin\n"
    ".global beespace_page_end\n"
    ".hidden beespace_page_begin\n"
    ".hidden beespace_page_end\n"
    "beespace_page_begin:\n"
    ".incbin \"" BEESPACE_PAGE
    "\"\n"
    "beespace_page_end:\n"
    ".byte 0\n"
    ".previous\n");

extern "C" {
extern const char beespace_page_begin[];  // NOLINT(readability-identifier-naming)
extern const char beespace_page_end[];    // NOLINT(readability-identifier-naming)
}

namespace beespace::report {

std::string_view page_template() {
  return {beespace_page_begin, static_cast<std::size_t>(beespace_page_end - beespace_page_begin)};
}

}  // namespace beespace::report
