#include "out_of_core/recorded/time_windows.hpp"

#include "base/stopping.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

namespace beespace::out_of_core {

namespace {

constexpr std::size_t kLeastBytesWaiting = 512;
constexpr std::size_t kMostBytesWaiting = std::size_t{1} << 18U;
constexpr std::size_t kGapsAtOnce = 1024;

// Gaps, some at a time.
class GapsToTell {
 public:
  explicit GapsToTell(const LargeGapVisitor& visit) : visit_(visit) {}
  void add(const LargeGap& gap) {
    gaps_.push_back(gap);
    if (gaps_.size() == kGapsAtOnce) flush();
  }
  void flush() {
    if (!gaps_.empty() && visit_) visit_(gaps_);
    gaps_.clear();
  }

 private:
  const LargeGapVisitor& visit_;
  std::vector<LargeGap> gaps_;
};

}  // namespace

WindowTracks::WindowTracks(std::uint64_t most, bool have_heights, double max_gap_s)
    : max_gap_s_(max_gap_s), have_heights_(have_heights) {
  fixes_.reserve(static_cast<std::size_t>(most));
  if (have_heights) heights_.reserve(static_cast<std::size_t>(most));
}

void WindowTracks::start() {
  fixes_.clear();
  heights_.clear();
  agents_.clear();
  begins_.clear();
}

void WindowTracks::add(AgentId agent, const Fix& fix, double height_m) {
  const bool is_new = agents_.empty() || agents_.back() != agent;
  if (is_new) agents_.push_back(agent);
  if (is_new || !(fix.time_s - fixes_.back().time_s <= max_gap_s_)) {
    begins_.push_back({fixes_.size(), static_cast<PointId>(agents_.size() - 1)});
  }
  fixes_.push_back(fix);
  if (have_heights_) heights_.push_back(height_m);
}

std::vector<motion::TrackSegment> WindowTracks::segments() const {
  std::vector<motion::TrackSegment> segments;
  segments.reserve(begins_.size());
  for (std::size_t at = 0; at < begins_.size(); ++at) {
    const auto [begin, track] = begins_[at];
    const std::size_t end = at + 1 < begins_.size() ? begins_[at + 1].fix : fixes_.size();
    motion::TrackSegment segment{
        track, 0.0, std::span(fixes_).subspan(begin, end - begin), {}, true};
    if (have_heights_) segment.heights_m = std::span(heights_).subspan(begin, end - begin);
    segments.push_back(segment);
  }
  return segments;
}

TimeWindows::TimeWindows(TimeCut cut, BlockFile file, std::size_t at_a_time)
    : cut_(std::move(cut)),
      file_(std::move(file)),
      at_a_time_(at_a_time),
      waiting_(cut_.sizes.size()),
      blocks_(cut_.sizes.size()) {
}

Result<TimeWindows> TimeWindows::make(TimeCut cut, const std::string& folder,
                                      std::size_t memory_bytes) {
  std::uint64_t rows = 0;
  for (const WindowSize& size : cut.sizes) rows += size.fixes;
  auto file = BlockFile::make(folder, rows * sizeof(Row));
  if (!file) return std::move(file).error();
  const std::size_t bytes =
      std::clamp(memory_bytes / cut.sizes.size(), kLeastBytesWaiting, kMostBytesWaiting);
  return TimeWindows(std::move(cut), *std::move(file), bytes / sizeof(Row));
}

// A fix is in its own window and in those of the pieces that it belongs to: from the window of the
// fix before it, where a piece leads from there, to that of the next one.
Status TimeWindows::distribute(const StoredFixes& fixes, double max_gap_s, RepeatedFixes& repeated,
                               const LargeGapVisitor& gaps, const FixWatcher& watch) {
  struct Waiting {
    StoredFix fix;
    std::size_t first;   // window
    std::size_t window;  // its own
  };
  std::optional<Waiting> before;
  GapsToTell unknown(gaps);
  Status written = std::monostate{};
  auto status = fixes.for_each(repeated, [&](const StoredFix& fix) {
    const bool same = before && before->fix.agent == fix.agent;
    const std::size_t window = cut_.borders.cell_of(fix.fix.time_s, same ? before->window : 0);
    const bool joined = same && fix.fix.time_s - before->fix.fix.time_s <= max_gap_s;
    if (before) written = put(before->fix, before->first, joined ? window : before->window);
    if (same && !joined) unknown.add({fix.agent, before->fix.fix.time_s, fix.fix.time_s});
    before = Waiting{fix, joined ? before->window : window, window};
    if (written && !watch()) written = core::stopped_error();
    return written.has_value();
  });
  if (!status) return status;
  if (written && before) written = put(before->fix, before->first, before->window);
  for (std::size_t window = 0; written && window < count(); ++window) written = write(window);
  std::vector<std::vector<Row>>().swap(waiting_);
  if (written) unknown.flush();
  return written;
}

Status TimeWindows::put(const StoredFix& fix, std::size_t first, std::size_t last) {
  for (std::size_t window = first; window <= last; ++window) {
    std::vector<Row>& rows = waiting_[window];
    if (rows.capacity() < at_a_time_) rows.reserve(at_a_time_);
    rows.push_back({fix.agent, fix.fix, fix.height_m});
    if (rows.size() < at_a_time_) continue;
    if (auto status = write(window); !status) return status;
  }
  return std::monostate{};
}

Status TimeWindows::write(std::size_t window) {
  std::vector<Row>& rows = waiting_[window];
  if (rows.empty()) return std::monostate{};
  const auto block = file_.append(std::as_bytes(std::span(rows)));
  if (!block) return block.error();
  blocks_[window].push_back(*block);
  rows.clear();
  return std::monostate{};
}

Status TimeWindows::read(std::size_t window, WindowTracks& tracks) const {
  tracks.start();
  std::vector<Row> rows;
  for (const BlockFile::Block& block : blocks_[window]) {
    rows.resize(static_cast<std::size_t>(block.bytes) / sizeof(Row));
    if (auto status = file_.read(block, std::as_writable_bytes(std::span(rows))); !status) {
      return status;
    }
    for (const Row& row : rows) tracks.add(row.agent, row.fix, row.height_m);
  }
  return std::monostate{};
}

}  // namespace beespace::out_of_core
