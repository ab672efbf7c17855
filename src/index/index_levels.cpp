#include "index/index_levels.hpp"

#include "base/sort_ids.hpp"
#include "exact/exact_distance.hpp"
#include "exact/validate.hpp"

#include <cstdio>
#include <string>
#include <utility>

namespace beespace::search {

namespace {

// A sink that is as large as its vector's memory, or grows it.
class VectorSink final : public cpu::IdSink {
 public:
  explicit VectorSink(std::vector<PointId>& ids) : IdSink{nullptr, nullptr, grow}, ids_(ids) {
    ids_.resize(kFirst);
    // NOLINTNEXTLINE(clang-analyzer-optin.cplusplus.UninitializedObject): make_room is set above
    use_from(0);
  }

  void add(PointId id) {
    if (next == end) grow(*this);
    *next++ = id;
  }

  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(next - ids_.data()); }

 private:
  static constexpr std::size_t kFirst = 64;

  static void grow(cpu::IdSink& sink) {
    auto& self = static_cast<VectorSink&>(sink);
    const std::size_t used = self.size();
    self.ids_.resize(2 * self.ids_.size());
    self.use_from(used);
  }

  void use_from(std::size_t used) {
    next = ids_.data() + used;
    end = ids_.data() + ids_.size();
  }

  std::vector<PointId>& ids_;
};

}  // namespace

IndexLevels::IndexLevels(ChangingPoints held)
    : points(std::move(held)), walks_(cpu::tree_walks(cpu::best_instruction_set())) {
}

void IndexLevels::find_around(const cpu::Ball& ball, std::vector<PointId>& found) const {
  found.clear();
  if (ball.radius_m == 0.0 && !ball.inclusive) return;
  VectorSink sink(found);
  for (const core::PointTree& tree : points.trees()) walks_.collect(tree.view(), ball, sink);
  for (const auto& recent : points.recent()) {
    if (ball.holds(recent.point)) sink.add(recent.id);
  }
  const std::size_t count = sink.size();
  core::sort_ids(found, count);
}

std::optional<Error> check_radius(double radius_m) {
  if (radius_m >= 0.0 && core::in_domain(radius_m)) return std::nullopt;
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", radius_m);
  return Error{ErrorCode::kInvalidThreshold,
               "the radius is " + std::string(text) +
                   " m; give zero or a finite distance above it (3.9e-121 m to 2.6e+120 m)",
               {}};
}

void IndexLevels::find_nearest(const Point& place, core::NearestList& list) const {
  for (const core::PointTree& tree : points.trees()) {
    walks_.find_nearest(tree.view(), place, list);
  }
  for (const auto& recent : points.recent()) {
    const double squared = core::squared_distance(recent.point, place);
    if (squared <= list.largest_squared) list.offer(recent.point, recent.id, squared);
  }
}

}  // namespace beespace::search
