#include "cli/detect/out_of_core/sorted_rows.hpp"

#include <algorithm>
#include <span>
#include <string_view>

namespace beespace::cli {
namespace {

// A block of each run is in memory while they are merged.
constexpr std::size_t kBlocksInMemory = 64;
constexpr std::size_t kLeastInBlock = 256;
constexpr std::size_t kMostInBlock = std::size_t{1} << 16U;

}  // namespace

// One run, block after block.
class SortedRows::Reading {
 public:
  Reading(const io::ScratchFile& file, const Run& run) : file_(file), run_(run) {}

  // To the next row; false at the end, and where something went wrong.
  bool next(Status& status) {
    if (++at_ < rows_.size()) return true;
    if (block_ == run_.size()) return false;
    const io::ScratchFile::Block& block = run_[block_++];
    rows_.resize(block.size / sizeof(LargeRow));
    at_ = 0;
    auto read = file_.read(block, {reinterpret_cast<char*>(rows_.data()), block.size});
    if (read) return true;
    status = std::move(read);
    return false;
  }
  [[nodiscard]] const LargeRow& row() const { return rows_[at_]; }

 private:
  const io::ScratchFile& file_;
  const Run& run_;
  std::vector<LargeRow> rows_;
  std::size_t at_ = 0;
  std::size_t block_ = 0;
};

SortedRows::SortedRows(std::string folder, std::size_t memory_bytes)
    : folder_(std::move(folder)),
      most_(std::max(memory_bytes / sizeof(LargeRow), kLeastInBlock)),
      in_block_(std::clamp(most_ / kBlocksInMemory, kLeastInBlock, kMostInBlock)) {
}

void SortedRows::add(const LargeRow& row) {
  if (!status_) return;
  // Once: a vector that grows takes up to three times its size.
  if (rows_.capacity() < most_) rows_.reserve(most_);
  rows_.push_back(row);
  ++size_;
  if (rows_.size() == most_) write_run();
}

void SortedRows::write_run() {
  if (!file_) {
    auto made = io::ScratchFile::make(folder_);
    if (!made) {
      status_ = std::move(made).error();
      return;
    }
    file_.emplace(*std::move(made));
  }
  std::sort(rows_.begin(), rows_.end());
  Run& run = runs_.emplace_back();
  for (std::size_t begin = 0; begin < rows_.size(); begin += in_block_) {
    const std::size_t count = std::min(in_block_, rows_.size() - begin);
    const auto block = file_->append(
        {reinterpret_cast<const char*>(rows_.data() + begin), count * sizeof(LargeRow)});
    if (!block) {
      status_ = block.error();
      return;
    }
    run.push_back(*block);
  }
  rows_.clear();
}

void SortedRows::for_each(const std::function<void(const LargeRow&)>& visit) {
  if (!status_) return;
  if (runs_.empty()) {
    std::sort(rows_.begin(), rows_.end());
    for (const LargeRow& row : rows_) visit(row);
    return;
  }
  if (!rows_.empty()) write_run();
  rows_ = {};
  if (status_) merge(visit);
}

void SortedRows::merge(const std::function<void(const LargeRow&)>& visit) {
  std::vector<Reading> readings;
  readings.reserve(runs_.size());
  std::vector<Reading*> heap;
  const auto later = [](const Reading* a, const Reading* b) { return b->row() < a->row(); };
  for (const Run& run : runs_) {
    Reading& reading = readings.emplace_back(*file_, run);
    if (reading.next(status_)) heap.push_back(&reading);
  }
  std::make_heap(heap.begin(), heap.end(), later);
  while (!heap.empty() && status_) {
    std::pop_heap(heap.begin(), heap.end(), later);
    visit(heap.back()->row());
    if (heap.back()->next(status_)) {
      std::push_heap(heap.begin(), heap.end(), later);
    } else {
      heap.pop_back();
    }
  }
}

}  // namespace beespace::cli
