#include "cli/swarm_output.hpp"

#include "cli/gzip_writer.hpp"
#include "cli/number_text.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <string>

namespace beespace::cli {
namespace {

static_assert(std::endian::native == std::endian::little, "the arrays are written as they lie");

constexpr std::size_t kBlock = std::size_t{1} << 16;

constexpr std::string_view kCourseHeader =
    "Coordenada x de la abeja, coordenada y de la abeja, coordenada z de la abeja";

// The decimals of the course files.
constexpr int kDegreeDecimals = 11;
constexpr int kHeightDecimals = 2;

void append_fixed(std::string& out, double value, int decimals) {
  std::array<char, 64> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::fixed, decimals)
                       .ptr;
  out.append(text.data(), end);
}

void append_metres(std::string& out, const Point& point, char delimiter) {
  append_exact(out, point.x);
  out += delimiter;
  append_exact(out, point.y);
  out += delimiter;
  append_exact(out, point.z);
  out += '\n';
}

void append_degrees(std::string& out, const Point& point, char delimiter) {
  append_fixed(out, point.x, kDegreeDecimals);
  out += delimiter;
  append_fixed(out, point.y, kDegreeDecimals);
  out += delimiter;
  append_fixed(out, point.z, kHeightDecimals);
  out += '\n';
}

std::string header(SwarmUnits units, char delimiter) {
  if (units == SwarmUnits::kDegrees && delimiter == ',') return std::string(kCourseHeader) + '\n';
  std::string text =
      units == SwarmUnits::kDegrees ? "longitude,latitude,height\n" : "x_m,y_m,z_m\n";
  for (char& c : text) {
    if (c == ',') c = delimiter;
  }
  return text;
}

void write_text(const std::vector<Point>& points, SwarmUnits units, char delimiter,
                GzipWriter& out) {
  const auto append = units == SwarmUnits::kDegrees ? append_degrees : append_metres;
  std::string text = header(units, delimiter);
  for (const Point& point : points) {
    append(text, point, delimiter);
    if (text.size() < kBlock) continue;
    out.write(text);
    text.clear();
  }
  out.write(text);
}

// NumPy's format, version 1.0: magic, length of the dictionary, the dictionary, padded to 64.
std::string npy_header(std::size_t rows) {
  constexpr std::size_t kAlignment = 64;
  constexpr std::size_t kBeforeDictionary = 10;
  std::string dictionary =
      "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(rows) + ", 3), }";
  while ((kBeforeDictionary + dictionary.size() + 1) % kAlignment != 0) dictionary += ' ';
  dictionary += '\n';
  std::string text("\x93NUMPY\x01\x00", 8);
  text += static_cast<char>(dictionary.size() & 0xFFu);
  text += static_cast<char>(dictionary.size() >> 8u);
  return text + dictionary;
}

void write_array(const std::vector<Point>& points, GzipWriter& out) {
  static_assert(sizeof(Point) == 3 * sizeof(double));
  out.write({reinterpret_cast<const char*>(points.data()), points.size() * sizeof(Point)});
}

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

}  // namespace

std::optional<SwarmFormat> swarm_format(std::string_view name) {
  SwarmFormat format;
  const std::string lowered = lower_case(name);
  std::string_view rest = lowered;
  const auto take_ending = [&rest](std::string_view ending) {
    const bool whole = rest == ending.substr(1);
    if (!whole && !rest.ends_with(ending)) return false;
    rest.remove_suffix(whole ? rest.size() : ending.size());
    return true;
  };
  format.compressed = take_ending(".gz");
  using Kind = SwarmFormat::Kind;
  if (take_ending(".csv") || take_ending(".txt")) {
    format.kind = Kind::kCsv;
  } else if (take_ending(".tsv")) {
    format.kind = Kind::kTsv;
  } else if (take_ending(".npy")) {
    format.kind = Kind::kNpy;
  } else if (take_ending(".bin")) {
    format.kind = Kind::kRawFloat64;
  } else {
    return std::nullopt;
  }
  return format;
}

bool ending_allows(std::string_view name, SwarmFormat format) {
  const std::string lowered = lower_case(name);
  const auto ending = swarm_format(name);
  if (!ending) return !lowered.ends_with(".gz") || format.compressed;
  // Any text may be called .txt.
  const bool any_text = lowered.ends_with(".txt") || lowered.ends_with(".txt.gz");
  const bool tabs = any_text && format.kind == SwarmFormat::Kind::kTsv;
  return ending->compressed == format.compressed && (ending->kind == format.kind || tabs);
}

Status write_swarm(const std::vector<Point>& points, SwarmUnits units, SwarmFormat format,
                   io::AtomicOutput& output) {
  GzipWriter out(output, format.compressed);
  switch (format.kind) {
    case SwarmFormat::Kind::kCsv:
      write_text(points, units, ',', out);
      break;
    case SwarmFormat::Kind::kTsv:
      write_text(points, units, '\t', out);
      break;
    case SwarmFormat::Kind::kNpy:
      out.write(npy_header(points.size()));
      write_array(points, out);
      break;
    case SwarmFormat::Kind::kRawFloat64:
      write_array(points, out);
      break;
  }
  out.finish();
  return output.commit();
}

}  // namespace beespace::cli
