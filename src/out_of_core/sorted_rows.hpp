// Rows of numbers, more than memory holds, in ascending order: sorted in runs, which wait in a
// temporary file and are merged.
#pragma once

#include "out_of_core/block_file.hpp"

#include <beespace/crew.hpp>
#include <beespace/result.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace beespace::out_of_core {

// How much memory the rows may take while they come, and while they are merged.
struct SortMemory {
  std::size_t buffer_bytes;
  std::size_t merge_bytes;
};

// Rows are compared by `<`, by which no two may be the same.
template <class Row>
class SortedRows {
  static_assert(std::is_trivially_copyable_v<Row>);

 public:
  SortedRows(std::string folder, const SortMemory& memory)
      : folder_(std::move(folder)),
        most_(std::max<std::size_t>(memory.buffer_bytes / sizeof(Row), 16)),
        in_block_(std::max<std::size_t>(
            std::clamp(memory.merge_bytes / kRunsAtOnce, kLeastBlock, kLargestBlock) / sizeof(Row),
            1)),
        at_once_(std::max<std::size_t>(memory.merge_bytes / (in_block_ * sizeof(Row)), 2)) {}

  [[nodiscard]] std::uint64_t size() const { return size_; }

  // Until the memory is full, which flush() makes room in.
  void add(const Row& row) {
    // Once: a vector that grows takes up to three times its size.
    if (rows_.capacity() < most_) rows_.reserve(most_);
    rows_.push_back(row);
    ++size_;
  }
  [[nodiscard]] bool full() const { return rows_.size() >= most_; }

  // Brings what waits in memory to the disk. Errors: kWriteFailed, after which nothing else may be
  // done.
  Status flush(Crew& crew) { return rows_.empty() ? Status(std::monostate{}) : write_runs(crew); }

  // Flushes, gives the memory back, and brings runs together until all can be merged at once. To be
  // called before for_each(). Errors: kWriteFailed, kReadFailed, kCorrupt.
  Status settle(Crew& crew) {
    if (auto status = flush(crew); !status) return status;
    std::vector<Row>().swap(rows_);  // `= {}` would keep the memory
    while (runs_.size() > at_once_) {
      if (auto status = merge_runs(); !status) return status;
    }
    return std::monostate{};
  }

  // Calls visit(row) with all of them, ascending, until it returns false. Any number of times.
  // Errors: kReadFailed, kCorrupt.
  template <class Visit>
  Status for_each(Visit&& visit) const {
    return merge(runs_, std::forward<Visit>(visit));
  }

 private:
  using Run = std::vector<BlockFile::Block>;

  // A run in the memory of a block.
  class Reading {
   public:
    Reading(const BlockFile& file, const Run& run) : file_(&file), run_(&run) {}

    // To the next row; false at the end, and where something went wrong.
    bool next(Status& status) {
      if (++at_ < rows_.size()) return true;
      if (block_ == run_->size()) return false;
      const BlockFile::Block& block = (*run_)[block_++];
      rows_.resize(static_cast<std::size_t>(block.bytes) / sizeof(Row));
      at_ = 0;
      status = file_->read(block, std::as_writable_bytes(std::span(rows_)));
      return status.has_value();
    }
    [[nodiscard]] const Row& row() const { return rows_[at_]; }

   private:
    const BlockFile* file_;
    const Run* run_;
    std::vector<Row> rows_;
    std::size_t at_ = 0;
    std::size_t block_ = 0;
  };

  // A run for each worker, which sorts it.
  Status write_runs(Crew& crew) {
    if (!file_) {
      auto made = BlockFile::make(folder_, rows_.size() * sizeof(Row));
      if (!made) return std::move(made).error();
      file_.emplace(*std::move(made));
    }
    std::vector<Run> runs(crew.size());
    std::vector<Status> statuses(crew.size(), Status(std::monostate{}));
    crew.split(rows_.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
      const std::span<Row> part = std::span(rows_).subspan(begin, end - begin);
      if (!std::is_sorted(part.begin(), part.end())) std::sort(part.begin(), part.end());
      statuses[worker] = write(part, *file_, runs[worker]);
    });
    for (unsigned worker = 0; worker < runs.size(); ++worker) {
      if (!statuses[worker]) return statuses[worker];
      if (!runs[worker].empty()) runs_.push_back(std::move(runs[worker]));
    }
    rows_.clear();
    return std::monostate{};
  }

  Status write(std::span<const Row> rows, BlockFile& file, Run& run) const {
    for (std::size_t begin = 0; begin < rows.size(); begin += in_block_) {
      const std::size_t count = std::min(in_block_, rows.size() - begin);
      const auto block = file.append(std::as_bytes(rows.subspan(begin, count)));
      if (!block) return block.error();
      run.push_back(*block);
    }
    return std::monostate{};
  }

  // Of as many runs as can be merged at once one, in another file.
  Status merge_runs() {
    auto file = BlockFile::make(folder_, size_ * sizeof(Row));
    if (!file) return std::move(file).error();
    std::vector<Run> merged;
    for (std::size_t begin = 0; begin < runs_.size(); begin += at_once_) {
      const std::size_t count = std::min(at_once_, runs_.size() - begin);
      Run& run = merged.emplace_back();
      std::vector<Row> waiting;
      waiting.reserve(in_block_);
      Status written = std::monostate{};
      const auto flush = [&] {
        written = write(waiting, *file, run);
        waiting.clear();
        return written.has_value();
      };
      auto status = merge(std::span(runs_).subspan(begin, count), [&](const Row& row) {
        waiting.push_back(row);
        return waiting.size() < in_block_ || flush();
      });
      if (status && written) flush();
      if (!status) return status;
      if (!written) return written;
    }
    file_.emplace(*std::move(file));
    runs_ = std::move(merged);
    return std::monostate{};
  }

  template <class Visit>
  Status merge(std::span<const Run> runs, Visit&& visit) const {
    Status status = std::monostate{};
    std::vector<Reading> readings;
    readings.reserve(runs.size());
    std::vector<Reading*> heap;
    const auto later = [](const Reading* a, const Reading* b) { return b->row() < a->row(); };
    for (const Run& run : runs) {
      Reading& reading = readings.emplace_back(*file_, run);
      if (reading.next(status)) heap.push_back(&reading);
      if (!status) return status;
    }
    std::make_heap(heap.begin(), heap.end(), later);
    while (!heap.empty()) {
      std::pop_heap(heap.begin(), heap.end(), later);
      Reading& first = *heap.back();
      heap.pop_back();
      // As long as no other run has a row before it: often for many.
      bool more = true;
      do {
        if (!visit(first.row())) return std::monostate{};
        more = first.next(status);
        if (!status) return status;
      } while (more && (heap.empty() || first.row() < heap.front()->row()));
      if (!more) continue;
      heap.push_back(&first);
      std::push_heap(heap.begin(), heap.end(), later);
    }
    return std::monostate{};
  }

  static constexpr std::size_t kRunsAtOnce = 256;
  static constexpr std::size_t kLeastBlock = std::size_t{1} << 14U;
  static constexpr std::size_t kLargestBlock = std::size_t{1} << 20U;

  std::string folder_;
  std::size_t most_;      // rows in memory
  std::size_t in_block_;  // rows
  std::size_t at_once_;   // runs
  std::optional<BlockFile> file_;
  std::vector<Row> rows_;
  std::vector<Run> runs_;
  std::uint64_t size_ = 0;
};

}  // namespace beespace::out_of_core
