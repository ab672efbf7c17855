// The sweep: points of one row are compared with the points of the rows around it, many at once.
//
// A kernel works on fixed-point positions and classifies: surely near, surely far, or unsure
// (decided exactly by `Unsure`). So all kernels lead to the same answer. There is one
// set of kernels an instruction set, all compiled from sweep_kernel.hpp.
#pragma once

#include <beespace/point.hpp>

#include <cstdint>

namespace beespace::cpu {

// Sorted positions, as in core::SortedGrid; readable for kPadding elements behind the last.
struct Positions {
  const std::int32_t* x;
  const std::int32_t* y;
  const std::int32_t* z;
  const PointId* id;
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

// Which sides of its row a point lies beside, that is within the reach, and which side a row is
// beyond.
enum Side : unsigned { kLowY = 1, kHighY = 2, kLowZ = 4, kHighZ = 8 };

// A target row: for points that lie beside all these sides of their own row.
struct Target {
  Range points;
  unsigned sides;
};

// Whether a pair is near, and needed.
struct Unsure {
  bool (*decide)(void* context, std::uint32_t asked, std::uint32_t other);
  void* context;
};

struct Sweep {
  Positions asked;
  Positions others;  // the same when a set is swept by itself
  unsigned fraction_bits;
  unsigned row_shift;
  unsigned slice_bits;
  std::int32_t reach_cells;  // the reach on an axis: a cell, or up to the width of a row
  Limits limits;

  bool same_set;  // whether equal ids among asked points and others mean the same point

  Range points;  // the query points: all or some of a row
  Range own;     // all points of that row, where a set is swept by itself
  Target targets[9];
  unsigned target_count;

  Unsure unsure;
};

// What becomes of near pairs. Between two sets the query point records them. Where a set is swept
// by itself, `targets` are the rows of higher numbers, a pair is compared once, and both points
// record it; but counts and nearest ones are taken within a row for each point separately. Arrays
// are indexed by sorted points, less first_asked or first_other; where a set is swept by itself
// they are the same arrays, and can be read and written kPadding beyond.

struct Marks {
  std::uint8_t* asked;  // nonzero: has a near one
  std::uint8_t* others;
  std::uint32_t first_asked;
  std::uint32_t first_other;
};

struct Counts {
  std::uint32_t* asked;
  std::uint32_t* others;
  std::uint32_t first_asked;
  std::uint32_t first_other;
};

// Near pairs by their ids, asked first. `make_room` empties the buffer when fewer than kMostAtOnce
// places are left; it returns whether to go on.
struct PairSink {
  static constexpr std::uint32_t kMostAtOnce = 16;  // as many as the widest lanes

  PointId* first;
  PointId* second;
  std::uint32_t size;
  std::uint32_t capacity;
  bool (*make_room)(void* context);
  void* context;
};

// A box of positions, faces included.
struct PositionBox {
  std::int32_t low[3];
  std::int32_t high[3];
};

// Where positions and ids are written to; may be written for kPadding elements behind the last.
struct PositionsOut {
  std::int32_t* x;
  std::int32_t* y;
  std::int32_t* z;
  PointId* id;
};

// A query point and the others that it is compared with, which stand in any order.
struct RowQuery {
  std::int32_t x;
  std::int32_t y;
  std::int32_t z;
  std::uint32_t asked;  // the query point, for `unsure`
  Positions others;
  Range range;  // of the others
  Limits limits;
  Unsure unsure;
};

// Pairs of sorted places whose balls meet: squared distances in units at most the square of the sum
// of both radii. The limits of the sweep are not used.
struct MeetingSink {
  const float* radius;  // in units, by sorted point; readable for kPadding elements behind the last
  PairSink& places;
};

// The nearest two of all that were compared, near or not: squared distances in units, and the
// nearest one as a sorted point. No point is its own nearest.
struct NearestTable {
  float* best;  // infinite: none
  float* second;
  std::uint32_t* who;
  std::uint32_t first_asked;
};

enum class InstructionSet : std::uint8_t { kBaseline, kAvx2, kAvx512 };

inline constexpr InstructionSet kInstructionSets[] = {
    InstructionSet::kBaseline, InstructionSet::kAvx2, InstructionSet::kAvx512};

struct Kernels {
  // The first of each two is for a set by itself, the other for query points against others. A
  // query point may be among the others itself; that matters only by the sweep's same_set.
  void (*mark)(const Sweep& sweep, const Marks& marks);
  void (*mark_asked)(const Sweep& sweep, const Marks& marks);  // leaves a point once it is marked
  void (*count)(const Sweep& sweep, const Counts& counts);
  void (*count_asked)(const Sweep& sweep, const Counts& counts);
  bool (*collect)(const Sweep& sweep, PairSink& pairs);  // false when make_room said stop
  bool (*collect_asked)(const Sweep& sweep, PairSink& pairs);
  bool (*collect_meeting)(const Sweep& sweep, const MeetingSink& meeting);  // of a set by itself
  void (*nearest)(const Sweep& sweep, const NearestTable& nearest);  // all rows around are targets
  void (*nearest_asked)(const Sweep& sweep, const NearestTable& nearest);

  // One row at a time, without a sweep. These say how many they have found.
  // Those of the first `size` positions that may be within the far limit of a point of the box, in
  // their order.
  std::uint32_t (*pick_around)(const Positions& from, std::uint32_t size, const PositionBox& box,
                               const Limits& limits, const PositionsOut& to);
  // The near ones of a query point, in the order of the others; kPadding ids more may be written.
  std::uint32_t (*count_row)(const RowQuery& query);
  std::uint32_t (*write_row)(const RowQuery& query, PointId* ids);
};

const char* name_of(InstructionSet set);
// Whether this build has the kernels and this processor runs them.
bool is_available(InstructionSet set);
InstructionSet best_instruction_set();
// The kernels of an available instruction set.
const Kernels& kernels(InstructionSet set);

}  // namespace beespace::cpu
