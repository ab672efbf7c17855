// Found rows of neighbours, and how they are sorted. For crowds, where rows are long: only the ids
// are kept, and each row is sorted separately.
#pragma once

#include "base/buffer.hpp"
#include "base/chunk_places.hpp"
#include "base/resources.hpp"
#include "base/sort_ids.hpp"
#include "base/stopping.hpp"

#include <beespace/point.hpp>

#include <algorithm>
#include <cstdint>

namespace beespace::core {

// The rows of one worker, one behind the other in chunks of memory: a row may go on in the next.
class FoundRows {
 public:
  struct Chunk {
    Buffer<PointId> ids;
    std::uint32_t capacity = 0;
    std::uint32_t size = 0;
  };

  explicit FoundRows(Memory& memory) : memory_(memory), chunks_(&memory) {}
  FoundRows(FoundRows&&) noexcept = default;
  FoundRows(const FoundRows&) = delete;
  FoundRows& operator=(const FoundRows&) = delete;
  FoundRows& operator=(FoundRows&&) = delete;
  ~FoundRows() {
    while (!chunks_.empty()) chunks_.pop_back();  // what was lent last is found first
  }

  // An empty chunk, to be filled and given its size before the next one.
  Chunk& open_chunk() {
    const std::uint32_t places = chunk_places(chunks_.size());
    chunks_.push_back({Buffer<PointId>(memory_, places), places, 0});
    return chunks_.back();
  }

  // Takes row after row.
  class Reader {
   public:
    explicit Reader(const FoundRows& rows) : rows_(rows) {}

    void take(std::size_t count, PointId* to) {
      while (count != 0) {
        const Chunk& chunk = rows_.chunks_[chunk_];
        const std::size_t here = std::min<std::size_t>(count, chunk.size - next_);
        std::copy_n(chunk.ids.data() + next_, here, to);
        to += here;
        count -= here;
        next_ += here;
        if (next_ == chunk.size) {
          ++chunk_;
          next_ = 0;
        }
      }
    }

   private:
    const FoundRows& rows_;
    std::size_t chunk_ = 0;
    std::size_t next_ = 0;
  };

 private:
  Memory& memory_;
  Vector<Chunk> chunks_;
};

// Rows of all workers, each of which found those of its share of the points [0, size).
struct AllFoundRows {
  AllFoundRows(std::size_t points, const Resources& with)
      : size(points), lengths(with.memory, points), parts(&with.memory) {
    parts.reserve(with.crew.size());
    for (unsigned worker = 0; worker < with.crew.size(); ++worker) {
      parts.emplace_back(with.memory.of(worker));
    }
  }

  std::size_t size;
  Buffer<std::uint32_t> lengths;  // by point
  Vector<FoundRows> parts;        // by worker
};

// Calls visit(point, ids, count) with every row in ascending order. By the same crew that found
// them; several workers call it at once.
template <class Visit>
void for_each_row(const AllFoundRows& found, const Resources& with, const Visit& visit) {
  with.crew.split(found.size, [&](std::size_t begin, std::size_t end, unsigned worker) {
    if (begin == end) return;
    const std::uint32_t* const lengths = found.lengths.data();
    const std::size_t longest = *std::max_element(lengths + begin, lengths + end);
    Buffer<PointId> row(with.memory.of(worker), longest);
    Buffer<PointId> spare(with.memory.of(worker), longest);
    FoundRows::Reader reader(found.parts[worker]);
    for (std::size_t point = begin; point < end && !is_stopping(); ++point) {
      reader.take(lengths[point], row.data());
      visit(point, sort_ids(row.data(), spare.data(), lengths[point]), lengths[point]);
    }
  });
}

}  // namespace beespace::core
