#include "c_io/door.hpp"

#include "c/door/door.hpp"
#include "c/door/structs.hpp"
#include "c_io/wording.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

namespace beespace::c_io {

namespace {

constexpr std::string_view kCut = "...";

// Whether a byte of UTF-8 goes on with the character before it.
bool goes_on(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

template <std::size_t Size>
void write_front(char (&into)[Size], std::string_view text) {
  std::size_t length = text.size();
  const bool cut = length >= Size;
  if (cut) {
    length = Size - 1 - kCut.size();
    while (length > 0 && goes_on(text[length])) --length;
  }
  char* const end = std::copy_n(text.data(), length, into);
  if (cut) std::copy(kCut.begin(), kCut.end(), end);
  end[cut ? kCut.size() : 0] = '\0';
}

template <std::size_t Size>
void write_back(char (&into)[Size], std::string_view text) {
  if (text.size() < Size) {
    write_front(into, text);
    return;
  }
  text.remove_prefix(text.size() - (Size - 1 - kCut.size()));
  while (!text.empty() && goes_on(text.front())) text.remove_prefix(1);
  char* const rest = std::copy(kCut.begin(), kCut.end(), into);
  *std::copy(text.begin(), text.end(), rest) = '\0';
}

std::int64_t number_or(const std::optional<std::uint64_t>& number, std::int64_t unknown) {
  return number ? static_cast<std::int64_t>(*number) : unknown;
}

beespace_code fill(beespace_io_error* error, beespace_code code, const ErrorLocation& where,
                   std::string_view message) {
  if (error == nullptr || c::size_of_struct(error) < sizeof(beespace_io_error)) return code;
  error->code = code;
  error->reserved = 0;
  error->record = number_or(where.record, -1);
  error->line = number_or(where.line, 0);
  error->column = number_or(where.column, 0);
  write_front(error->place, where.array);
  write_back(error->file, where.source);
  write_front(error->message, message);
  return code;
}

// The text of an array of the caller's, which need not end with a zero byte.
template <std::size_t Size>
std::string_view text_in(const char (&array)[Size]) {
  const char* const end = std::find(array, array + Size, '\0');
  return {array, static_cast<std::size_t>(end - array)};
}

}  // namespace

beespace_code refuse(beespace_io_error* error, const Error& cause) {
  const Error said = in_words_of_programs(cause);
  return fill(error, c::code_of(said.code), said.location, said.message);
}

beespace_code refuse_out_of_memory(beespace_io_error* error) {
  return fill(error, BEESPACE_OUT_OF_MEMORY, {},
              "the system gives no more memory: read less at once");
}

beespace_code refuse_internal(beespace_io_error* error) {
  return fill(error, BEESPACE_INTERNAL, {},
              "something that beespace does not expect went wrong: please report it");
}

}  // namespace beespace::c_io

extern "C" {

size_t beespace_io_error_text(const beespace_io_error* error, char* text, size_t size) {
  using beespace::c_io::text_in;
  try {
    beespace::Error said;
    if (error != nullptr) {
      said.message = text_in(error->message);
      said.location.source = text_in(error->file);
      said.location.array = text_in(error->place);
      if (error->record >= 0) said.location.record = static_cast<std::uint64_t>(error->record);
      if (error->line > 0) said.location.line = static_cast<std::uint64_t>(error->line);
      if (error->column > 0) said.location.column = static_cast<std::uint64_t>(error->column);
    }
    const std::string line = to_string(said);
    if (text != nullptr && size > 0) {
      const std::size_t length = std::min(line.size(), size - 1);
      std::memcpy(text, line.data(), length);
      text[length] = '\0';
    }
    return line.size();
  } catch (...) {
    if (text != nullptr && size > 0) text[0] = '\0';
    return 0;
  }
}

}  // extern "C"
