// How many ids a chunk of found ones has room for.
#pragma once

#include <cstddef>
#include <cstdint>

namespace beespace::core {

constexpr std::uint32_t kFirstChunk = 1U << 15;  // what a cache holds, for answers that are short
constexpr std::size_t kFirstChunks = 16;

// Later ones fill a huge page each: in pages of 4 KiB, of tens of millions of pairs, touching new
// memory took a third of the time.
constexpr std::uint32_t kLaterChunk = 1U << 19;

constexpr std::uint32_t chunk_places(std::size_t chunks_before) {
  return chunks_before < kFirstChunks ? kFirstChunk : kLaterChunk;
}

}  // namespace beespace::core
