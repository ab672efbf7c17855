// Found pairs, and how they are sorted.
#pragma once

#include "base/buffer.hpp"
#include "base/resources.hpp"

#include <beespace/pairs.hpp>
#include <beespace/point.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>

namespace beespace::core {

// How many pairs a chunk has room for. Later ones fill huge pages: in pages of 4 KiB, of tens of
// millions of pairs, touching new memory took a third of the time.
inline constexpr std::uint32_t kFirstChunk = 1U << 15;  // what a cache holds
inline constexpr std::size_t kFirstChunks = 16;
inline constexpr std::uint32_t kLaterChunk = 1U << 19;

// Pairs of one worker, in the order in which they were found: first and second ids in arrays of
// their own, a chunk at a time, so that nothing is copied as their number grows.
class FoundPairs {
 public:
  struct Chunk {
    Buffer<PointId> first;
    Buffer<PointId> second;
    std::uint32_t capacity = 0;
    std::uint32_t size = 0;
  };

  explicit FoundPairs(Memory& memory) : memory_(memory), chunks_(&memory) {}
  FoundPairs(FoundPairs&&) noexcept = default;
  FoundPairs(const FoundPairs&) = delete;
  FoundPairs& operator=(const FoundPairs&) = delete;
  FoundPairs& operator=(FoundPairs&&) = delete;
  ~FoundPairs() {
    while (!chunks_.empty()) chunks_.pop_back();  // what was lent last is found first
  }

  // An empty chunk, to be filled and given its size before the next one.
  Chunk& open_chunk() {
    const std::uint32_t places = chunks_.size() < kFirstChunks ? kFirstChunk : kLaterChunk;
    chunks_.push_back(
        {Buffer<PointId>(memory_, places), Buffer<PointId>(memory_, places), places, 0});
    return chunks_.back();
  }

  [[nodiscard]] const Vector<Chunk>& chunks() const { return chunks_; }
  // Ids are those of other points from now on.
  template <class IdOf>
  void renumber(const IdOf& id_of) {
    for (Chunk& chunk : chunks_) {
      for (std::uint32_t i = 0; i < chunk.size; ++i) {
        chunk.first[i] = id_of(chunk.first[i]);
        chunk.second[i] = id_of(chunk.second[i]);
      }
    }
  }
  [[nodiscard]] std::uint64_t size() const {
    std::uint64_t size = 0;
    for (const Chunk& chunk : chunks_) size += chunk.size;
    return size;
  }

 private:
  Memory& memory_;
  Vector<Chunk> chunks_;
};

// The pairs of all workers.
inline std::uint64_t size_of(const Vector<FoundPairs>& found) {
  std::uint64_t size = 0;
  for (const FoundPairs& part : found) size += part.size();
  return size;
}

// The order of the ids in a written pair.
enum class Direction : std::uint8_t {
  kAsFound,    // (a, b)
  kAscending,  // (lower, higher)
  kBothWays,   // (a, b) and (b, a)
};

// Some of the pairs that are written, in their final order and place.
struct SortedPairs {
  const Pair* pairs;  // the first of all, of these and of others
  std::size_t begin;  // these
  std::size_t end;
  std::uint64_t first_id;  // all pairs whose first ids are in [first_id, end_id), and no others
  std::uint64_t end_id;
};

// One of them; also where what took the ones before has written something else over these.
inline Pair pair_at(const Pair* pairs, std::size_t i) {
  Pair pair;
  std::memcpy(&pair, pairs + i, sizeof pair);
  return pair;
}

// Sees them while they are in the nearest cache, and may overwrite them. Called by several workers
// at once; if there is any pair, the calls share all ids below `first_ids` among them.
using TakeSorted = std::function<void(const SortedPairs&)>;

// Writes the pairs of all workers in ascending order; `first_ids` is above every first id. `out`
// has room for all of them (twice for kBothWays). Cost: one scatter of 8 bytes a pair, then buckets
// of a few hundred in the nearest cache. Working memory: 8 bytes for each pair of the fullest
// bucket.
void order_pairs(const Vector<FoundPairs>& found, Direction direction, std::uint64_t first_ids,
                 const Resources& with, Pair* out, const TakeSorted& take = {});

}  // namespace beespace::core
