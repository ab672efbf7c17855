#include "report/drawing/png.hpp"

namespace beespace::report {

std::string why_no_png() {
  return "this build draws no PNG: build beespace where the headers of cairo are installed "
         "(Debian: "
         "apt-get install libcairo2-dev)";
}

std::optional<Png> png(const Drawing& /*drawing*/, unsigned /*width*/) {
  return std::nullopt;
}

}  // namespace beespace::report
