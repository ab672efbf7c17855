// Who may pass whom closely, within a step of time: a sweep over positions in the middle of the
// step and over what everybody moves in half of it.
//
// A kernel only leaves out pairs that surely stay apart; it decides nothing. There is one kernel an
// instruction set, all compiled from passing_kernel.hpp.
#pragma once

#include "cpu/sweep.hpp"

namespace beespace::cpu {

// Of sorted points, in the units of their grid; readable for kPadding elements behind the last.
struct Moves {
  const float* x;  // in half a step, from the middle of it
  const float* y;
  const float* z;
  const float* radius;  // to be kept clear besides the clearance
  const float* reach;  // how far the ball gets from the middle of its step: its move and its radius
};

// How far two must stay apart besides their radii, and how far the farthest of the others reaches.
struct Clearance {
  float clearance;
  float farthest_other;
};

// Emits the ids of the pairs, asked first, that may come closer in the step than the clearance and
// both radii, in units. False when make_room said stop.
using CollectPassing = bool (*)(const Sweep& sweep, const Moves& asked, const Moves& others,
                                const Clearance& clearance, PairSink& pairs);

// Of an available instruction set.
CollectPassing collect_passing(InstructionSet set);

extern const CollectPassing kBaselinePassing;
extern const CollectPassing kAvx2Passing;
extern const CollectPassing kAvx512Passing;

}  // namespace beespace::cpu
