#include "tests/report/page_reader.hpp"

#include <zlib.h>

#include <bit>
#include <stdexcept>

namespace beespace::report_test {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(what);
}

unsigned sextet(char digit) {
  if (digit >= 'A' && digit <= 'Z') return static_cast<unsigned>(digit - 'A');
  if (digit >= 'a' && digit <= 'z') return static_cast<unsigned>(digit - 'a') + 26;
  if (digit >= '0' && digit <= '9') return static_cast<unsigned>(digit - '0') + 52;
  require(digit == '+' || digit == '/', "no digit of base64");
  return digit == '+' ? 62 : 63;
}

// Padded, and with no bits that mean nothing.
std::string from_base64(std::string_view text) {
  require(text.size() % 4 == 0, "base64 comes in fours");
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::string bytes;
  unsigned bits = 0;
  unsigned count = 0;
  for (const char digit : text) {
    bits = (bits << 6u) | sextet(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>((bits >> count) & 0xFFu);
    bits &= (1u << count) - 1;
  }
  require(bits == 0 && count < 6, "bits that mean nothing");
  return bytes;
}

std::string inflated(std::string_view bytes) {
  z_stream stream{};
  require(inflateInit(&stream) == Z_OK, "zlib");
  std::string in(bytes);
  std::string out;
  std::string block(65'536, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = static_cast<uInt>(block.size());
    state = inflate(&stream, Z_NO_FLUSH);
    out.append(block, 0, block.size() - stream.avail_out);
  }
  const bool whole = state == Z_STREAM_END && stream.avail_in == 0;
  inflateEnd(&stream);
  require(whole, "not one zlib stream");
  return out;
}

std::size_t bytes_of(const std::string& type) {
  if (type == "u8") return 1;
  if (type == "u16") return 2;
  if (type == "u32") return 4;
  require(type == "f64", "no such type");
  return 8;
}

// From the planes of their bytes.
std::vector<std::uint64_t> from_planes(const std::string& bytes, std::size_t size,
                                       std::size_t count) {
  require(bytes.size() == size * count, "not so many bytes as numbers");
  std::vector<std::uint64_t> numbers(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t plane = size; plane-- > 0;) {
      numbers[i] = numbers[i] * 256 + static_cast<unsigned char>(bytes[plane * count + i]);
    }
  }
  return numbers;
}

// Running sums, modulo 2^bits, of zigzag-coded numbers.
void add_up(std::vector<std::uint64_t>& numbers, std::uint64_t most) {
  std::uint64_t sum = 0;
  for (std::uint64_t& number : numbers) {
    sum += number % 2 == 0 ? number / 2 : std::uint64_t{0} - (number + 1) / 2;
    sum &= most;
    number = sum;
  }
}

void add_up_plainly(std::vector<std::uint64_t>& numbers, std::uint64_t most) {
  std::uint64_t sum = 0;
  for (std::uint64_t& number : numbers) {
    sum = (sum + number) & most;
    number = sum;
  }
}

// Takes `part` from the front.
void take(std::string_view& rest, std::string_view part, const char* what) {
  require(rest.starts_with(part), what);
  rest.remove_prefix(part.size());
}

std::string take_until(std::string_view& rest, std::string_view end) {
  const std::size_t at = rest.find(end);
  require(at != std::string_view::npos, "an element without end");
  std::string taken(rest.substr(0, at));
  rest.remove_prefix(at + end.size());
  return taken;
}

}  // namespace

bool has(Json object, std::string_view key) {
  return object[key].error() == simdjson::SUCCESS;
}

std::string text_of(Json text) {
  return std::string(std::string_view(text));
}

std::vector<std::string> texts_of(Json array) {
  std::vector<std::string> texts;
  for (const Json text : simdjson::dom::array(array)) texts.push_back(text_of(text));
  return texts;
}

std::vector<double> Column::values() const {
  std::vector<double> meant;
  for (const std::uint64_t number : numbers) {
    const double stored =
        type == "f64" ? std::bit_cast<double>(number) : static_cast<double>(number);
    meant.push_back(offset.value_or(0.0) + scale.value_or(1.0) * stored);
  }
  return meant;
}

Column column_of(Json json, const std::vector<std::string>& elements) {
  Column column;
  column.type = text_of(json["type"]);
  if (has(json, "code")) column.code = text_of(json["code"]);
  if (has(json, "scale")) column.scale = double(json["scale"]);
  if (has(json, "offset")) column.offset = double(json["offset"]);
  const std::size_t count = std::uint64_t(json["count"]);
  const std::string bytes = inflated(from_base64(elements.at(std::uint64_t(json["at"]))));
  if (column.type == "json") {
    const ParsedJson texts(bytes);
    column.texts = texts_of(texts.root());
    require(column.texts.size() == count && column.code.empty(), "not so many texts");
    return column;
  }
  const std::size_t size = bytes_of(column.type);
  const std::uint64_t most = ~std::uint64_t{0} >> (64 - 8 * size);
  column.numbers = from_planes(bytes, size, count);
  if (column.code.empty()) return column;
  require(column.type != "f64" && (column.code == "delta" || column.code == "delta2"), "code");
  add_up(column.numbers, most);
  if (column.code == "delta2") add_up_plainly(column.numbers, most);
  return column;
}

std::vector<double> values_of(Json json, const std::vector<std::string>& elements) {
  return column_of(json, elements).values();
}

std::vector<std::uint64_t> numbers_of(Json json, const std::vector<std::string>& elements) {
  return column_of(json, elements).numbers;
}

PageParts parts_of(std::string_view page) {
  constexpr std::string_view kBegin = "<script type=\"application/json\" id=\"beespace-page\">";
  constexpr std::string_view kEnd = "</script>\n";
  const std::size_t begin = page.find(kBegin);
  require(begin != std::string_view::npos, "no data in the page");
  PageParts parts;
  parts.before = page.substr(0, begin);
  std::string_view rest = page.substr(begin);
  take(rest, kBegin, "the JSON");
  parts.json = take_until(rest, kEnd);
  const auto next = [&] {
    return "<script type=\"text/plain\" id=\"beespace-" + std::to_string(parts.elements.size()) +
           "\">";
  };
  while (rest.starts_with(next())) {
    take(rest, next(), "an element");
    parts.elements.push_back(take_until(rest, kEnd));
  }
  take(rest, "<script type=\"text/plain\" id=\"beespace-end\">", "the end");
  parts.end = take_until(rest, kEnd);
  parts.after = rest;
  return parts;
}

}  // namespace beespace::report_test
