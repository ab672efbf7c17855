#include "c_io/points.hpp"

#include "analysis/snapshot/recording_check.hpp"
#include "c/door/door.hpp"
#include "c_io/door.hpp"
#include "c_io/left_out_velocities.hpp"
#include "c_io/read_options.hpp"
#include "io/load_points.hpp"

#include <cstddef>
#include <memory>
#include <numeric>
#include <string>
#include <utility>

using namespace beespace::c_io;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::PointId;
using beespace::Result;
using beespace::Status;
using beespace::c::invalid;
namespace analysis = beespace::analysis;
namespace io = beespace::io;

namespace {

// As `beespace detect` reads it: never the fixes of a recording.
Result<io::LoadedPoints> load_snapshot(const std::string& path, const io::LoadOptions& options) {
  auto loaded = io::load_points(path, options);
  if (!loaded) return analysis::or_recording(std::move(loaded).error(), path, options);
  if (auto problem = analysis::recording_problem(*loaded, path, options))
    return *std::move(problem);
  return loaded;
}

// What else the records say, while they are there.
void take_records(beespace_io_points& points) {
  const io::LoadedPoints& loaded = points.loaded;
  const std::size_t count = loaded.points.size();
  points.rows.resize(count);
  std::iota(points.rows.begin(), points.rows.end(), std::int64_t{0});
  const bool degrees = loaded.frame == io::Frame::kWgs84;
  if (io::has_id_column(loaded)) points.ids.emplace();
  if (!points.ids && !degrees && loaded.skipped_count == 0) return;
  if (degrees) points.degrees.reserve(3 * count);
  std::vector<PointId> all(count);
  std::iota(all.begin(), all.end(), PointId{0});
  io::for_each_record(loaded, all, [&](const io::Record& record) {
    points.rows[record.point] = static_cast<std::int64_t>(record.row);
    if (points.ids) points.ids->add(record.id);
    if (!degrees) return;
    points.degrees.push_back(record.geographic.longitude_deg);
    points.degrees.push_back(record.geographic.latitude_deg);
    points.degrees.push_back(record.geographic.height_m);
  });
}

Result<std::unique_ptr<beespace_io_points>> read_points(const char* path,
                                                        const beespace_io_options* options) {
  auto name = path_of(path);
  if (!name) return std::move(name).error();
  const auto asked = points_options(options);
  if (!asked) return asked.error();
  auto loaded = load_snapshot(*name, *asked);
  if (!loaded) return std::move(loaded).error();
  auto points = std::make_unique<beespace_io_points>();
  points->loaded = *std::move(loaded);
  points->path = *std::move(name);
  points->facts = facts_of(points->loaded);
  std::string left_out = left_out_velocities(points->loaded);
  if (!left_out.empty()) points->facts.notes.push_back(std::move(left_out));
  take_records(*points);
  points->loaded.records.reset();
  return points;
}

}  // namespace

extern "C" {

beespace_code beespace_io_read_points(const char* path, const beespace_io_options* options,
                                      beespace_io_points** points, beespace_io_error* error) {
  if (points != nullptr) *points = nullptr;
  return enter(error, [&]() -> Status {
    if (points == nullptr) return invalid("the pointer to the points is NULL", "points");
    auto read = read_points(path, options);
    if (!read) return std::move(read).error();
    *points = (*read).release();
    return std::monostate{};
  });
}

void beespace_io_points_free(beespace_io_points* points) {
  delete points;
}

int64_t beespace_io_points_count(const beespace_io_points* points) {
  return points == nullptr ? 0 : static_cast<int64_t>(points->loaded.points.size());
}

const double* beespace_io_points_xyz(const beespace_io_points* points) {
  if (points == nullptr || points->loaded.points.empty()) return nullptr;
  static_assert(sizeof(beespace::Point) == 3 * sizeof(double));
  return &points->loaded.points.front().x;
}

const double* beespace_io_points_degrees(const beespace_io_points* points) {
  return points == nullptr || points->degrees.empty() ? nullptr : points->degrees.data();
}

const int64_t* beespace_io_points_rows(const beespace_io_points* points) {
  return points == nullptr || points->rows.empty() ? nullptr : points->rows.data();
}

const char* beespace_io_points_id(const beespace_io_points* points, int64_t index) {
  return points == nullptr || !points->ids ? nullptr : points->ids->find(index);
}

const char* beespace_io_points_ids(const beespace_io_points* points, const int64_t** offsets) {
  if (offsets != nullptr) *offsets = nullptr;
  if (points == nullptr || !points->ids) return nullptr;
  if (offsets != nullptr) *offsets = points->ids->offsets();
  return points->ids->bytes();
}

const beespace_io_facts* beespace_io_points_facts(const beespace_io_points* points) {
  return points == nullptr ? nullptr : &points->facts;
}

}  // extern "C"
