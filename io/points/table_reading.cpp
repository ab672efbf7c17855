#include "io/points/table_reading.hpp"

#include "io/bytes/worker_threads.hpp"
#include "io/points/piece_reading.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <cstring>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace beespace::io {
namespace {

struct Piece {
  std::uint64_t number = 0;
  std::string_view text = {};
};

// Large pages, where the system has them to give: first touches then cost a tenth.
void advise_huge_pages(Point* begin, std::size_t count) {
#if defined(MADV_HUGEPAGE)
  constexpr std::size_t kPage = std::size_t{1} << 21;
  void* first = begin;
  std::size_t size = count * sizeof(Point);
  if (std::align(kPage, kPage, first, size) == nullptr) return;
  ::madvise(first, size / kPage * kPage, MADV_HUGEPAGE);
#endif
}

class TableReading {
 public:
  TableReading(std::string_view text, const TableLayout& layout, const TableOptions& options)
      : text_(text), layout_(layout), options_(options), position_(layout.data_offset) {}

  void work() {
    const PieceOptions options{options_.frame, options_.skip_bad, options_.fast_path};
    PieceContent content;
    try {
      while (const auto piece = take()) {
        read_piece(piece->text, text_.data() + text_.size(), layout_, options, content);
        if (!append(*piece, content)) return;
      }
    } catch (...) {
      stop();  // or the others would wait for this piece
      throw;
    }
  }

  Result<TableContent> finish() {
    if (error_) return *std::move(error_);
    return std::move(content_);
  }

 private:
  // The next piece: about piece_bytes, up to the end of a line. Only the line that crosses the
  // end is searched, so even a single endless line is searched once.
  std::optional<Piece> take() {
    const std::lock_guard lock(mutex_);
    if (stopped_ || position_ >= text_.size()) return std::nullopt;
    const std::size_t begin = position_;
    position_ = text_.size();
    if (text_.size() - begin > options_.piece_bytes) {
      const std::size_t crossing = begin + options_.piece_bytes - 1;
      const void* const found =
          std::memchr(text_.data() + crossing, layout_.line_end, text_.size() - crossing);
      if (found != nullptr) {
        position_ = static_cast<std::size_t>(static_cast<const char*>(found) - text_.data()) + 1;
      }
    }
    return Piece{taken_++, text_.substr(begin, position_ - begin)};
  }

  // Waits for the pieces before this one; false when reading has come to an end.
  bool append(const Piece& piece, PieceContent& content) {
    std::unique_lock lock(mutex_);
    turn_.wait(lock, [&] { return stopped_ || appended_ == piece.number; });
    if (stopped_) return false;
    const std::uint64_t lines_before = layout_.lines_before + lines_;
    const auto placed = [&](Error& error) {
      if (error.location.line) *error.location.line += lines_before;
      if (error.location.record) *error.location.record += rows_;
    };
    if (content.error) {
      placed(*content.error);
      error_ = std::move(content.error);
    } else if (content_.points.size() + content.points.size() > kMaxPoints) {
      error_ = Error{ErrorCode::kTooManyPoints,
                     "more than 4,294,963,200 points; split the file into parts",
                     {}};
    }
    if (error_) {
      stopped_ = true;
      turn_.notify_all();
      return false;
    }
    for (Error& error : content.skipped.errors) placed(error);
    for (std::uint64_t& row : content.skipped.rows) row += rows_;
    content_.skipped.merge(std::move(content.skipped));
    take_points(piece, content);
    rows_ += content.rows;
    lines_ += content.lines;
    content_.headers += content.headers;
    if (options_.progress != nullptr) options_.progress->done += piece.text.size();
    ++appended_;
    turn_.notify_all();
    return true;
  }

  void take_points(const Piece& piece, const PieceContent& content) {
    auto& points = content_.points;
    content_.extent.include(content.extent);
    const std::size_t wanted = points.size() + content.points.size();
    if (wanted > points.capacity()) {
      // Room for the whole file, judged by this piece. What is not used is never touched.
      const auto behind = static_cast<std::size_t>(text_.data() + text_.size() -
                                                   (piece.text.data() + piece.text.size()));
      const double density =
          static_cast<double>(content.points.size()) / static_cast<double>(piece.text.size());
      points.reserve(wanted +
                     static_cast<std::size_t>(1.2 * density * static_cast<double>(behind)));
      advise_huge_pages(points.data(), points.capacity());
    }
    points.insert(points.end(), content.points.begin(), content.points.end());
  }

  void stop() {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    turn_.notify_all();
  }

  const std::string_view text_;
  const TableLayout& layout_;
  const TableOptions& options_;

  std::mutex mutex_;
  std::condition_variable turn_;
  std::size_t position_;
  std::uint64_t taken_ = 0;
  std::uint64_t appended_ = 0;
  std::uint64_t lines_ = 0;
  std::uint64_t rows_ = 0;
  bool stopped_ = false;
  std::optional<Error> error_;
  TableContent content_;
};

}  // namespace

Result<TableContent> read_table(std::string_view text, const TableLayout& layout,
                                const TableOptions& options) {
  const std::size_t pieces = (text.size() - layout.data_offset) / options.piece_bytes + 1;
  const auto threads =
      static_cast<unsigned>(std::min<std::size_t>(thread_count(options.threads), pieces));
  TableReading reading(text, layout, options);
  run_on_threads(threads, [&reading](unsigned) { reading.work(); });
  return reading.finish();
}

}  // namespace beespace::io
