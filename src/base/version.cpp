#include <beespace/version.hpp>

namespace beespace {

std::string_view version() {
  return BEESPACE_VERSION;
}

}  // namespace beespace
