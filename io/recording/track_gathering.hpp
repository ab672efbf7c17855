// Fixes in the order of the input -> bees, each with its fixes in the order of time.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/recording/jumped_stretches.hpp"
#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>
#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace beespace::io {

// Where a fix was read.
struct Origin {
  std::uint64_t source : 24 = 0;  // as the caller counts them
  std::uint64_t line : 40 = 0;    // 1-based
};

// Two fixes of one bee at one time that are at different places.
struct TimeConflict {
  std::string id;
  double time_s;
  Origin first;
  Origin second;  // behind the first in the input
};

// An id that two bees seem to share, as the first jump to and fro shows it; or one that jumps.
struct SharedTrack {
  std::string id;
  double time_s;
  Origin first;
};

struct RestartedClock;

class TrackGathering {
 public:
  // A fix of that bee. Without velocity, or with one that may hold not-a-numbers. `stated_height`
  // is that of an input in another unit than the metre.
  void add(std::string_view id, const Fix& fix, const Velocity* velocity, Origin origin,
           std::optional<double> stated_height = {});
  // A bee of its own, whatever its id.
  void add_path(std::string id, BezierPath path);
  // The same, of a drone that never takes off.
  void add_standing(std::string id, const Point& at);

  // What that bee, which has a fix, is called from then on.
  void label(std::string_view id, std::string_view text, double time_s);
  // From here on times are known to be rounded, or to be those of arrival, as in telemetry: a bee
  // that is at the same place again within `repeat_s` was heard once, and of two places at one time
  // the second in the input is no conflict.
  void round_times(double repeat_s) { repeat_s_ = repeat_s; }

  [[nodiscard]] bool empty() const { return bees_.empty(); }
  // Whether some fix came with a velocity.
  [[nodiscard]] bool any_velocity() const { return any_velocity_; }
  [[nodiscard]] bool contains(std::string_view id) const { return index_.contains(id); }
  // Where fix `index` comes from, counted bee by bee, and all their positions in that order.
  [[nodiscard]] Origin origin(std::size_t index) const;
  [[nodiscard]] std::vector<Point> positions() const;
  // 0 where none is higher.
  [[nodiscard]] double highest_m() const;

  // Brings each bee's fixes into the order of time: stable, and of the same fix said twice one is
  // kept. Of two at the same time but at different places the second in the input is left out and
  // handed to `conflict`, in no particular order; with rounded times to `far`, and only if it is
  // farther away than what flies gets while times are rounded.
  using TakeConflict = std::function<void(const TimeConflict&)>;
  void settle(Frame frame, const TakeConflict& conflict, const TakeConflict& far);

  // Calls take() with all fixes that were not taken before, in the
  // order of the input; bees are counted in the order in which they came first. Bees stay, without
  // fixes to settle.
  struct Taken {
    std::size_t bee;
    Fix fix;
    const Velocity* velocity;  // or null
    std::optional<double> stated_height;
    Origin origin;
  };
  using Take = std::function<void(const Taken&)>;
  void drain(const Take& take);
  // Fixes that were taken, and found to come again.
  void add_repeated(std::uint64_t count) { repeated_ += count; }
  [[nodiscard]] const std::string& id(std::size_t bee) const { return bees_[bee].recorded.id; }
  [[nodiscard]] const RecordedBee& recorded(std::size_t bee) const { return bees_[bee].recorded; }
  [[nodiscard]] std::size_t size() const { return bees_.size(); }

  // From the first to the last time of the fixes of a source, whatever became of them; nothing of
  // one without any.
  [[nodiscard]] std::optional<TimeSpan> span_of(std::uint32_t source) const;

  // What was found by add() and settle().
  [[nodiscard]] std::uint64_t out_of_order() const { return out_of_order_; }
  [[nodiscard]] std::uint64_t repeated() const { return repeated_; }
  // How many records say another place for a time that their bee has been heard at, by rounding.
  [[nodiscard]] std::uint64_t clashing() const { return clashing_; }
  [[nodiscard]] std::uint64_t in_several_sources() const { return in_several_sources_; }
  // How many bees got another id since theirs was taken already ("drone", "drone#2").
  [[nodiscard]] std::uint64_t renamed() const { return renamed_; }

  // Leaves out all fixes that are at no place, each of which `told` hears of with its bee's id; of
  // who has no other fix nothing is left. `which` says it of all those of a bee; empty where none
  // is.
  using Which = std::function<std::vector<bool>(const RecordedBee&)>;
  using Told = std::function<void(const std::string& id, const Fix& fix)>;
  void leave_out(const Which& which, const Told& told);

  // Once all is settled; of each bee the first jump.
  [[nodiscard]] std::vector<SharedTrack> shared(Frame frame) const;
  [[nodiscard]] std::vector<SharedTrack> jumping(const JumpsOf& of) const;
  // The same of who is in several sources at the same time, at places that do not go together.
  [[nodiscard]] std::vector<TimeConflict> contradicting(Frame frame) const;
  // Before settle(): where the clock of all begins again.
  [[nodiscard]] std::optional<RestartedClock> restarted(Frame frame) const;
  // Whether times are rounded, or those of arrival.
  [[nodiscard]] bool rounds_times() const { return repeat_s_.has_value(); }

  // In the order in which they came first. Nothing is left here.
  std::vector<RecordedBee> release();

 private:
  struct Bee {
    RecordedBee recorded;
    std::vector<Origin> origins;
    bool several_sources = false;
    std::size_t taken = 0;  // of the fixes: the last one that drain() has told of, or none
    bool waits = false;     // some were not told of
    // Of times that are those of arrival: how often it was elsewhere at the same, and when first.
    std::uint64_t clashes = 0;
    std::optional<SharedTrack> clashed = {};
  };
  struct TextHash {
    using is_transparent = void;  // NOLINT(readability-identifier-naming): the library's name
    std::size_t operator()(std::string_view text) const {
      return std::hash<std::string_view>()(text);
    }
  };

  Bee& bee_of(std::string_view id);
  void settle(Bee& bee, Frame frame, const TakeConflict& conflict, const TakeConflict& far);

  std::vector<Bee> bees_;
  std::vector<std::optional<TimeSpan>> spans_;  // by source
  std::unordered_map<std::string, std::size_t, TextHash, std::equal_to<>> index_;
  std::vector<std::size_t> waiting_;  // bees with fixes that drain() has not told of
  std::size_t last_ = 0;              // records of one bee often follow each other
  bool any_velocity_ = false;
  std::uint64_t out_of_order_ = 0;
  std::uint64_t repeated_ = 0;
  std::uint64_t clashing_ = 0;
  std::optional<double> repeat_s_;  // of rounded times
  std::uint64_t in_several_sources_ = 0;
  std::uint64_t renamed_ = 0;
};

}  // namespace beespace::io
