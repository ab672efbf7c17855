// From a file, or standard input, to points in metres, a block after the other: for what memory
// does not hold.
//
// Reads what load_points() reads, plain or gzip-compressed. Whether positions are degrees or metres
// must be said by the header or by the caller: the values could tell only all together.
#pragma once

#include "io/bytes/byte_source.hpp"
#include "io/bytes/byte_stream.hpp"
#include "io/frames/frame_decision.hpp"
#include "io/frames/frame_witness.hpp"
#include "io/points/array_layout.hpp"
#include "io/points/load_options.hpp"
#include "io/points/loaded_points.hpp"
#include "io/points/zero_points.hpp"
#include "io/table/table_layout.hpp"
#include "io/tracks/sides.hpp"

#include <beespace/points_view.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

class PointStream {
 public:
  // Blocks have about so many bytes, or a line where that is longer. Errors: those of load_points;
  // kUnknownFrame where values would have to tell the frame; kUnsupportedFormat for arrays that lie
  // column by column in what cannot be mapped; kInvalidArgument for arrays of which bad records are
  // to be left out; kReadFailed where the file is written to meanwhile.
  static Result<PointStream> open(const std::string& path, const LoadOptions& options,
                                  std::size_t block_bytes = std::size_t{1} << 25U);

  // What the input was taken for, as load_points() says it; without points and records.
  [[nodiscard]] const LoadedPoints& facts() const { return facts_; }
  // The layout of a table; null of arrays.
  [[nodiscard]] const TableLayout* table() const { return table_ ? &*table_ : nullptr; }
  // How many points there are: of tables an estimate; nothing where nothing tells.
  [[nodiscard]] std::optional<std::uint64_t> likely_size() const { return likely_size_; }
  // How many bytes the file has, where that is known, and how many were read of it.
  [[nodiscard]] std::uint64_t file_bytes() const { return stream_.file().size(); }
  [[nodiscard]] std::uint64_t bytes_read() const;

  // All points where they lie in the file, as long as this lives: of arrays in metres.
  [[nodiscard]] std::optional<PointsView> in_place() const;
  // Of a regular file. Errors: kReadFailed where it was written to since it was opened.
  [[nodiscard]] const std::optional<InputFile::State>& state() const {
    return stream_.file().state();
  }
  [[nodiscard]] Status check_unchanged() const { return stream_.file().check_unchanged(); }

  // The next points and their records, of which the rows are counted from row(), and bad records
  // where these are left out, perhaps no others; nothing at the end. They live as long as this.
  // Errors: those of load_points.
  Result<std::optional<LoadedPoints>> next();
  // How many records came before those of the last block.
  [[nodiscard]] std::uint64_t row() const { return row_; }

 private:
  PointStream(std::string path, const LoadOptions& options, std::size_t block_bytes,
              ByteStream stream);

  Status settle();
  Status settle_table();
  Status settle_array(Format format);
  Status settle_frame(const FrameEvidence& evidence, bool names_are_enough);
  void keep_first(LoadedPoints first);

  // At least so many bytes are pending, unless the input ends before.
  Status want(std::size_t bytes);
  [[nodiscard]] std::string_view pending() const { return pending_->view().substr(at_); }
  Result<Bytes> next_lines();
  Result<std::optional<LoadedPoints>> next_of_table();
  Result<std::optional<LoadedPoints>> next_of_array();
  [[nodiscard]] Result<std::optional<LoadedPoints>> load_rows(std::string_view rows,
                                                              std::uint64_t count) const;
  // Whether zeros were written where no place is known.
  void look_for_zeros(const LoadedPoints& block);
  [[nodiscard]] std::optional<Error> no_place() const;
  // Whether values contradict what names say: all of them, at the end.
  void look_at_values(const LoadedPoints& block);
  [[nodiscard]] std::optional<Error> contradiction() const;
  [[nodiscard]] std::optional<Error> nothing_left() const;
  [[nodiscard]] Error placed(Error error) const;

  std::string path_;
  LoadOptions options_;  // of each block
  std::size_t block_bytes_;
  ByteStream stream_;
  std::unique_ptr<GrowingBytes> pending_ = std::make_unique<GrowingBytes>();
  std::size_t at_ = 0;  // in it
  bool ended_ = false;  // the stream

  LoadedPoints facts_;
  std::optional<std::uint64_t> likely_size_;
  FrameDecision frame_;
  std::optional<TableLayout> table_;           // of the lines that come next
  std::shared_ptr<const std::string> header_;  // that it views
  Sides sides_ = {};
  std::optional<std::size_t> utm_column_;  // of the zone beside eastings and northings
  std::optional<std::string> utm_zone_;
  std::optional<ArrayLayout> array_;
  Bytes mapped_;         // of an array
  bool is_npy_ = false;  // the array

  std::optional<LoadedPoints> first_;  // the first block, as long as it waits
  std::uint64_t row_ = 0;
  std::uint64_t rows_ = 0;    // that were read
  std::uint64_t points_ = 0;  // among these
  std::optional<Error> bad_;  // the first record that was left out
  struct Zero {
    Point at;
    Error error;
  };
  ZeroPoints zeros_;
  std::vector<Zero> first_zeros_;        // the first one of each kind, if it is one
  std::optional<FrameWitness> witness_;  // where values may contradict names
};

}  // namespace beespace::io
