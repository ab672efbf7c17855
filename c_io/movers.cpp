// Where the agents of a recording are at its last time, and how fast they fly: what `beespace
// predict` looks ahead from.
#include "analysis/geometry/geometry.hpp"
#include "analysis/recorded/last_snapshot.hpp"
#include "c/door/door.hpp"
#include "c_io/door.hpp"
#include "c_io/recording.hpp"

#include <beespace_io.h>
#include <beespace/result.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

using namespace beespace::c_io;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::Error;
using beespace::ErrorCode;
using beespace::Point;
using beespace::Status;
using beespace::Velocity;
using beespace::c::invalid;
namespace analysis = beespace::analysis;
namespace io = beespace::io;

namespace {

struct Columns {
  double* xyz;
  double* velocities;
  std::uint8_t* known;

  void write(std::size_t agent, const Point& p, const Velocity& v, std::uint8_t how) const {
    std::copy_n(&p.x, 3, xyz + 3 * agent);
    std::copy_n(&v.x, 3, velocities + 3 * agent);
    if (known != nullptr) known[agent] = how;
  }
};

// A show says where its drones go: they fly straight on nowhere.
Status refuse_shows(const io::Recording& recording) {
  for (const io::RecordedBee& bee : recording.bees) {
    if (!bee.path) continue;
    return Error{ErrorCode::kUnsupportedFormat,
                 "'" + bee.id +
                     "' flies along the curve of a show, which says where it is at each time; ask "
                     "for the conflicts of the recording",
                 {}};
  }
  return std::monostate{};
}

// Those that the snapshot leaves out: where they were last heard of.
Status write_stale(const io::Recording& recording, const Columns& columns) {
  for (std::size_t i = 0; i < recording.bees.size(); ++i) {
    const io::RecordedBee& bee = recording.bees[i];
    if (bee.fixes.empty()) {
      columns.write(i, {kNotKnown, kNotKnown, kNotKnown}, kNoVelocity, BEESPACE_IO_NOWHERE);
      continue;
    }
    const auto at =
        analysis::in_metres(recording, i, bee.fixes.size() - 1, analysis::Geometry::kSpace);
    if (!at) return at.error();
    columns.write(i, at->position, kNoVelocity, BEESPACE_IO_STALE);
  }
  return std::monostate{};
}

Status write_movers(const io::Recording& recording, double max_age_s, const Columns& columns,
                    double& time_s) {
  if (Status good = refuse_shows(recording); !good) return good;
  const auto snapshot = analysis::snapshot_of(recording, analysis::Geometry::kSpace, max_age_s,
                                              analysis::Wanted::kMotion);
  if (!snapshot) return snapshot.error();
  if (Status good = write_stale(recording, columns); !good) return good;
  for (std::size_t i = 0; i < snapshot->movers.size(); ++i) {
    const std::size_t agent = snapshot->bees[i];
    const auto& stated = recording.bees[agent].velocities;
    const bool is_stated = !stated.empty() && analysis::is_known(stated.back());
    columns.write(agent, snapshot->movers[i].position, snapshot->movers[i].velocity,
                  is_stated ? BEESPACE_IO_STATED : BEESPACE_IO_ESTIMATED);
  }
  for (const analysis::Snapshot::Placed& placed : snapshot->unmoving) {
    columns.write(placed.bee, placed.position, kNoVelocity, BEESPACE_IO_WITHOUT_VELOCITY);
  }
  time_s = snapshot->time_s;
  return std::monostate{};
}

}  // namespace

extern "C" {

beespace_code beespace_io_recording_movers(const beespace_io_recording* recording, double max_age_s,
                                           double* xyz, double* velocities, uint8_t* known,
                                           double* time_s, beespace_io_error* error) {
  return enter(error, [&]() -> Status {
    if (recording == nullptr) return invalid("the recording is NULL", "recording");
    if (!(max_age_s >= 0.0)) return invalid("seconds are zero or more", "max_age_s");
    if (xyz == nullptr) return invalid("the pointer to the positions is NULL", "xyz");
    if (velocities == nullptr)
      return invalid("the pointer to the velocities is NULL", "velocities");
    double now_s = 0.0;
    Status written = write_movers(recording->loaded, max_age_s, {xyz, velocities, known}, now_s);
    if (written && time_s != nullptr) *time_s = now_s;
    return written;
  });
}

}  // extern "C"
