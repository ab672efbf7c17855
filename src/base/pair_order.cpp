#include "base/pair_order.hpp"

#include "base/stopping.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace beespace::core {

namespace {

constexpr unsigned kMostBucketBits = 12;  // open write streams that the L2 cache bears
constexpr unsigned kPairsABucketBits = 8;
constexpr std::size_t kFewPairs = 24;  // below this, a comparison sort is the fastest

// The same where a bucket has this many times more ids than pairs: counting by id would take more
// time and memory than sorting the pairs.
constexpr std::size_t kSparse = 8;

// With this many pairs an id, rows are too long for comparison sorts.
constexpr std::size_t kLong = 4;

constexpr unsigned kDigitBits = 10;
constexpr std::size_t kDigitValues = std::size_t{1} << kDigitBits;

template <class Visit>
void for_each_pair(const FoundPairs& found, Direction direction, Visit&& visit) {
  for (const FoundPairs::Chunk& chunk : found.chunks()) {
    if (is_stopping()) return;
    const PointId* first = chunk.first.data();
    const PointId* second = chunk.second.data();
    const std::uint32_t size = chunk.size;
    switch (direction) {
      case Direction::kAsFound:
        for (std::uint32_t i = 0; i < size; ++i) visit(Pair{first[i], second[i]});
        break;
      case Direction::kAscending:
        for (std::uint32_t i = 0; i < size; ++i) {
          visit(Pair{std::min(first[i], second[i]), std::max(first[i], second[i])});
        }
        break;
      case Direction::kBothWays:
        for (std::uint32_t i = 0; i < size; ++i) {
          visit(Pair{first[i], second[i]});
          visit(Pair{second[i], first[i]});
        }
        break;
    }
  }
}

// Sorts pairs whose first ids differ in the `low_bits` low bits only.
class BucketOrder {
 public:
  BucketOrder(unsigned low_bits, std::size_t largest, Memory& memory)
      : mask_((std::size_t{1} << low_bits) - 1),
        next_(memory, std::min(mask_, kSparse * largest) + 2),
        spare_(memory, largest) {}

  void sort(Pair* pairs, std::size_t size) {
    if (size <= kFewPairs || mask_ > kSparse * size) return std::sort(pairs, pairs + size);
    if (size > kLong * mask_) return sort_by_digits(pairs, size);
    std::uint64_t* next = next_.data();
    std::fill_n(next, mask_ + 2, std::uint64_t{0});
    for (std::size_t i = 0; i < size; ++i) ++next[(pairs[i].first & mask_) + 1];
    for (std::size_t id = 0; id <= mask_; ++id) next[id + 1] += next[id];
    for (std::size_t i = 0; i < size; ++i) spare_[next[pairs[i].first & mask_]++] = pairs[i];
    std::size_t begin = 0;
    for (std::size_t id = 0; id <= mask_; ++id) {
      const std::size_t end = next[id];
      if (end - begin > 1) sort_by_second(spare_.data() + begin, end - begin);
      begin = end;
    }
    std::copy_n(spare_.data(), size, pairs);
  }

 private:
  // Digit by digit, from the lowest of the second id to the highest of the first.
  void sort_by_digits(Pair* pairs, std::size_t size) {
    PointId highest = 0;
    in_stretches(size, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) highest = std::max(highest, pairs[i].second);
    });
    Pair* from = pairs;
    Pair* to = spare_.data();
    const auto pass = [&](const auto& id_of, unsigned bits) {
      for (unsigned shift = 0; shift < bits; shift += kDigitBits) {
        counting_pass(from, to, size,
                      [&](const Pair& pair) { return id_of(pair) >> shift & (kDigitValues - 1); });
        std::swap(from, to);
      }
    };
    pass([](const Pair& pair) { return pair.second; },
         static_cast<unsigned>(std::bit_width(highest)));
    pass([this](const Pair& pair) { return pair.first & mask_; },
         static_cast<unsigned>(std::bit_width(mask_)));
    if (from == pairs) return;
    in_stretches(size, [&](std::size_t begin, std::size_t end) {
      std::copy(from + begin, from + end, pairs + begin);
    });
  }

  template <class DigitOf>
  static void counting_pass(const Pair* from, Pair* to, std::size_t size, const DigitOf& digit_of) {
    std::array<std::size_t, kDigitValues> next{};
    in_stretches(size, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++next[digit_of(from[i])];
    });
    std::size_t sum = 0;
    for (std::size_t& place : next) sum += std::exchange(place, sum);
    // Once stopped, every stretch is left out: none is written by counts that are incomplete.
    in_stretches(size, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) to[next[digit_of(from[i])]++] = from[i];
    });
  }

  static void sort_by_second(Pair* pairs, std::size_t size) {
    if (size > kFewPairs) {
      std::sort(pairs, pairs + size,
                [](const Pair& a, const Pair& b) { return a.second < b.second; });
      return;
    }
    for (std::size_t i = 1; i < size; ++i) {
      const Pair pair = pairs[i];
      std::size_t place = i;
      for (; place > 0 && pairs[place - 1].second > pair.second; --place) {
        pairs[place] = pairs[place - 1];
      }
      pairs[place] = pair;
    }
  }

  std::size_t mask_;
  Buffer<std::uint64_t> next_;
  Buffer<Pair> spare_;
};

}  // namespace

void order_pairs(const Vector<FoundPairs>& found, Direction direction, std::uint64_t first_ids,
                 const Resources& with, Pair* out, const TakeSorted& take) {
  std::uint64_t size = size_of(found);
  if (direction == Direction::kBothWays) size *= 2;
  if (size == 0) return;

  const auto id_bits = static_cast<unsigned>(std::bit_width(first_ids - 1));
  const auto size_bits = static_cast<unsigned>(std::bit_width(size));
  const unsigned bucket_bits =
      std::min({id_bits, kMostBucketBits, size_bits - std::min(size_bits, kPairsABucketBits)});
  const unsigned low_bits = id_bits - bucket_bits;
  const std::size_t buckets = std::size_t{1} << bucket_bits;

  Vector<std::uint64_t> next(buckets * found.size(), &with.memory);  // [part][bucket]
  // Parts are as many as workers; a worker takes whole parts.
  const auto for_each_part = [&](auto&& task) {
    with.crew.split(found.size(), [&](std::size_t begin, std::size_t end, unsigned) {
      for (std::size_t part = begin; part < end; ++part) task(part);
    });
  };
  for_each_part([&](std::size_t part) {
    std::uint64_t* counts = next.data() + part * buckets;
    for_each_pair(found[part], direction,
                  [=](const Pair& pair) { ++counts[std::uint64_t{pair.first} >> low_bits]; });
  });
  Vector<std::uint64_t> begin_of(buckets + 1, &with.memory);
  std::uint64_t sum = 0;
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    begin_of[bucket] = sum;
    for (std::size_t part = 0; part < found.size(); ++part) {
      sum += std::exchange(next[part * buckets + bucket], sum);
    }
  }
  begin_of[buckets] = sum;
  for_each_part([&](std::size_t part) {
    std::uint64_t* places = next.data() + part * buckets;
    for_each_pair(found[part], direction, [=](const Pair& pair) {
      out[places[std::uint64_t{pair.first} >> low_bits]++] = pair;
    });
  });

  std::uint64_t largest = 0;
  for (std::size_t b = 0; b < buckets; ++b)
    largest = std::max(largest, begin_of[b + 1] - begin_of[b]);
  with.crew.split(size, [&](std::size_t begin, std::size_t end, unsigned worker) {
    if (begin == end) return;
    BucketOrder order(low_bits, largest, with.memory.of(worker));
    // A worker sorts the buckets that start in its share; the last one has empty ones behind it.
    auto bucket = std::lower_bound(begin_of.begin(), begin_of.end() - 1, begin);
    for (; bucket + 1 != begin_of.end() && (*bucket < end || end == size) && !is_stopping();
         ++bucket) {
      order.sort(out + *bucket, bucket[1] - bucket[0]);
      if (!take) continue;
      const auto id = static_cast<std::uint64_t>(bucket - begin_of.begin()) << low_bits;
      const std::uint64_t end_id = id + (std::uint64_t{1} << low_bits);
      take({out, *bucket, bucket[1], std::min(id, first_ids), std::min(end_id, first_ids)});
    }
  });
}

}  // namespace beespace::core
