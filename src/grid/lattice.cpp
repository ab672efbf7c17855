#include "grid/lattice.hpp"

#include "base/buffer.hpp"

#include <bit>
#include <cmath>
#include <utility>

namespace beespace::core {

namespace {

constexpr unsigned kMostFractionBits = 22;  // differences of two cells are exact in a float

// Doubles by their bits, which order those of one sign; the others are turned around.
std::uint64_t key_of(double value) {
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return (bits & kSign) != 0 ? ~bits : bits | kSign;
}

// One pass a digit of the keys, least significant first, except for digits that all have in common.
void sort_numbers(Buffer<double>& numbers, std::size_t size, Memory& memory) {
  constexpr unsigned kDigitBits = 11;
  constexpr unsigned kDigits = 6;
  constexpr std::size_t kValues = std::size_t{1} << kDigitBits;
  const auto digit_of = [](double value, unsigned digit) {
    return static_cast<std::size_t>(key_of(value) >> (digit * kDigitBits)) & (kValues - 1);
  };
  Buffer<std::size_t> places(memory, kDigits * kValues);
  std::fill_n(places.data(), kDigits * kValues, std::size_t{0});
  for (std::size_t i = 0; i < size; ++i) {
    for (unsigned digit = 0; digit < kDigits; ++digit) {
      ++places[digit * kValues + digit_of(numbers[i], digit)];
    }
  }
  Buffer<double> spare(memory, size);
  for (unsigned digit = 0; digit < kDigits; ++digit) {
    std::size_t* const next = places.data() + digit * kValues;
    if (size == 0 || next[digit_of(numbers[0], digit)] == size) continue;
    std::size_t sum = 0;
    for (std::size_t value = 0; value < kValues; ++value) sum += std::exchange(next[value], sum);
    for (std::size_t i = 0; i < size; ++i) spare[next[digit_of(numbers[i], digit)]++] = numbers[i];
    std::swap(numbers, spare);
  }
}

double margin_for(double extent, double reach) {
  return std::max(0x1p-20, 0x1p-50 * (extent / reach));
}

}  // namespace

Lattice::Lattice(std::span<const PointsView> sets, const Bounds& bounds, double reach,
                 Memory& memory, std::uint64_t fold_beyond_cells, std::uint64_t most_cells)
    : axes_{Axis(memory), Axis(memory), Axis(memory)}, most_cells_(most_cells) {
  double longest_stretch = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    axes_[axis].low = bounds.low[axis];
    const double extent = bounds.high[axis] - bounds.low[axis];
    if (extent / reach < static_cast<double>(fold_beyond_cells)) {
      longest_stretch = std::max(longest_stretch, extent);
    } else {
      longest_stretch = std::max(longest_stretch, fold(sets, axis, 4.0 * reach, memory));
    }
  }
  cell_m_ = reach * (1.0 + margin_for(longest_stretch, reach));
  while (!count_cells(bounds)) {
    cell_m_ *= 2.0;  // larger cells are as right, only slower
    for (Axis& axis : axes_) join_stretches(axis, 4.0 * cell_m_);
  }
  for (Axis& axis : axes_) {
    if (!axis.folded()) continue;
    number_cells(axis);
    make_guide(axis);
  }

  std::uint64_t most = 1;
  for (const Axis& axis : axes_) most = std::max(most, axis.cells);
  const auto cell_bits = static_cast<unsigned>(std::bit_width(most));
  fraction_bits_ = std::min(kMostFractionBits, 30 - cell_bits);
  units_per_m_ = std::ldexp(1.0, static_cast<int>(fraction_bits_)) / cell_m_;
}

// Cuts the axis wherever no point lies for more than `gap`; returns the longest stretch.
double Lattice::fold(std::span<const PointsView> sets, std::size_t axis, double gap,
                     Memory& memory) {
  std::size_t size = 0;
  for (const PointsView& points : sets) size += points.size();
  Buffer<double> sorted(memory, size);
  std::size_t next = 0;
  for (const PointsView& points : sets) {
    for (std::size_t i = 0; i < points.size(); ++i) sorted[next++] = points.coordinate(axis, i);
  }
  sort_numbers(sorted, size, memory);

  Axis& folded = axes_[axis];
  std::size_t gaps = 0;
  for (std::size_t i = 1; i < size; ++i) gaps += sorted[i] - sorted[i - 1] > gap ? 1U : 0U;
  folded.first.reserve(gaps + 1);
  folded.last.reserve(gaps + 1);
  double longest = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    if (i == 0 || sorted[i] - sorted[i - 1] > gap) {
      folded.first.push_back(sorted[i]);
      folded.last.push_back(sorted[i]);
    }
    folded.last.back() = sorted[i];
    longest = std::max(longest, sorted[i] - folded.first.back());
  }
  return longest;
}

// A stretch takes at least three cells; with larger cells, narrower gaps are cells too.
void Lattice::join_stretches(Axis& axis, double gap) {
  if (!axis.folded()) return;
  std::size_t stretch = 0;
  for (std::size_t i = 1; i < axis.first.size(); ++i) {
    if (axis.first[i] - axis.last[stretch] > gap) axis.first[++stretch] = axis.first[i];
    axis.last[stretch] = axis.last[i];
  }
  axis.first.resize(stretch + 1);
  axis.last.resize(stretch + 1);
}

// One cell more than the quotient says: the last point may be rounded up into it.
std::uint64_t Lattice::cells_of(double extent) const {
  return static_cast<std::uint64_t>(extent / cell_m_) + 2;
}

// Whether they are not too many.
bool Lattice::count_cells(const Bounds& bounds) {
  for (std::size_t i = 0; i < 3; ++i) {
    Axis& axis = axes_[i];
    if (!axis.folded()) {
      axis.cells = cells_of(bounds.high[i] - bounds.low[i]);
    } else {
      axis.cells = 0;
      for (std::size_t stretch = 0; stretch < axis.first.size(); ++stretch) {
        // And an empty one behind it.
        axis.cells += cells_of(axis.last[stretch] - axis.first[stretch]) + 1;
      }
    }
    if (axis.cells > most_cells_) return false;
  }
  return true;
}

void Lattice::number_cells(Axis& axis) const {
  axis.first_cell.resize(axis.first.size());
  std::uint64_t next = 0;
  for (std::size_t stretch = 0; stretch < axis.first.size(); ++stretch) {
    axis.first_cell[stretch] = static_cast<std::uint32_t>(next);
    next += cells_of(axis.last[stretch] - axis.first[stretch]) + 1;
  }
  axis.last.clear();
  axis.last.shrink_to_fit();
}

void Lattice::make_guide(Axis& axis) {
  const auto key_of_first = [&](std::size_t stretch) { return key_of(axis.first[stretch] + 0.0); };
  axis.lowest_key = key_of_first(0);
  const std::uint64_t range = key_of_first(axis.first.size() - 1) - axis.lowest_key;
  const unsigned bits = static_cast<unsigned>(std::bit_width(axis.first.size())) - 1;
  const unsigned range_bits = static_cast<unsigned>(std::bit_width(range));
  axis.key_shift = range_bits > bits ? range_bits - bits : 0;
  axis.guide.resize(static_cast<std::size_t>(range >> axis.key_shift) + 1);
  std::size_t stretch = 0;
  for (std::size_t place = 0; place < axis.guide.size(); ++place) {
    const std::uint64_t lowest = axis.lowest_key + (std::uint64_t{place} << axis.key_shift);
    while (stretch + 1 < axis.first.size() && key_of_first(stretch + 1) <= lowest) ++stretch;
    axis.guide[place] = static_cast<std::uint32_t>(stretch);
  }
}

void Lattice::positions(std::size_t axis, const double* values, std::size_t count,
                        std::int32_t* positions) const {
  const Axis& a = axes_[axis];
  if (a.folded()) {
    for (std::size_t i = 0; i < count; ++i) positions[i] = folded_position(a, values[i]);
    return;
  }
  const double low = a.low;
  const double units_per_m = units_per_m_;
  for (std::size_t i = 0; i < count; ++i) {
    positions[i] = static_cast<std::int32_t>((values[i] - low) * units_per_m);
  }
}

void Lattice::positions(const double* xyz, const std::array<std::size_t, 3>& place,
                        std::size_t count, const std::array<std::int32_t*, 3>& positions) const {
  std::array<double, 3> low{};  // in the order of memory, as all that follows
  std::array<std::int32_t*, 3> to{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[place[axis]] = axes_[axis].low;
    to[place[axis]] = positions[axis];
  }
  // Copies that no store can be suspected of changing.
  const double units_per_m = units_per_m_;
  const double low0 = low[0];
  const double low1 = low[1];
  const double low2 = low[2];
  std::int32_t* const to0 = to[0];
  std::int32_t* const to1 = to[1];
  std::int32_t* const to2 = to[2];
  for (std::size_t i = 0; i < count; ++i) {
    to0[i] = static_cast<std::int32_t>((xyz[3 * i] - low0) * units_per_m);
    to1[i] = static_cast<std::int32_t>((xyz[3 * i + 1] - low1) * units_per_m);
    to2[i] = static_cast<std::int32_t>((xyz[3 * i + 2] - low2) * units_per_m);
  }
}

std::int32_t Lattice::folded_position(const Axis& axis, double value) const {
  // Sums with zero make -0 plain 0, in keys and first coordinates alike.
  const std::uint64_t place = (key_of(value + 0.0) - axis.lowest_key) >> axis.key_shift;
  const std::size_t known = axis.guide.size() - 1;
  const std::uint32_t first_stretch = axis.guide[std::min<std::size_t>(place, known)];
  const std::size_t end = place < known ? axis.guide[place + 1] + 1U : axis.first.size();
  const double* const first = axis.first.data();
  const double* const after = std::upper_bound(first + first_stretch + 1, first + end, value);
  const auto stretch = static_cast<std::size_t>(after - first) - 1;
  return static_cast<std::int32_t>(axis.first_cell[stretch] << fraction_bits_) +
         static_cast<std::int32_t>((value - first[stretch]) * units_per_m_);
}

}  // namespace beespace::core
