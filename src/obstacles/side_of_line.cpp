#include "obstacles/side_of_line.hpp"

#include "exact/expansion.hpp"

#include <cmath>

namespace beespace::obstacles {

namespace {

// 6 products, 2 components each. Exact: in the motion domain every double is a multiple of 2^-152,
// so products and what they round off are multiples of 2^-304.
using Sum = core::Expansion<12>;

// (a - c) x (b - c) = a x b - a x c - c x b, as c x c is zero.
int exact_side(const Corner& a, const Corner& b, const Corner& c) {
  Sum area;
  area.add_product(a.x, b.y);
  area.add_product(-a.y, b.x);
  area.add_product(-a.x, c.y);
  area.add_product(a.y, c.x);
  area.add_product(-c.x, b.y);
  area.add_product(c.y, b.x);
  return area.sign();
}

}  // namespace

int side_of_line(const Corner& from, const Corner& to, const Corner& point) {
  const double left = (from.x - point.x) * (to.y - point.y);
  const double right = (from.y - point.y) * (to.x - point.x);
  const double area = left - right;
  // Two differences and a product round on either side, 3 u, and the last difference: below 8 u of
  // the sum of the magnitudes, with u = 2^-53.
  const double doubt = 0x1p-50 * (std::abs(left) + std::abs(right));
  if (area > doubt) return 1;
  if (area < -doubt) return -1;
  return exact_side(from, to, point);
}

}  // namespace beespace::obstacles
