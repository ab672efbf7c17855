// Structures whose first field is their size: read and written whatever the version of the caller's
// header.
#pragma once

#include "c/door/door.hpp"

#include <beespace/result.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace beespace::c {

template <class Type>
bool is_aligned(const Type* pointer) {
  return reinterpret_cast<std::uintptr_t>(pointer) % alignof(Type) == 0;
}

// No version of any structure will be as large: a size beyond it was never set.
inline constexpr std::size_t kLargestStruct = 4096;

template <class Struct>
std::size_t size_of_struct(const Struct* given) {
  std::size_t size = 0;
  std::memcpy(&size, given, sizeof size);
  return size;
}

// A copy of the caller's structure. A later version may be longer: what this one does not know must
// be zero, which asks for nothing. An earlier one, of `least` bytes or more, asks for nothing of
// what it does not know.
template <class Struct>
Result<Struct> read_struct(const Struct* given, const char* name,
                           std::size_t least = sizeof(Struct)) {
  if (given == nullptr) return invalid("the pointer to this structure is NULL", name);
  const std::size_t size = size_of_struct(given);
  if (size < least || size > kLargestStruct) {
    return invalid("struct_size is not the size of this structure: set it to sizeof", name);
  }
  const auto* const bytes = reinterpret_cast<const unsigned char*>(given);
  const std::size_t known = std::min(size, sizeof(Struct));
  if (std::any_of(bytes + known, bytes + size, [](auto byte) { return byte != 0; })) {
    return invalid("the structure is of a later version, and asks for what this one cannot do",
                   name);
  }
  Struct copy{};
  std::memcpy(&copy, given, known);
  if (copy.reserved != 0) return invalid("the reserved field of this structure is not zero", name);
  return copy;
}

// Fills the caller's structure. Of a later version, what this one does not know becomes zero; of an
// earlier one, of `least` bytes or more, there is no place for what it does not know.
template <class Struct>
Status write_struct(Struct* given, Struct value, const char* name,
                    std::size_t least = sizeof(Struct)) {
  if (given == nullptr) return invalid("the pointer to this structure is NULL", name);
  const std::size_t size = size_of_struct(given);
  if (size < least || size > kLargestStruct) {
    return invalid("struct_size is not the size of this structure: set it to sizeof", name);
  }
  value.struct_size = size;
  auto* const bytes = reinterpret_cast<unsigned char*>(given);
  const std::size_t known = std::min(size, sizeof(Struct));
  std::memcpy(bytes, &value, known);
  std::fill(bytes + known, bytes + size, static_cast<unsigned char>(0));
  return std::monostate{};
}

}  // namespace beespace::c
