#include "cli/output/swarm_output.hpp"

#include "cli/output/output_form.hpp"
#include "io/bytes/number_text.hpp"
#include "io/table/table_writer.hpp"

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

void write_axes(io::TableWriter& table, double x, double y, double z) {
  table.field(x).field(y).field(z);
}

void write_degrees(io::TableWriter& table, const Point& point) {
  append_fixed(table.next(), point.x, kDegreeDecimals);
  append_fixed(table.next(), point.y, kDegreeDecimals);
  append_fixed(table.next(), point.z, kHeightDecimals);
}

// Position and velocity at the end of a line.
void write_motion(io::TableWriter& table, const Point& p, const Velocity& v) {
  write_axes(table, p.x, p.y, p.z);
  write_axes(table, v.x, v.y, v.z);
  table.end_row();
}

void write_header(io::TableWriter& table, SwarmUnits units) {
  if (units == SwarmUnits::kMetres) {
    table.header("x_m,y_m,z_m");
  } else if (table.delimiter() == ',') {
    table.next() += kCourseHeader;
  } else {
    table.header("longitude,latitude,height");
  }
  table.end_row();
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
  std::string text;
  io::TableWriter table(text, delimiter);
  write_header(table, units);
  for (const Point& point : points) {
    if (units == SwarmUnits::kDegrees) {
      write_degrees(table, point);
    } else {
      write_axes(table, point.x, point.y, point.z);
    }
    table.end_row();
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
  std::string text;
  io::TableWriter table(text, delimiter_of(format));
  table.header("id,x,y,z,vx,vy,vz").end_row();
  for (std::size_t bee = 0; bee < movers.size(); ++bee) {
    write_motion(table.field(bee), movers[bee].position, movers[bee].velocity);
    write_full(text, output);
  }
  output.write(text);
  return output.commit();
}

Status write_flights(const std::vector<Mover>& movers, const scenes::FixTimes& times,
                     std::uint64_t seed, SwarmFormat format, io::AtomicOutput& output) {
  std::string text;
  io::TableWriter table(text, delimiter_of(format));
  table.header("id,time_s,x,y,z,vx,vy,vz").end_row();
  for (std::size_t bee = 0; bee < movers.size(); ++bee) {
    // One at a time, as all of them may be more than the memory holds.
    const Track track = scenes::fly(movers[bee], static_cast<PointId>(bee), times, seed);
    for (const Fix& fix : track.fixes) {
      write_motion(table.field(bee).field(fix.time_s), fix.position, movers[bee].velocity);
      write_full(text, output);
    }
  }
  output.write(text);
  return output.commit();
}

FlightWriter::FlightWriter(io::AtomicOutput& output, SwarmFormat format,
                           const std::vector<std::string>& ids, bool with_velocities)
    : output_(output), with_velocities_(with_velocities), table_(text_, delimiter_of(format)) {
  table_.header(with_velocities ? "time_s,id,x,y,z,vx,vy,vz" : "time_s,id,x,y,z").end_row();
  for (const std::string& id : ids) {
    io::append_field(ids_.emplace_back(), id, table_.delimiter());
  }
}

void FlightWriter::add(double time_s, const std::vector<Mover>& movers) {
  std::string time;
  io::append_exact(time, time_s);
  for (std::size_t bee = 0; bee < movers.size(); ++bee) add_one(time, bee, movers[bee]);
}

void FlightWriter::add(double time_s, const std::vector<Mover>& movers,
                       std::span<const std::size_t> who) {
  std::string time;
  io::append_exact(time, time_s);
  for (std::size_t k = 0; k < movers.size(); ++k) add_one(time, who[k], movers[k]);
}

void FlightWriter::add_one(const std::string& time, std::size_t bee, const Mover& mover) {
  const auto& [position, velocity] = mover;
  table_.next() += time;
  if (ids_.empty()) {
    table_.field(bee);
  } else {
    table_.next() += ids_[bee];
  }
  if (with_velocities_) {
    write_motion(table_, position, velocity);
  } else {
    write_axes(table_, position.x, position.y, position.z);
    table_.end_row();
  }
  write_full(text_, output_);
}

Status FlightWriter::finish() {
  output_.write(text_);
  return output_.commit();
}

}  // namespace beespace::cli
