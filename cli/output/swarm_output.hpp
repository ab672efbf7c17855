// A generated swarm as a file, in any format that detect reads; and moving ones, as predict and
// replay read them.
#pragma once

#include "io/bytes/atomic_output.hpp"
#include "io/table/table_writer.hpp"
#include "scenes/recorded_flights.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::cli {

struct SwarmFormat {
  enum class Kind : std::uint8_t { kCsv, kTsv, kNpy, kRawFloat64 };

  Kind kind = Kind::kCsv;
  bool compressed = false;  // gzip

  [[nodiscard]] io::Packing packing() const {
    return compressed ? io::Packing::kGzip : io::Packing::kPlain;
  }
};

// By the ending of a file name, in capitals or not: "bees.csv.gz".
std::optional<SwarmFormat> swarm_format(std::string_view name);

// Whether a file of this name may hold this format: its ending says the same, or nothing.
bool ending_allows(std::string_view name, SwarmFormat format);

enum class SwarmUnits : std::uint8_t { kMetres, kDegrees };

// The output is open with the packing of the format.
//
// Text in metres has all digits of the doubles; text in degrees has the course format's: 11
// decimals for degrees and 2 for metres. Commits the output. Errors: kWriteFailed.
Status write_swarm(const std::vector<Point>& points, SwarmUnits units, SwarmFormat format,
                   io::AtomicOutput& output);

// Bees that move, as text with all digits: a line for each with its number, its position and its
// velocity; or one for each fix of its flight (see scenes::fly), one bee after the other. The
// format is kCsv or kTsv. Commits the output. Errors: kWriteFailed.
Status write_movers(const std::vector<Mover>& movers, SwarmFormat format, io::AtomicOutput& output);
Status write_flights(const std::vector<Mover>& movers, const scenes::FixTimes& times,
                     std::uint64_t seed, SwarmFormat format, io::AtomicOutput& output);

// A recording that is written while it happens, all bees at one time after the other, with all
// digits: time_s, id, x, y, z, and velocities where they are wished for. The format is kCsv or
// kTsv.
class FlightWriter {
 public:
  // `ids` has one for each bee, or none where they are called by their numbers.
  FlightWriter(io::AtomicOutput& output, SwarmFormat format, const std::vector<std::string>& ids,
               bool with_velocities);

  void add(double time_s, const std::vector<Mover>& movers);
  // The same of some: `who` has the number of each.
  void add(double time_s, const std::vector<Mover>& movers, std::span<const std::size_t> who);
  // Commits the output. Errors: kWriteFailed.
  Status finish();

 private:
  void add_one(const std::string& time, std::size_t bee, const Mover& mover);

  io::AtomicOutput& output_;
  bool with_velocities_;
  std::vector<std::string> ids_;  // as fields
  std::string text_;
  io::TableWriter table_;
};

}  // namespace beespace::cli
