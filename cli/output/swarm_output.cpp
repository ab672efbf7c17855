#include "cli/output/swarm_output.hpp"

#include "cli/output/output_form.hpp"
#include "io/bytes/number_text.hpp"
#include "io/table/csv_field.hpp"

#include <algorithm>
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

void append_axes(std::string& out, double x, double y, double z, char delimiter) {
  io::append_exact(out, x);
  out += delimiter;
  io::append_exact(out, y);
  out += delimiter;
  io::append_exact(out, z);
}

void append_metres(std::string& out, const Point& point, char delimiter) {
  append_axes(out, point.x, point.y, point.z, delimiter);
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

// Position and velocity at the end of a line.
void append_motion(std::string& out, const Point& p, const Velocity& v, char delimiter) {
  append_axes(out, p.x, p.y, p.z, delimiter);
  out += delimiter;
  append_axes(out, v.x, v.y, v.z, delimiter);
  out += '\n';
}

std::string delimited(std::string text, char delimiter) {
  std::replace(text.begin(), text.end(), ',', delimiter);
  return text;
}

std::string header(SwarmUnits units, char delimiter) {
  if (units == SwarmUnits::kMetres) return delimited("x_m,y_m,z_m\n", delimiter);
  if (delimiter == ',') return std::string(kCourseHeader) + '\n';
  return delimited("longitude,latitude,height\n", delimiter);
}

char delimiter_of(SwarmFormat format) {
  return format.kind == SwarmFormat::Kind::kTsv ? '\t' : ',';
}

void write_full(std::string& block, io::AtomicOutput& out) {
  if (block.size() < kBlock) return;
  out.write(block);
  block.clear();
}

void write_text(const std::vector<Point>& points, SwarmUnits units, char delimiter,
                io::AtomicOutput& out) {
  const auto append = units == SwarmUnits::kDegrees ? append_degrees : append_metres;
  std::string text = header(units, delimiter);
  for (const Point& point : points) {
    append(text, point, delimiter);
    write_full(text, out);
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

void write_array(const std::vector<Point>& points, io::AtomicOutput& out) {
  static_assert(sizeof(Point) == 3 * sizeof(double));
  out.write({reinterpret_cast<const char*>(points.data()), points.size() * sizeof(Point)});
}

}  // namespace

std::optional<SwarmFormat> swarm_format(std::string_view name) {
  const FileEnding of = file_ending(name);
  using Kind = SwarmFormat::Kind;
  const auto format = [&of](Kind kind) { return SwarmFormat{kind, of.compressed}; };
  if (of.ending == "csv" || of.ending == "txt") return format(Kind::kCsv);
  if (of.ending == "tsv") return format(Kind::kTsv);
  if (of.ending == "npy") return format(Kind::kNpy);
  if (of.ending == "bin") return format(Kind::kRawFloat64);
  return std::nullopt;
}

bool ending_allows(std::string_view name, SwarmFormat format) {
  const auto ending = swarm_format(name);
  const FileEnding of = file_ending(name);
  if (!ending) return !of.compressed || format.compressed;
  // Any text may be called .txt.
  const bool tabs = of.ending == "txt" && format.kind == SwarmFormat::Kind::kTsv;
  return ending->compressed == format.compressed && (ending->kind == format.kind || tabs);
}

Status write_swarm(const std::vector<Point>& points, SwarmUnits units, SwarmFormat format,
                   io::AtomicOutput& output) {
  switch (format.kind) {
    case SwarmFormat::Kind::kCsv:
    case SwarmFormat::Kind::kTsv:
      write_text(points, units, delimiter_of(format), output);
      break;
    case SwarmFormat::Kind::kNpy:
      output.write(npy_header(points.size()));
      write_array(points, output);
      break;
    case SwarmFormat::Kind::kRawFloat64:
      write_array(points, output);
      break;
  }
  return output.commit();
}

Status write_movers(const std::vector<Mover>& movers, SwarmFormat format,
                    io::AtomicOutput& output) {
  const char delimiter = delimiter_of(format);
  std::string text = delimited("id,x,y,z,vx,vy,vz\n", delimiter);
  for (std::size_t bee = 0; bee < movers.size(); ++bee) {
    io::append_exact(text, std::uint64_t{bee});
    text += delimiter;
    append_motion(text, movers[bee].position, movers[bee].velocity, delimiter);
    write_full(text, output);
  }
  output.write(text);
  return output.commit();
}

Status write_flights(const std::vector<Mover>& movers, const scenes::FixTimes& times,
                     std::uint64_t seed, SwarmFormat format, io::AtomicOutput& output) {
  const char delimiter = delimiter_of(format);
  std::string text = delimited("id,time_s,x,y,z,vx,vy,vz\n", delimiter);
  for (std::size_t bee = 0; bee < movers.size(); ++bee) {
    // One at a time, as all of them may be more than the memory holds.
    const Track track = scenes::fly(movers[bee], static_cast<PointId>(bee), times, seed);
    for (const Fix& fix : track.fixes) {
      io::append_exact(text, std::uint64_t{bee});
      text += delimiter;
      io::append_exact(text, fix.time_s);
      text += delimiter;
      append_motion(text, fix.position, movers[bee].velocity, delimiter);
      write_full(text, output);
    }
  }
  output.write(text);
  return output.commit();
}

FlightWriter::FlightWriter(io::AtomicOutput& output, SwarmFormat format,
                           const std::vector<std::string>& ids, bool with_velocities)
    : output_(output),
      delimiter_(delimiter_of(format)),
      with_velocities_(with_velocities),
      text_(delimited(with_velocities ? "time_s,id,x,y,z,vx,vy,vz\n" : "time_s,id,x,y,z\n",
                      delimiter_)) {
  for (const std::string& id : ids) io::append_csv_field(ids_.emplace_back(), id, delimiter_);
}

void FlightWriter::add(double time_s, const std::vector<Mover>& movers) {
  std::string time;
  io::append_exact(time, time_s);
  time += delimiter_;
  for (std::size_t bee = 0; bee < movers.size(); ++bee) {
    const auto& [position, velocity] = movers[bee];
    text_ += time;
    if (ids_.empty()) {
      io::append_exact(text_, std::uint64_t{bee});
    } else {
      text_ += ids_[bee];
    }
    text_ += delimiter_;
    if (with_velocities_) {
      append_motion(text_, position, velocity, delimiter_);
    } else {
      append_metres(text_, position, delimiter_);
    }
    write_full(text_, output_);
  }
}

Status FlightWriter::finish() {
  output_.write(text_);
  return output_.commit();
}

}  // namespace beespace::cli
