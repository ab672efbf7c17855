#include "sweep/join_groups.hpp"

#include "base/buffer.hpp"

#include <array>
#include <numeric>

namespace beespace::cpu {

namespace {

// Pairs of sorted places on their way into the sets.
struct Joining {
  static constexpr std::uint32_t kAtOnce = 1024;

  Joining(const SweepQuery& asking, core::DisjointSets& sets) : question(asking), groups(sets) {}
  Joining(const Joining&) = delete;
  Joining& operator=(const Joining&) = delete;
  ~Joining() = default;

  void join_all() {
    for (std::uint32_t k = 0; k < sink.size; ++k) groups.join(first[k], second[k]);
    sink.size = 0;
  }

  static bool decide(void* context, std::uint32_t i, std::uint32_t j) {
    auto& self = *static_cast<Joining*>(context);
    return self.groups.root(i) != self.groups.root(j) && self.question.decide(i, j);
  }

  const SweepQuery& question;
  core::DisjointSets& groups;
  std::array<PointId, kAtOnce> first;
  std::array<PointId, kAtOnce> second;
  PairSink sink{first.data(),
                second.data(),
                0,
                kAtOnce,
                [](void* context) {
                  static_cast<Joining*>(context)->join_all();
                  return true;
                },
                this};
};

}  // namespace

void join_near(const SweepQuery& question, const core::Resources& with,
               core::DisjointSets& groups) {
  const std::size_t size = question.asked.grid.size;
  // In place of ids: neighbours in space are neighbours in the sets' memory.
  core::Buffer<PointId> places(with.memory, size + core::kPadding);
  std::iota(places.data(), places.data() + size + core::kPadding, PointId{0});
  with.crew.split(size, [&](std::size_t begin, std::size_t end, unsigned) {
    if (begin == end) return;
    Joining joining(question, groups);
    RowSweeps rows(question, {&Joining::decide, &joining});
    rows.for_each(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end),
                  [&](Sweep sweep) {
                    sweep.asked.id = sweep.others.id = places.data();
                    return question.kernels.collect(sweep, joining.sink);
                  });
    joining.join_all();
  });
}

}  // namespace beespace::cpu
