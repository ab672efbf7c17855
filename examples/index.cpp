// An index that is built once and asked about any place: which masts are near, and which nearest?
#include <beespace/beespace.hpp>

#include <cstdio>
#include <vector>

int main() {
  const std::vector<beespace::Point> masts{
      {0.0, 0.0, 30.0}, {100.0, 0.0, 45.0}, {100.0, 90.0, 40.0}, {500.0, 500.0, 60.0}};
  auto built = beespace::Index::build(masts);
  if (!built) {
    std::fprintf(stderr, "%s\n", to_string(built.error()).c_str());
    return 1;
  }
  beespace::Index& index = *built;

  const beespace::Point drone{60.0, 10.0, 40.0};
  const auto show = [&](const char* when) {
    const auto around = index.find_around(drone, 70.0);
    const auto nearest = index.k_nearest(drone, 2);
    if (!around || !nearest) return false;
    std::printf("%s:", when);
    for (const beespace::PointId id : *around) std::printf(" %u", id);
    std::printf(" within 70 m; nearest");
    for (const auto& mast : *nearest) std::printf(" %u (%.1f m)", mast.id, mast.distance_m);
    std::printf("\n");
    return true;
  };

  if (!show("built")) return 1;
  const auto crane = index.insert({62.0, 12.0, 35.0});  // gets the next id, 4
  if (!crane || !show("with a crane")) return 1;
  if (!index.move(*crane, {300.0, 12.0, 35.0}) || !index.remove(0)) return 1;
  return show("the crane away, mast 0 taken down") ? 0 : 1;
}
