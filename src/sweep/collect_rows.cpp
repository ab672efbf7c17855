#include "sweep/collect_rows.hpp"

#include <algorithm>
#include <atomic>

namespace beespace::cpu {

namespace {

// One worker's rows on their way into chunks.
class RowCollector {
 public:
  RowCollector(core::FoundRows& found, std::atomic<std::uint64_t>& total, std::uint64_t most)
      : found_(found), total_(total), most_(most) {}
  RowCollector(const RowCollector&) = delete;
  RowCollector& operator=(const RowCollector&) = delete;
  ~RowCollector() = default;

  RowSink& open(std::uint32_t* lengths, Which which) {
    const auto make_room = [](void* context) {
      auto& self = *static_cast<RowCollector*>(context);
      const bool go_on = self.close() && !core::is_stopping();
      self.next_chunk();
      return go_on;
    };
    sink_ = {nullptr, 0, 0, lengths, which == Which::kAboveOnly, make_room, this};
    next_chunk();
    return sink_;
  }

  // Returns whether there are not too many yet.
  bool close() {
    chunk_->size = sink_.size;
    return total_.fetch_add(sink_.size, std::memory_order_relaxed) + sink_.size <= most_;
  }

 private:
  void next_chunk() {
    chunk_ = &found_.open_chunk();
    sink_.ids = chunk_->ids.data();
    sink_.size = 0;
    sink_.capacity = chunk_->capacity;
  }

  core::FoundRows& found_;
  std::atomic<std::uint64_t>& total_;
  std::uint64_t most_;
  core::FoundRows::Chunk* chunk_ = nullptr;
  RowSink sink_{};
};

}  // namespace

core::AllFoundRows collect_rows(const SweepQuery& question, Which which,
                                const core::Resources& with, std::uint64_t most,
                                std::uint64_t& total) {
  core::AllFoundRows found(question.asked.grid.size, with);
  std::atomic<std::uint64_t> count = 0;
  with.crew.split(found.size, [&](std::size_t begin, std::size_t end, unsigned worker) {
    if (begin == end) return;
    std::uint32_t* const lengths = found.lengths.data();
    std::fill(lengths + begin, lengths + end, 0U);  // of rows that no sweep asks about
    RowCollector collector(found.parts[worker], count, most);
    RowSink& sink = collector.open(lengths, which);
    RowSweeps(question, decided_by(question), RowSweeps::Around::kOwnRowToo)
        .for_each(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end),
                  [&](const Sweep& sweep) { return question.kernels.collect_rows(sweep, sink); });
    (void)collector.close();
  });
  total = count;
  return found;
}

}  // namespace beespace::cpu
