// From a file to points in metres, a block after the other: for files that memory does not hold.
//
// Reads text tables, .npy arrays and raw float64, not compressed. Whether positions are degrees or
// metres must be said by the header or by the caller: the values could tell only all together.
#pragma once

#include "io/bytes/byte_source.hpp"
#include "io/points/array_layout.hpp"
#include "io/points/load_options.hpp"
#include "io/table/table_layout.hpp"

#include <beespace/point.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

class PointStream {
 public:
  // Bad records are errors, whatever the options say. Errors: those of load_points; kUnknownFrame
  // where values would have to tell the frame; kUnsupportedFormat for compressed files, and for
  // tables that name their records.
  static Result<PointStream> open(const std::string& path, const LoadOptions& options,
                                  std::size_t block_bytes = std::size_t{1} << 25U);

  [[nodiscard]] Frame frame() const { return options_.frame; }
  [[nodiscard]] const std::string& frame_reason() const { return frame_reason_; }
  [[nodiscard]] const std::string& format_description() const { return format_description_; }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_.view.size(); }

  // All points where they lie in the file, as long as this lives: of arrays in metres.
  [[nodiscard]] std::optional<PointsView> in_place() const;

  // The next points; none at the end. Errors: those of load_points.
  Status next(std::vector<Point>& points);

 private:
  PointStream() = default;

  Status settle_table();
  Status settle_array(Format format);
  Status settle_frame(const FrameEvidence& evidence, bool names_are_enough);
  [[nodiscard]] std::string next_block();
  [[nodiscard]] std::optional<Error> other_layout(std::string_view block) const;
  [[nodiscard]] Error there(Error error) const;
  [[nodiscard]] Error placed(Error error) const;

  std::string path_;
  std::size_t block_bytes_ = 0;
  Bytes bytes_;
  LoadOptions options_;  // of each block
  std::string frame_reason_;
  std::string format_description_;
  std::string_view text_;  // of a table
  std::optional<TableLayout> table_;
  std::optional<ArrayLayout> array_;
  std::size_t at_ = 0;       // in the text, or among the rows
  std::uint64_t rows_ = 0;   // that were read
  std::uint64_t lines_ = 0;  // of the text, that were read
};

}  // namespace beespace::io
