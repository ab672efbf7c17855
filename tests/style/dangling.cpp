// What Clang must warn of, and what it must not: check_dangling_test.sh compares its warnings with
// the lines that are marked.
#include <beespace/beespace.hpp>

#include <array>
#include <span>
#include <vector>

using namespace beespace;  // NOLINT(google-build-using-namespace)

std::vector<Point> points();
std::vector<double> numbers();
std::vector<Mover> movers();
IdRows id_rows();
NearestRows nearest_rows();
void take(const PointsView& view);
void take(const MoversView& view);

PointsView of_a_local() {
  const std::vector<Point> local = points();
  return local;  // dangles
}

std::span<const PointId> of_local_rows() {
  const IdRows rows = id_rows();
  return rows[0];  // dangles
}

void hold_views() {
  const PointsView of_points = points();                                              // dangles
  const PointsView interleaved = PointsView::interleaved(numbers());                  // dangles
  const PointsView separate = PointsView::separate(numbers(), numbers(), numbers());  // dangles
  const std::vector<Point> on_ground = points();
  const PointsView apart = PointsView(on_ground).with_heights(numbers());  // dangles
  static_cast<void>(apart);
  const MoversView of_movers = movers();                  // dangles
  const AdviseOptions options = {.intruders = movers()};  // dangles
  const auto ids = id_rows()[0];                          // dangles
  const auto nearest = nearest_rows()[0];                 // dangles
  const auto first = id_rows().begin();                   // dangles
  static_cast<void>(first);
  for (const PointId id : id_rows()[0]) static_cast<void>(id);  // dangles
  static_cast<void>(of_points);
  static_cast<void>(interleaved);
  static_cast<void>(separate);
  static_cast<void>(of_movers);
  static_cast<void>(options);
  static_cast<void>(ids);
  static_cast<void>(nearest);
}

void use_at_once() {
  take(points());
  take(movers());
  take(PointsView::interleaved(numbers()));
  static_cast<void>(find_at_risk(points(), {.threshold_m = 5.0}));
  static_cast<void>(id_rows()[0].size());
  const std::vector<Point> kept = points();
  const PointsView of_all = kept;
  const PointsView of_some = std::span(kept).first(2);
  const std::array<double, 3> xyz{};
  const PointsView of_span = PointsView::interleaved(std::span<const double>(xyz));
  const PointsView copy = of_some;
  static_cast<void>(of_all);
  static_cast<void>(of_span);
  static_cast<void>(copy);
}
