// Boxes and points of doubles, sixteen at a time: which children of a node are near to a box as a
// whole, and which points of two leaves are near to each other.
//
// The arithmetic is that of core::squared_distance and core::BoxTest, operation by operation, so
// their bounds hold for it: what is surely near is, and what is neither surely near nor surely far
// is handed back, to be decided exactly. There is one set of kernels an instruction set, all
// compiled from box_kernel.hpp.
#pragma once

#include "kernels/sweep.hpp"
#include "tree/shell_tree.hpp"

#include <cstdint>

namespace beespace::cpu {

inline constexpr std::uint32_t kBoxLanes = 16;  // points of a leaf, children of a node

// Squares in square metres: below the first is near, above the second is not.
struct BoxLimits {
  double near;
  double far;
};

// Coordinates of sixteen places, [axis * kBoxLanes + lane]: infinite where there is none.
using BoxLanes = const double*;

// The low and the high corners of sixteen boxes; of points, both are the same. Where there is no
// box, its low corner is infinite.
struct BoxRow {
  BoxLanes low;
  BoxLanes high;
};

// Bits of lanes. Those in none of them are far as a whole.
struct BoxesAround {
  std::uint32_t near;    // as a whole
  std::uint32_t open;    // surely neither near nor far as a whole
  std::uint32_t unsure;  // of which rounding hides whether they are near, open or far
};

// Two leaves of points, and how many of each other's points their points are near to.
struct BoxLeaves {
  BoxLanes asked;
  BoxLanes others;
  std::uint32_t rows;                  // the lanes of the asked that are compared, a bit each
  const std::uint32_t* asked_weights;  // by lane: how many points there are; both null: one each
  const std::uint32_t* other_weights;
  std::uint32_t* of_asked;   // is added to, by lane
  std::uint32_t* of_others;  // likewise
  std::uint16_t* unsure;     // is written for these lanes: a bit for each of the others
};

// A place, seen from the centre of a ShellTree, and the square of its distance from it.
struct PlaceAroundCentre {
  double at[3];
  double squared;
};

struct BoxKernels {
  BoxesAround (*look)(const double* low, const double* high, const BoxRow& row,
                      const BoxLimits& limits);
  // Returns whether any pair is unsure; such pairs are not counted.
  bool (*count)(const BoxLeaves& leaves, const BoxLimits& limits);
  // Writes for each child, by lane, what the squared distances of its points from the place are at
  // least; maybe below zero.
  void (*least_squares)(const PlaceAroundCentre& place, const core::ShellRow& row, double* least);
};

const BoxKernels& box_kernels(InstructionSet set);

extern const BoxKernels kBaselineBoxKernels;
extern const BoxKernels kAvx2BoxKernels;
extern const BoxKernels kAvx512BoxKernels;

}  // namespace beespace::cpu
