#include "sweep/collect_pairs.hpp"

#include "base/stopping.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>

namespace beespace::cpu {

namespace {

// Runs the collecting kernel over the sorted points [begin, end). `sink` takes the pairs.
void collect(const SweepQuery& question, std::uint32_t begin, std::uint32_t end, PairSink& sink) {
  const Kernels& kernels = question.kernels;
  const auto kernel = question.by_itself() ? kernels.collect : kernels.collect_asked;
  RowSweeps(question, decided_by(question)).for_each(begin, end, [&](const Sweep& sweep) {
    return kernel(sweep, sink);
  });
}

class PairCollector {
 public:
  PairCollector(core::FoundPairs& found, std::atomic<std::uint64_t>& total, std::uint64_t most)
      : found_(found), total_(total), most_(most) {
    open();
  }
  PairCollector(const PairCollector&) = delete;
  PairCollector& operator=(const PairCollector&) = delete;
  ~PairCollector() = default;

  PairSink& sink() { return sink_; }

  bool close() {
    chunk_->size = sink_.size;
    return total_.fetch_add(sink_.size, std::memory_order_relaxed) + sink_.size <= most_;
  }

 private:
  void open() {
    chunk_ = &found_.open_chunk();
    const auto make_room = [](void* context) {
      auto& self = *static_cast<PairCollector*>(context);
      const bool go_on = self.close() && !core::is_stopping();
      self.open();
      return go_on;
    };
    sink_ = {chunk_->first.data(), chunk_->second.data(), 0, chunk_->capacity, make_room, this};
  }

  core::FoundPairs& found_;
  std::atomic<std::uint64_t>& total_;
  std::uint64_t most_;
  core::FoundPairs::Chunk* chunk_ = nullptr;
  PairSink sink_{};
};

// One worker's batch on its way to a visitor that all workers share.
struct Show {
  struct Audience {
    const PairVisitor& visit;
    std::mutex mutex = {};
    bool open = true;
  };

  explicit Show(Audience& shared) : audience(shared) {}

  bool show() {
    std::array<Pair, kMostPairsAtOnce> batch;
    for (std::uint32_t k = 0; k < sink.size; ++k) {
      batch[k] = {std::min(first[k], second[k]), std::max(first[k], second[k])};
    }
    const std::span<const Pair> pairs(batch.data(), sink.size);
    sink.size = 0;
    const std::lock_guard lock(audience.mutex);
    if (audience.open && !pairs.empty()) audience.open = audience.visit(pairs);
    return audience.open;
  }

  Audience& audience;
  std::array<PointId, kMostPairsAtOnce> first;
  std::array<PointId, kMostPairsAtOnce> second;
  PairSink sink{first.data(),
                second.data(),
                0,
                static_cast<std::uint32_t>(kMostPairsAtOnce),
                [](void* context) { return static_cast<Show*>(context)->show(); },
                this};
};

}  // namespace

core::Vector<core::FoundPairs> collect_pairs(const SweepQuery& question,
                                             const core::Resources& with, std::uint64_t most) {
  core::Vector<core::FoundPairs> found(&with.memory);
  found.reserve(with.crew.size());
  for (unsigned worker = 0; worker < with.crew.size(); ++worker) {
    found.emplace_back(with.memory.of(worker));
  }
  std::atomic<std::uint64_t> total = 0;
  with.crew.split(question.asked.grid.size,
                  [&](std::size_t begin, std::size_t end, unsigned worker) {
                    if (begin == end) return;
                    PairCollector collector(found[worker], total, most);
                    collect(question, static_cast<std::uint32_t>(begin),
                            static_cast<std::uint32_t>(end), collector.sink());
                    (void)collector.close();
                  });
  return found;
}

bool show_pairs(const SweepQuery& question, const core::Resources& with, const PairVisitor& visit) {
  Show::Audience audience{visit};
  with.crew.split(question.asked.grid.size, [&](std::size_t begin, std::size_t end, unsigned) {
    if (begin == end) return;
    Show show(audience);
    collect(question, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end),
            show.sink);
    (void)show.show();
  });
  return audience.open;
}

}  // namespace beespace::cpu
