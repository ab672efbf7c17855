// Four drones, positions in metres: which are closer than 100 m to another one?
#include <beespace/beespace.hpp>

#include <iostream>
#include <vector>

int main() {
  const std::vector<beespace::Point> drones{
      {0.0, 0.0, 50.0}, {80.0, 60.0, 50.0}, {300.0, 0.0, 50.0}, {300.0, 0.0, 149.9}};

  const auto at_risk = beespace::find_at_risk(drones, {.threshold_m = 100.0});
  if (!at_risk) {
    std::cerr << beespace::to_string(at_risk.error()) << '\n';
    return 1;
  }
  std::cout << at_risk->size() << " of " << drones.size() << " drones are at risk:";
  for (const beespace::PointId id : *at_risk) std::cout << ' ' << id;
  std::cout << '\n';
}
