// Instead of page_template.cpp in a build without the page (BEESPACE_WEB=OFF).
#include "report/page.hpp"

namespace beespace::report {

std::string_view page_template() {
  return {};
}

}  // namespace beespace::report
