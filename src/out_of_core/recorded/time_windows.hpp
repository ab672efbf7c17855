// The fixes of each window of time, on the disk, and in memory as segments of tracks.
#pragma once

#include "motion/track_segments.hpp"
#include "out_of_core/block_file.hpp"
#include "out_of_core/recorded/stored_fixes.hpp"
#include "out_of_core/recorded/time_cut.hpp"

#include <beespace/agent_id.hpp>
#include <beespace/recording_out_of_core.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace beespace::out_of_core {

// A window in memory.
class WindowTracks {
 public:
  // For windows of at most so many fixes: memory that is taken anew for each does not always go
  // back to the system.
  WindowTracks(std::uint64_t most, bool have_heights, double max_gap_s);
  // Forgets what was there.
  void start();
  // In ascending order of agents, then times.
  void add(AgentId agent, const Fix& fix, double height_m);

  [[nodiscard]] AgentId agent(PointId track) const { return agents_[track]; }
  // In the order of agents, then times; until the next start().
  [[nodiscard]] std::vector<motion::TrackSegment> segments() const;

 private:
  double max_gap_s_;
  bool have_heights_;
  std::vector<Fix> fixes_;
  std::vector<double> heights_;
  std::vector<AgentId> agents_;
  struct Begin {
    std::size_t fix;
    PointId track;
  };
  std::vector<Begin> begins_;  // of segments
};

class TimeWindows {
 public:
  // With so much memory for what waits to be written. Errors: kWriteFailed, also where the folder
  // has too little room.
  static Result<TimeWindows> make(TimeCut cut, const std::string& folder, std::size_t memory_bytes);

  // All fixes into their windows. Tells the gaps, in ascending order of agents, then times. Errors:
  // those of reading and writing; kStopped where the watcher ends it.
  Status distribute(const StoredFixes& fixes, double max_gap_s, RepeatedFixes& repeated,
                    const LargeGapVisitor& gaps, const FixWatcher& watch);

  [[nodiscard]] std::size_t count() const { return blocks_.size(); }
  [[nodiscard]] const WindowSize& size(std::size_t window) const { return cut_.sizes[window]; }

  // Errors: kReadFailed, kCorrupt.
  Status read(std::size_t window, WindowTracks& tracks) const;

 private:
  struct Row {
    AgentId agent;
    Fix fix;
    double height_m;
  };

  TimeWindows(TimeCut cut, BlockFile file, std::size_t at_a_time);
  Status put(const StoredFix& fix, std::size_t first, std::size_t last);
  Status write(std::size_t window);

  TimeCut cut_;
  BlockFile file_;
  std::size_t at_a_time_;                              // rows of a window that wait
  std::vector<std::vector<Row>> waiting_;              // of each window
  std::vector<std::vector<BlockFile::Block>> blocks_;  // of each window
};

}  // namespace beespace::out_of_core
