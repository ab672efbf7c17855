// Arrays of coordinates in binary: NumPy's .npy files, and raw float64.
//
// Nothing is copied: the layout says where in the bytes coordinate (row, axis) lies.
#pragma once

#include "io/units/units.hpp"

#include <beespace/result.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

struct ArrayLayout {
  std::string_view data = {};
  std::uint64_t rows = 0;
  std::size_t item_bytes = 8;     // 8: float64, 4: float32, little-endian
  bool column_by_column = false;  // Fortran order: all x, then all y, then all z
  std::string description = {};   // "npy float64 (1000, 3)"
  std::array<Unit, 3> units = {Unit::kMetre, Unit::kMetre, Unit::kMetre};

  [[nodiscard]] double coordinate(std::uint64_t row, std::size_t axis) const;
  // As short as it can be written without changing its value.
  [[nodiscard]] std::string coordinate_text(std::uint64_t row, std::size_t axis) const;
};

// By the first bytes, as many as there are.
bool is_npy(std::string_view bytes);

// Versions 1 to 3, `<f8` or `<f4`, shape (N, 3). Errors: kUnsupportedFormat, kTruncated, kCorrupt,
// kNoPoints; without source.
Result<ArrayLayout> npy_layout(std::string_view bytes);

// The same of the beginning of such a file, which has all of its header; `data` is what it has
// behind that. Errors: but kTruncated of the data, and kCorrupt of its length.
Result<ArrayLayout> npy_beginning(std::string_view bytes);

// What is wrong where so many bytes of data were found: kTruncated, kCorrupt, kNoPoints.
std::optional<Error> npy_length_problem(const ArrayLayout& layout, std::uint64_t data_bytes);
std::optional<Error> raw_length_problem(std::uint64_t data_bytes);

// The beginning of a version 1 file with so many rows of such numbers; the data follows it.
std::string npy_header_for(const ArrayLayout& layout, std::uint64_t rows);

// x0 y0 z0 x1 y1 z1 ... Errors: kTruncated, kNoPoints; without source.
Result<ArrayLayout> raw_layout(std::string_view bytes);

}  // namespace beespace::io
