#include "tests/support/allocation_count.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::uint64_t> asked_for = 0;
std::atomic<std::uint64_t> given_back = 0;

void* counted(std::size_t bytes, std::size_t alignment) noexcept {
  ++asked_for;
  if (bytes == 0) bytes = 1;
  if (alignment <= __STDCPP_DEFAULT_NEW_ALIGNMENT__) return std::malloc(bytes);
  if (bytes > SIZE_MAX - alignment) return nullptr;
  return std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

void* counted_or_throw(std::size_t bytes, std::size_t alignment) {
  void* const data = counted(bytes, alignment);
  if (data == nullptr) throw std::bad_alloc();
  return data;
}

void give_back(void* data) noexcept {
  if (data != nullptr) ++given_back;
  std::free(data);
}

constexpr std::size_t number_of(std::align_val_t alignment) {
  return static_cast<std::size_t>(alignment);
}

}  // namespace

namespace beespace::test {

std::uint64_t allocations() {
  return asked_for;
}

std::uint64_t blocks_held() {
  return asked_for - given_back;
}

}  // namespace beespace::test

void* operator new(std::size_t bytes) {
  return counted_or_throw(bytes, 1);
}
void* operator new[](std::size_t bytes) {
  return counted_or_throw(bytes, 1);
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return counted_or_throw(bytes, number_of(alignment));
}
void* operator new[](std::size_t bytes, std::align_val_t alignment) {
  return counted_or_throw(bytes, number_of(alignment));
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return counted(bytes, 1);
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
  return counted(bytes, 1);
}
void* operator new(std::size_t bytes, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return counted(bytes, number_of(alignment));
}
void* operator new[](std::size_t bytes, std::align_val_t alignment,
                     const std::nothrow_t&) noexcept {
  return counted(bytes, number_of(alignment));
}

void operator delete(void* data) noexcept {
  give_back(data);
}
void operator delete[](void* data) noexcept {
  give_back(data);
}
void operator delete(void* data, std::size_t) noexcept {
  give_back(data);
}
void operator delete[](void* data, std::size_t) noexcept {
  give_back(data);
}
void operator delete(void* data, std::align_val_t) noexcept {
  give_back(data);
}
void operator delete[](void* data, std::align_val_t) noexcept {
  give_back(data);
}
void operator delete(void* data, std::size_t, std::align_val_t) noexcept {
  give_back(data);
}
void operator delete[](void* data, std::size_t, std::align_val_t) noexcept {
  give_back(data);
}
void operator delete(void* data, const std::nothrow_t&) noexcept {
  give_back(data);
}
void operator delete[](void* data, const std::nothrow_t&) noexcept {
  give_back(data);
}
void operator delete(void* data, std::align_val_t, const std::nothrow_t&) noexcept {
  give_back(data);
}
void operator delete[](void* data, std::align_val_t, const std::nothrow_t&) noexcept {
  give_back(data);
}
