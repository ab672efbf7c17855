#include "c_io/recording.hpp"

#include "analysis/geometry/geometry.hpp"
#include "analysis/recorded/coverage.hpp"
#include "analysis/recorded/default_threshold.hpp"
#include "analysis/recorded/tracks.hpp"
#include "c/door/door.hpp"
#include "c_io/door.hpp"
#include "c_io/facts.hpp"
#include "c_io/read_options.hpp"
#include "io/bytes/number_text.hpp"
#include "io/load_recording.hpp"

#include <beespace_io.h>
#include <beespace/mover.hpp>
#include <beespace/track.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace beespace::c_io;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Fix;
using beespace::Result;
using beespace::Status;
using beespace::Track;
using beespace::Velocity;
using beespace::c::invalid;
namespace analysis = beespace::analysis;
namespace io = beespace::io;

namespace {

void append(const beespace::Point& point, std::vector<double>& numbers) {
  numbers.insert(numbers.end(), {point.x, point.y, point.z});
}

void append(const Track& track, beespace_io_recording& recording) {
  const auto agent = static_cast<std::int64_t>(recording.offsets.size() - 1);
  for (const Fix& fix : track.fixes) {
    recording.agent.push_back(agent);
    recording.times_s.push_back(fix.time_s);
    append(fix.position, recording.xyz);
  }
  recording.offsets.push_back(static_cast<std::int64_t>(recording.times_s.size()));
}

// The velocities of one agent, whose fixes are there already.
Status append_velocities(const io::Recording& loaded, std::size_t bee,
                         beespace_io_recording& recording) {
  const bool any = !loaded.bees[bee].velocities.empty();
  const std::size_t fixes = recording.times_s.size() - recording.velocities.size() / 3;
  for (std::size_t fix = 0; fix < fixes; ++fix) {
    std::optional<Velocity> velocity;
    if (any) {
      const auto at = analysis::in_metres(loaded, bee, fix, analysis::Geometry::kSpace);
      if (!at) return at.error();
      velocity = at->velocity;
    }
    const Velocity& v = velocity.value_or(kNoVelocity);
    recording.velocities.insert(recording.velocities.end(), {v.x, v.y, v.z});
  }
  return std::monostate{};
}

// Says how many fixes have no velocity, where some have one; where none has, there are none.
void settle_velocities(beespace_io_recording& recording) {
  std::vector<double>& velocities = recording.velocities;
  const auto count = static_cast<std::uint64_t>(recording.times_s.size());
  const auto numbers =
      std::count_if(velocities.begin(), velocities.end(), [](double v) { return !std::isnan(v); });
  const std::uint64_t known = static_cast<std::uint64_t>(numbers) / 3;
  if (known == 0) {
    velocities = {};
  } else if (known < count) {
    recording.facts.notes.push_back("no velocity is known of " + io::grouped(count - known) +
                                    " of " + io::grouped(count) + " fixes: theirs are no numbers");
  }
}

Result<std::unique_ptr<beespace_io_recording>> columns_of(io::Recording loaded,
                                                          double tolerance_m) {
  const auto tracks = analysis::tracks_of(loaded, analysis::Geometry::kSpace, tolerance_m);
  if (!tracks) return tracks.error();
  auto recording = std::make_unique<beespace_io_recording>();
  recording->tolerance_m = tolerance_m;
  recording->facts = facts_of(loaded);
  const std::string missing = analysis::missing_text(loaded.missing);
  if (!missing.empty()) {
    recording->facts.notes.push_back("what is said is of those that are known: " + missing);
  }
  const bool any_velocity =
      std::any_of(loaded.bees.begin(), loaded.bees.end(),
                  [](const io::RecordedBee& bee) { return !bee.velocities.empty(); });
  for (std::size_t bee = 0; bee < loaded.bees.size(); ++bee) {
    recording->ids.add(loaded.bees[bee].id);
    recording->labels.add(loaded.bees[bee].label);
    append((*tracks)[bee], *recording);
    if (any_velocity) {
      if (Status good = append_velocities(loaded, bee, *recording); !good) return good.error();
    }
    if (loaded.frame != io::Frame::kWgs84) continue;
    for (const Fix& fix : loaded.bees[bee].fixes) append(fix.position, recording->degrees);
  }
  settle_velocities(*recording);
  recording->loaded = std::move(loaded);
  return recording;
}

Result<std::unique_ptr<beespace_io_recording>> read_recording(const char* const* paths,
                                                              std::int64_t path_count,
                                                              const beespace_io_options* options) {
  auto names = paths_of(paths, path_count);
  if (!names) return std::move(names).error();
  const auto asked = recording_options(options);
  if (!asked) return asked.error();
  const auto tolerance_m = tolerance_of(options);
  if (!tolerance_m) return tolerance_m.error();
  auto loaded = io::load_recording(*names, *asked);
  if (!loaded) return std::move(loaded).error();
  return columns_of(*std::move(loaded), *tolerance_m);
}

template <class Number>
const Number* first_of(const std::vector<Number>& numbers) {
  return numbers.empty() ? nullptr : numbers.data();
}

}  // namespace

namespace beespace::c_io {

Result<double> threshold_of(const io::Recording& recording, double given_m) {
  if (given_m > 0.0) return given_m;
  const double m = analysis::default_threshold(recording, 0.0).metres;
  if (m > 0.0) return m;
  return Error{ErrorCode::kInvalidThreshold,
               "give a threshold: this recording declares none, and is no show",
               {}};
}

}  // namespace beespace::c_io

extern "C" {

beespace_code beespace_io_read_recording(const char* const* paths, int64_t path_count,
                                         const beespace_io_options* options,
                                         beespace_io_recording** recording,
                                         beespace_io_error* error) {
  if (recording != nullptr) *recording = nullptr;
  return enter(error, [&]() -> Status {
    if (recording == nullptr) return invalid("the pointer to the recording is NULL", "recording");
    auto read = read_recording(paths, path_count, options);
    if (!read) return std::move(read).error();
    *recording = (*read).release();
    return std::monostate{};
  });
}

void beespace_io_recording_free(beespace_io_recording* recording) {
  delete recording;
}

int64_t beespace_io_recording_agents(const beespace_io_recording* recording) {
  return recording == nullptr ? 0 : static_cast<int64_t>(recording->ids.size());
}

int64_t beespace_io_recording_fixes(const beespace_io_recording* recording) {
  return recording == nullptr ? 0 : static_cast<int64_t>(recording->times_s.size());
}

const int64_t* beespace_io_recording_offsets(const beespace_io_recording* recording) {
  return recording == nullptr ? nullptr : recording->offsets.data();
}

const int64_t* beespace_io_recording_agent(const beespace_io_recording* recording) {
  return recording == nullptr ? nullptr : first_of(recording->agent);
}

const double* beespace_io_recording_times_s(const beespace_io_recording* recording) {
  return recording == nullptr ? nullptr : first_of(recording->times_s);
}

const double* beespace_io_recording_xyz(const beespace_io_recording* recording) {
  return recording == nullptr ? nullptr : first_of(recording->xyz);
}

const double* beespace_io_recording_velocities(const beespace_io_recording* recording) {
  return recording == nullptr ? nullptr : first_of(recording->velocities);
}

const double* beespace_io_recording_degrees(const beespace_io_recording* recording) {
  return recording == nullptr ? nullptr : first_of(recording->degrees);
}

const char* beespace_io_recording_id(const beespace_io_recording* recording, int64_t agent) {
  return recording == nullptr ? nullptr : recording->ids.find(agent);
}

const char* beespace_io_recording_ids(const beespace_io_recording* recording,
                                      const int64_t** offsets) {
  if (offsets != nullptr) *offsets = recording == nullptr ? nullptr : recording->ids.offsets();
  return recording == nullptr ? nullptr : recording->ids.bytes();
}

const char* beespace_io_recording_label(const beespace_io_recording* recording, int64_t agent) {
  return recording == nullptr ? nullptr : recording->labels.find(agent);
}

int32_t beespace_io_recording_since_1970(const beespace_io_recording* recording) {
  return recording != nullptr && recording->loaded.since_1970 ? 1 : 0;
}

int32_t beespace_io_recording_is_show(const beespace_io_recording* recording) {
  return recording != nullptr && recording->loaded.show ? 1 : 0;
}

int64_t beespace_io_recording_missing(const beespace_io_recording* recording) {
  return recording == nullptr ? 0 : static_cast<int64_t>(recording->loaded.missing.count);
}

const beespace_io_facts* beespace_io_recording_facts(const beespace_io_recording* recording) {
  return recording == nullptr ? nullptr : &recording->facts;
}

}  // extern "C"
