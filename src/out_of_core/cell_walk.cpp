#include "out_of_core/cell_walk.hpp"

#include "base/stopping.hpp"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <span>
#include <thread>
#include <utility>

namespace beespace::out_of_core {

namespace {

// Reads one cell while another is searched.
class Reading {
 public:
  // Of at most so many points at a time: memory that is taken anew for each cell does not always go
  // back to the system.
  Reading(const Cells& cells, std::uint64_t most) : cells_(cells) {
    points_.resize(static_cast<std::size_t>(most), cells.have_heights());
  }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;
  ~Reading() {
    if (thread_.joinable()) thread_.join();
  }

  void start(std::span<const Segment> segments) {
    thread_ = std::thread([this, segments] {
      try {
        status_ = cells_.read(segments, points_);
      } catch (...) {
        failure_ = std::current_exception();
      }
    });
  }

  // The points are those that were read, until the next start().
  Status finish() {
    thread_.join();
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    return std::exchange(status_, Status(std::monostate{}));
  }
  [[nodiscard]] CellPoints& points() { return points_; }

 private:
  const Cells& cells_;
  CellPoints points_;
  Status status_ = std::monostate{};
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace

CrowdedCell::CrowdedCell(const Cells& cells, std::size_t cell, std::size_t most,
                         const std::stop_token& stop)
    : cells_(cells), stop_(stop) {
  const std::span<const Segment> segments = cells.segments(cell);
  std::size_t begin = 0;
  std::size_t count = 0;
  for (std::size_t at = 0; at < segments.size(); ++at) {
    if (at > begin && count + segments[at].count > most) {
      pieces_.push_back(segments.subspan(begin, at - begin));
      begin = at;
      count = 0;
    }
    count += segments[at].count;
  }
  pieces_.push_back(segments.subspan(begin));
}

Status CrowdedCell::read(std::size_t piece, CellPoints& points) const {
  if (stop_.stop_requested()) return core::stopped_error();
  return cells_.read(pieces_[piece], points);
}

Status walk_cells(const Cells& cells, std::size_t most, CellQuestion& question,
                  const std::stop_token& stop, const std::function<void(std::uint64_t)>& done,
                  std::uint64_t& crowded) {
  std::vector<std::size_t> whole;
  std::vector<std::size_t> too_full;
  std::uint64_t largest = 0;  // of those that are whole
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    if (cells.home_count(cell) == 0) continue;
    if (cells.count(cell) > most) {
      too_full.push_back(cell);
      continue;
    }
    whole.push_back(cell);
    largest = std::max(largest, cells.count(cell));
  }
  crowded = too_full.size();

  std::uint64_t searched = 0;
  Reading readings[2] = {{cells, largest}, {cells, largest}};
  if (!whole.empty()) readings[0].start(cells.segments(whole[0]));
  for (std::size_t at = 0; at < whole.size(); ++at) {
    Reading& reading = readings[at % 2];
    if (auto status = reading.finish(); !status) return status;
    if (at + 1 < whole.size()) readings[(at + 1) % 2].start(cells.segments(whole[at + 1]));
    if (stop.stop_requested()) return core::stopped_error();
    if (auto status = question.ask(reading.points(), cells); !status) return status;
    searched += cells.home_count(whole[at]);
    done(searched);
  }
  for (auto& reading : readings) reading.points().release();
  for (const std::size_t cell : too_full) {
    const CrowdedCell pieces(cells, cell, most / 2, stop);
    if (auto status = question.ask_crowded(pieces, cells); !status) return status;
    searched += cells.home_count(cell);
    done(searched);
  }
  return question.finish(cells);
}

}  // namespace beespace::out_of_core
