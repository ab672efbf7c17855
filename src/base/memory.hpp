// Working memory that is kept: blocks that a search gives back are reused by the next one.
//
// During its first call it keeps only blocks that the same call can reuse: a single search should
// not hold the memory of all its steps at once.
//
// A memory resource for Buffer and the std::pmr containers. Thread-safe. Large blocks are aligned
// to huge pages and ask for them: 512 times fewer page faults when the memory is new, and scattered
// writes that do not miss the translation buffer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <memory_resource>
#include <mutex>
#include <vector>

namespace beespace::core {

// Requests huge pages where the system has them: a hint, on which no result depends.
void advise_huge_pages(void* data, std::size_t bytes);

// A block of uninitialised memory from the system, and back to it.
void* allocate_block(std::size_t bytes);
void free_block(void* data, std::size_t bytes);

// After about so many bytes were freed: gives what the allocator keeps of them back to the system,
// where it can.
void trim_freed_memory(std::size_t bytes);

class Memory final : public std::pmr::memory_resource {
 public:
  Memory();
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;
  ~Memory() override;

  // The memory resource of one thread of a crew: its own, so that its blocks do not depend on what
  // other threads allocate meanwhile. Worker 0, the caller, uses this one.
  Memory& of(unsigned worker);

  // Must be called at the start of each search. Also returns blocks that recent searches have not
  // used to the system, so that a swarm that grows from frame to frame does not keep all smaller
  // blocks.
  void start_call();

  // Gives all unused blocks back to the system, so that the process has less memory then.
  void release();

  // From now on the unused blocks of a thread go back to the system where one more would make it
  // more than so many bytes, used and unused.
  void bound(std::size_t bytes);

 private:
  struct Block {
    void* data;
    std::size_t bytes;
    std::uint64_t last_call;
  };

  // These say how many bytes it was.
  std::size_t free_all_kept();
  std::size_t free_kept();
  // Whether one more of so many bytes would be too much.
  [[nodiscard]] bool is_full(std::size_t bytes) const;

  void* do_allocate(std::size_t bytes, std::size_t alignment) override;
  void do_deallocate(void* data, std::size_t bytes, std::size_t alignment) override;
  [[nodiscard]] std::size_t find_kept(std::size_t bytes) const;
  [[nodiscard]] bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override {
    return this == &other;
  }

  std::mutex mutex_;
  std::uint64_t calls_ = 0;
  std::size_t most_ = SIZE_MAX;  // bytes of kept_ and lent_
  std::vector<Block> kept_;      // unused, for the next allocation
  std::vector<Block> lent_;
  std::vector<std::unique_ptr<Memory>> of_workers_;
};

}  // namespace beespace::core
