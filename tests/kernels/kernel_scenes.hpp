// What tests of kernels share: scenes of all shapes, and what plain double arithmetic says of them.
#pragma once

#include "kernels/sweep.hpp"
#include "tests/kernels/sweep_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <sstream>
#include <utility>
#include <vector>

namespace beespace::cpu {

using test::SweepScene;
using test::SweepShape;
using PlacePairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // asked, other

// A fixed verdict on pairs that a kernel is unsure of.
inline bool decided_near(std::uint32_t i, std::uint32_t j) {
  return (i + j) % 3 == 0;
}

class KernelScenes : public testing::TestWithParam<InstructionSet> {
 protected:
  [[nodiscard]] static const Kernels& kernels() { return cpu::kernels(GetParam()); }
  [[nodiscard]] static auto collect(bool by_itself) {
    return by_itself ? kernels().collect : kernels().collect_asked;
  }

  // Scenes of all shapes: rows shorter and longer than lanes and blocks, narrow and wide ones, of
  // a unit a cell and of as many as there can be.
  template <class Check>
  static void for_each_scene(bool by_itself, Check&& check) {
    for_each_scene(by_itself, false, check);
  }
  template <class Check>
  static void for_each_scene(bool by_itself, bool all_rows, Check&& check) {
    std::uint32_t seed = 0;
    for (const unsigned row_shift : {0U, 1U, 3U}) {
      for (const unsigned fraction_bits : {0U, 1U, 10U, 22U}) {
        for (const std::int32_t cells_along_x : {2, 12}) {
          for (std::uint32_t row_size = 1; row_size <= 33; ++row_size) {
            // One cell, or as many as a row is wide.
            const std::int32_t reach_cells = ++seed % 3 == 0 ? 1 << row_shift : 1;
            run({by_itself, all_rows, fraction_bits, row_shift, cells_along_x, row_size,
                 reach_cells},
                seed, check);
          }
        }
      }
      run({by_itself, all_rows, 10, row_shift, 40, 700}, ++seed, check);
    }
  }

  // Distances up to the reach: the kernel may ignore points that are farther. Where a unit is finer
  // than a float resolves, no distance comes near a limit.
  static Limits limits_of(const SweepShape& shape) {
    const double share = shape.fraction_bits > 10 ? 0.97 : 1.0;
    return {static_cast<float>(0.3 * shape.squared_reach()),
            static_cast<float>(share * shape.squared_reach())};
  }

 private:
  template <class Check>
  static void run(const SweepShape& shape, std::uint32_t seed, Check&& check) {
    if (HasFatalFailure()) return;
    SweepScene scene = test::random_sweep_scene(shape, seed);
    if (seed % 4 == 0) scene.points.begin += shape.row_size / 3;
    if (seed % 4 == 1) scene.points.end -= shape.row_size / 2;
    std::ostringstream described;
    described << shape;
    SCOPED_TRACE(described.str());
    check(scene);
  }
};

struct Found {
  PlacePairs near;
  PlacePairs unsure;

  // The near ones, with those of the unsure that are decided to be.
  [[nodiscard]] PlacePairs all_near() const {
    PlacePairs all = near;
    std::copy_if(unsure.begin(), unsure.end(), std::back_inserter(all),
                 [](const auto& pair) { return decided_near(pair.first, pair.second); });
    std::sort(all.begin(), all.end());
    return all;
  }
};

inline Found expected_of(const SweepScene& scene, const Limits& limits,
                         bool each_for_itself = false) {
  Found found;
  const auto add = [&](std::uint32_t i, std::uint32_t j, double squared) {
    if (squared < static_cast<double>(limits.near)) {
      found.near.emplace_back(i, j);
    } else if (squared <= static_cast<double>(limits.far)) {
      found.unsure.emplace_back(i, j);
    }
  };
  if (each_for_itself) {
    scene.for_each_pair_of_asked(add);
  } else {
    scene.for_each_pair(add);
  }
  std::sort(found.near.begin(), found.near.end());
  std::sort(found.unsure.begin(), found.unsure.end());
  return found;
}

// Remembers what a kernel was unsure of, and decides it: some of it is near.
struct Open {
  PlacePairs pairs;

  Unsure unsure() {
    return {[](void* context, std::uint32_t i, std::uint32_t j) {
              static_cast<Open*>(context)->pairs.emplace_back(i, j);
              return decided_near(i, j);
            },
            this};
  }
  const PlacePairs& sorted() {
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }
};

inline std::vector<InstructionSet> available() {
  std::vector<InstructionSet> sets;
  for (const InstructionSet set : kInstructionSets) {
    if (is_available(set)) sets.push_back(set);
  }
  return sets;
}

}  // namespace beespace::cpu
