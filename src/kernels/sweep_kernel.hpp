// All kernels of one instruction set, by its Lanes (see sweep_lanes.hpp).
#pragma once

#include "kernels/block_sweep_kernel.hpp"
#include "kernels/block_tasks.hpp"
#include "kernels/point_sweep_kernel.hpp"
#include "kernels/row_kernel.hpp"
#include "kernels/sweep.hpp"

namespace beespace::cpu {
namespace {

template <class Lanes>
constexpr Kernels kernels_over() {
  return {
      [](const Sweep& sweep, const Marks& marks) {
        (void)sweep_blocks<Lanes>(sweep, MarkBoth<Lanes>(marks));
      },
      [](const Sweep& sweep, const Marks& marks) {
        (void)sweep_points<Lanes>(sweep, MarkAsked<Lanes>(marks));
      },
      [](const Sweep& sweep, const Counts& counts) {
        (void)sweep_blocks<Lanes>(sweep, CountBoth<Lanes>(counts));
      },
      [](const Sweep& sweep, const Counts& counts) {
        (void)sweep_points<Lanes>(sweep, CountAsked<Lanes>(counts));
      },
      [](const Sweep& sweep, PairSink& pairs) {
        return sweep_blocks<Lanes>(sweep, CollectOnce<Lanes>(sweep, pairs));
      },
      [](const Sweep& sweep, PairSink& pairs) {
        return sweep_points<Lanes>(sweep, CollectAsked<Lanes>(pairs));
      },
      [](const Sweep& sweep, const MeetingSink& meeting) {
        return sweep_blocks<Lanes>(sweep, CollectMeeting<Lanes>(meeting));
      },
      [](const Sweep& sweep, const NearestTable& nearest) {
        (void)sweep_blocks<Lanes>(sweep, KeepNearestOfAll<Lanes>(nearest));
      },
      [](const Sweep& sweep, const NearestTable& nearest) {
        (void)sweep_points<Lanes>(sweep, KeepNearestOfAsked<Lanes>(nearest));
      },
      pick_around<Lanes>,
      count_row<Lanes>,
      write_row<Lanes>,
  };
}

}  // namespace
}  // namespace beespace::cpu
