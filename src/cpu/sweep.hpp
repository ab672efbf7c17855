// The sweep: every pair of points in adjacent cells is looked at once, many pairs an instruction.
//
// A kernel works on fixed-point positions and classifies: surely near (marks both points), surely
// far, or unsure (handed to `Unsure`, which decides exactly). So all kernels lead to the same
// answer. There is one kernel an instruction set, all compiled from sweep_kernel.hpp.
#pragma once

#include <cstdint>

namespace beespace::cpu {

// Sorted positions, as in core::SortedGrid; readable for kPadding elements behind the last.
struct Positions {
  const std::int32_t* x;
  const std::int32_t* y;
  const std::int32_t* z;
  unsigned fraction_bits;
};

// Squared distances in units: below `near` a pair is surely within the threshold, above `far`
// surely not.
struct Limits {
  float near;
  float far;
};

struct Range {
  std::uint32_t begin;
  std::uint32_t end;
};

// The forward half of a row's neighbourhood. Rows are long or short: along a long row a window of
// three cells is followed; short rows that stand together are looked at whole, as one.
struct Neighbourhood {
  Range row;
  std::uint32_t own_end;  // the row's points are compared with those behind them, up to here:
                          // row.end, or the end of the next row if the two are short
  Range together;         // short later rows, possibly none
  Range later[4];         // long later rows
  unsigned later_count;
};

struct Unsure {
  void (*decide)(void* context, std::uint32_t i, std::uint32_t j);
  void* context;
};

// Marks the points of the neighbourhood that are near another one: near_marks[i - first_mark]
// becomes nonzero for sorted point i. Marks are readable and writable for kPadding behind the last.
using SweepKernel = void (*)(const Positions& positions, const Neighbourhood& neighbourhood,
                             const Limits& limits, std::uint8_t* near_marks,
                             std::uint32_t first_mark, const Unsure& unsure);

enum class InstructionSet : std::uint8_t { kBaseline, kAvx2, kAvx512 };

inline constexpr InstructionSet kInstructionSets[] = {
    InstructionSet::kBaseline, InstructionSet::kAvx2, InstructionSet::kAvx512};

const char* name_of(InstructionSet set);
// Whether this build has the kernels and this processor runs them.
bool is_available(InstructionSet set);
InstructionSet best_instruction_set();
// The kernel of an available instruction set.
SweepKernel sweep_kernel(InstructionSet set);

}  // namespace beespace::cpu
