#include "report/figure/png.hpp"

namespace beespace::report {

bool can_draw_png() {
  return false;
}

std::optional<Png> png(const Drawing& /*drawing*/, unsigned /*width*/) {
  return std::nullopt;
}

}  // namespace beespace::report
