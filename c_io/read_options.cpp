#include "c_io/read_options.hpp"

#include "c/door/door.hpp"
#include "c/door/structs.hpp"
#include "io/units/iso_time.hpp"
#include "io/units/stated_length.hpp"
#include "io/units/time_zone.hpp"
#include "io/units/unit_overrides.hpp"

#include <cmath>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

namespace beespace::c_io {

namespace {

constexpr const char* kOptions = "options";
constexpr double kTolerance_m = 0.001;  // where none is given

Error refused(std::string message) {
  Error error{ErrorCode::kInvalidArgument, std::move(message), {}};
  error.location.array = kOptions;
  return error;
}

std::string_view text_of(const char* text) {
  return text == nullptr ? std::string_view() : std::string_view(text);
}

template <class Value>
struct Word {
  std::string_view name;
  Value value;
};

// The value of a word; of none the first one, which "auto" names.
template <class Value>
Status choose(std::string_view option, const char* given, std::initializer_list<Word<Value>> words,
              Value& into) {
  const std::string_view text = text_of(given);
  std::string known;
  for (const Word<Value>& word : words) {
    if (text == word.name || (text.empty() && word.name == "auto")) {
      into = word.value;
      return std::monostate{};
    }
    known.append(known.empty() ? "" : ", ").append(word.name);
  }
  return refused(std::string(option) + " is one of " + known + ", not '" + std::string(text) + "'");
}

Status choose_unit(const char* given, io::Unit& into) {
  return choose<io::Unit>("time_unit", given,
                          {{"auto", io::Unit::kUnstated},
                           {"s", io::Unit::kSecond},
                           {"ms", io::Unit::kMillisecond},
                           {"us", io::Unit::kMicrosecond},
                           {"ns", io::Unit::kNanosecond}},
                          into);
}

// What both kinds of input have in common.
Status read_columns(const beespace_io_options& given, std::uint32_t known,
                    io::ColumnOptions& options) {
  if ((given.flags & ~known) != 0) {
    return refused("flags ask for what this function cannot do");
  }
  Status chosen = choose<io::Frame>(
      "frame", given.frame,
      {{"auto", io::Frame::kAuto}, {"wgs84", io::Frame::kWgs84}, {"metres", io::Frame::kMetres}},
      options.frame);
  if (!chosen) return chosen;
  chosen = choose<io::HeightSource>("heights", given.heights,
                                    {{"auto", io::HeightSource::kAuto},
                                     {"geometric", io::HeightSource::kGeometric},
                                     {"pressure", io::HeightSource::kPressure}},
                                    options.heights);
  if (!chosen) return chosen;
  const auto units = io::read_unit_overrides(text_of(given.units));
  if (!units) return refused(units.error().message);
  options.units = *units;
  options.columns = text_of(given.columns);
  options.skip_bad = (given.flags & BEESPACE_IO_SKIP_BAD) != 0;
  return std::monostate{};
}

// How times and pixels are meant.
Status read_clock_and_pixel(const beespace_io_options& given, io::RecordingOptions& options) {
  if (given.time_zone != nullptr) {
    auto zone = io::TimeZone::find(given.time_zone);
    if (!zone) return refused("time_zone: " + zone.error().message);
    options.time_zone = *std::move(zone);
  }
  Status chosen = choose<io::DateOrder>("dates", given.dates,
                                        {{"auto", io::DateOrder::kUnsaid},
                                         {"day-first", io::DateOrder::kDayFirst},
                                         {"month-first", io::DateOrder::kMonthFirst}},
                                        options.dates);
  if (!chosen) return chosen;
  if (given.scale != nullptr) {
    options.pixel = io::parse_stated(given.scale, io::Quantity::kLength);
    if (!options.pixel || !(options.pixel->metric > 0.0) || !std::isfinite(options.pixel->metric)) {
      return refused("scale is the length of a pixel, above 0, as in \"0.1mm\"");
    }
  }
  if (given.fps == 0.0) return std::monostate{};
  if (!(given.fps > 0.0) || !std::isfinite(given.fps)) {
    return refused("fps is how many frames there are in a second, above 0");
  }
  options.frames_per_second = given.fps;
  return std::monostate{};
}

// How likely places must be that a network has seen.
Status read_likelihood(const beespace_io_options& given, io::RecordingOptions& options) {
  const bool any = (given.flags & BEESPACE_IO_ANY_LIKELIHOOD) != 0;
  if (any) options.least_likelihood = 0.0;
  if (given.least_likelihood == 0.0) return std::monostate{};
  if (any) return refused("least_likelihood and any_likelihood exclude each other; leave one out");
  if (!(given.least_likelihood > 0.0 && given.least_likelihood <= 1.0)) {
    return refused("least_likelihood is a number from 0 to 1, as 0.9");
  }
  options.least_likelihood = given.least_likelihood;
  return std::monostate{};
}

// All default where there are none.
Result<beespace_io_options> given_or_default(const beespace_io_options* options) {
  if (options != nullptr) return c::read_struct(options, kOptions);
  return beespace_io_options{};
}

}  // namespace

Result<io::LoadOptions> points_options(const beespace_io_options* options) {
  const Result<beespace_io_options> given = given_or_default(options);
  if (!given) return given.error();
  io::LoadOptions read;
  if (Status common = read_columns(*given, BEESPACE_IO_SKIP_BAD, read); !common) {
    return std::move(common).error();
  }
  Status chosen = choose<io::Format>("format", given->format,
                                     {{"auto", io::Format::kAuto},
                                      {"text", io::Format::kText},
                                      {"npy", io::Format::kNpy},
                                      {"bin", io::Format::kRawFloat64}},
                                     read.format);
  if (!chosen) return std::move(chosen).error();
  if (const auto unit = text_of(given->time_unit); !unit.empty() && unit != "auto") {
    return refused("time_unit is for recordings: points have no times; leave it out");
  }
  if (given->time_zone != nullptr || given->scale != nullptr || given->fps != 0.0 ||
      given->dates != nullptr) {
    return refused("time_zone, dates, scale and fps are for recordings; leave them out");
  }
  if (given->least_likelihood != 0.0 || given->tolerance_m != 0.0) {
    return refused("least_likelihood and tolerance are for recordings; leave them out");
  }
  read.format_can_be_said = true;
  read.threads = threads_of(given->threads);
  return read;
}

Result<io::RecordingOptions> recording_options(const beespace_io_options* options) {
  const Result<beespace_io_options> given = given_or_default(options);
  if (!given) return given.error();
  io::RecordingOptions read;
  constexpr std::uint32_t kKnown = BEESPACE_IO_SKIP_BAD | BEESPACE_IO_GROUNDED |
                                   BEESPACE_IO_ANY_LIKELIHOOD | BEESPACE_IO_ONE_CLOCK;
  Status common = read_columns(*given, kKnown, read);
  if (!common) return std::move(common).error();
  read.one_clock = (given->flags & BEESPACE_IO_ONE_CLOCK) != 0;
  if (Status chosen = choose_unit(given->time_unit, read.time_unit); !chosen) {
    return std::move(chosen).error();
  }
  if (const auto format = text_of(given->format); !format.empty() && format != "auto") {
    return refused("format is for points: recordings tell it themselves; leave it out");
  }
  if (Status read_well = read_clock_and_pixel(*given, read); !read_well) {
    return std::move(read_well).error();
  }
  if (Status likely = read_likelihood(*given, read); !likely) return std::move(likely).error();
  read.grounded = (given->flags & BEESPACE_IO_GROUNDED) != 0;
  return read;
}

Result<double> tolerance_of(const beespace_io_options* options) {
  const Result<beespace_io_options> given = given_or_default(options);
  if (!given) return given.error();
  if (given->tolerance_m == 0.0) return kTolerance_m;
  if (given->tolerance_m > 0.0 && std::isfinite(given->tolerance_m)) return given->tolerance_m;
  return refused("tolerance is a length in metres, above 0");
}

Result<std::string> path_of(const char* path, const char* name) {
  if (path == nullptr) return c::invalid("the pointer to the path is NULL", name);
  const std::string_view text(path);
  if (text.empty()) return c::invalid("the path is empty; name a file", name);
  return text == "-" ? std::string("./-") : std::string(text);
}

Result<std::vector<std::string>> paths_of(const char* const* paths, std::int64_t count) {
  if (paths == nullptr) return c::invalid("the pointer to the paths is NULL", "paths");
  if (count < 1) return c::invalid("there is no path; name a file", "paths");
  std::vector<std::string> names;
  for (std::int64_t i = 0; i < count; ++i) {
    auto name = path_of(paths[i], "paths");
    if (!name) {
      Error error = std::move(name).error();
      error.location.record = static_cast<std::uint64_t>(i);
      return error;
    }
    names.push_back(*std::move(name));
  }
  return names;
}

Result<std::optional<io::StatedLength>> vertical_of(const char* text, const char* place) {
  if (text_of(text).empty()) return std::optional<io::StatedLength>();
  const auto vertical = io::parse_stated(text, io::Quantity::kLength);
  if (!vertical || !(vertical->metric > 0.0) || !std::isfinite(vertical->metric)) {
    return c::invalid(
        "vertical is a length above zero, in metres or with its unit: \"50\", \"1000ft\"", place);
  }
  return vertical;
}

Status check_ignore_below(double metres, const char* place) {
  if (metres >= 0.0 && std::isfinite(metres)) return std::monostate{};
  return c::invalid("ignore_below_m is a length above zero; 0 leaves no conflict out", place);
}

unsigned threads_of(std::uint32_t threads) {
  if (threads == BEESPACE_ALL_PROCESSORS) return 0;
  return threads == 0 ? 1 : threads;
}

}  // namespace beespace::c_io
