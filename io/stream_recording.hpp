// From files, folders or standard input to fixes, a block after the other: for recordings that
// memory does not hold. What is known of bees stays in memory: their ids.
//
// Reads text tables of fixes, plain or gzip-compressed, as load_recording() does. Whether positions
// are degrees or metres must be said by the header or by the caller: the values could tell only all
// together.
#pragma once

#include "io/bytes/byte_source.hpp"
#include "io/bytes/byte_stream.hpp"
#include "io/bytes/progress.hpp"
#include "io/frames/frame_witness.hpp"
#include "io/recording/excursions.hpp"
#include "io/recording/frozen_places.hpp"
#include "io/recording/jumps.hpp"
#include "io/recording/recording.hpp"
#include "io/recording/recording_assembly.hpp"
#include "io/recording/recording_options.hpp"
#include "io/recording/restart_watch.hpp"
#include "io/recording/shared_id.hpp"
#include "io/recording/stale_places.hpp"
#include "io/recording/zero_places.hpp"
#include "io/recording/zero_runs.hpp"
#include "io/tracks/track_table.hpp"

#include <beespace/mover.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace beespace::io {

struct StreamedFix {
  std::size_t bee;  // in the order in which the input names them first
  Fix fix;
  std::optional<double> stated_height;  // as RecordedBee::stated_heights
};

class RecordingStream {
 public:
  // Names of files and folders, or "-", as of load_recording(); blocks of about so many bytes.
  // Errors: kInvalidArgument, and those of folders.
  static Result<RecordingStream> open(const std::vector<std::string>& paths,
                                      const RecordingOptions& options, std::size_t block_bytes);

  // The next fixes, in the order of the input; none at the end. Errors: those of load_recording()
  // but for what only all fixes can tell; kUnknownFrame where values would have to tell the frame;
  // kUnsupportedFormat for what is no table.
  Status next(std::vector<StreamedFix>& fixes);

  // From the first fix on.
  [[nodiscard]] Frame frame() const { return assembly_->facts()->frame; }
  [[nodiscard]] Unit height_unit() const { return assembly_->facts()->height_unit; }
  // Whether files state heights in several units.
  [[nodiscard]] bool several_height_units() const { return assembly_->several_height_units(); }
  // Whether some fix so far has a velocity, which is not among what next() tells.
  [[nodiscard]] bool any_velocity() const { return assembly_->tracks().any_velocity(); }
  [[nodiscard]] const std::string& id(std::size_t bee) const { return assembly_->tracks().id(bee); }

  // Of two fixes of a bee, counted from 0, that are at one time but at different places.
  [[nodiscard]] Error clash(std::size_t bee, double time_s, std::uint64_t first,
                            std::uint64_t second) const;
  // At the end: all but the fixes, of which so many came again. Errors: as load_recording().
  Result<Recording> finish(std::uint64_t repeated);

 private:
  explicit RecordingStream(const RecordingOptions& options);

  Status begin_source();
  Status begin_table(const std::string& path);
  Status end_source();
  Status read_lines();
  [[nodiscard]] Error placed(Error error) const;
  // At least so many bytes are pending, unless the input ends before.
  Status want(std::size_t bytes);
  [[nodiscard]] std::string_view pending() const { return pending_->view().substr(at_); }
  [[nodiscard]] std::string_view beginning() const;
  [[nodiscard]] Origin origin_of(std::uint64_t fix) const;
  [[nodiscard]] bool is_nowhere(const Fix& fix);
  void look_for_doubt(std::size_t bee, const Fix& fix, const Velocity* velocity, Origin origin);
  void look_whether_lost(std::size_t bee, const Fix& fix);
  void lose_unordered();
  void look_whether_frozen(std::size_t bee, const Fix& fix, const Velocity* velocity);
  // As text in UTF-8, in `converted` where it is none.
  std::string_view readable(std::string_view text, std::optional<Bytes>& converted);
  [[nodiscard]] std::optional<Error> zero_run_problem() const;
  [[nodiscard]] std::optional<Error> frozen_problem() const;
  [[nodiscard]] std::optional<Error> restart_problem() const;

  std::unique_ptr<RecordingOptions> options_;
  Progress* progress_;  // of bytes of files, packed as they are
  std::unique_ptr<RecordingAssembly> assembly_;
  std::size_t block_bytes_ = 0;
  std::vector<std::string> files_;
  std::size_t next_file_ = 0;

  std::optional<ByteStream> stream_;  // of the file that is being read
  std::unique_ptr<GrowingBytes> pending_ = std::make_unique<GrowingBytes>();
  std::size_t at_ = 0;  // in it
  bool ended_ = false;  // the stream
  std::optional<TrackTableReader> table_;
  std::uint64_t bytes_before_ = 0;
  // Of that file: what was there before it, and its times.
  std::uint64_t fixes_before_ = 0;
  std::size_t bees_before_ = 0;
  std::optional<double> first_s_;
  bool several_times_ = false;

  // Fixes from `fix` on stand in consecutive lines.
  struct Place {
    std::uint64_t fix;
    Origin origin;
  };
  std::vector<Place> places_;
  std::uint64_t fixes_ = 0;
  std::optional<Origin> last_;
  std::optional<FrameWitness> witness_;  // where values may contradict names
  std::vector<SharedId> shared_;         // by bee
  std::vector<Jumps> jumps_;             // the same
  std::vector<ExcursionWatch> excursions_;
  std::vector<bool> jumping_;       // whose jumps have been told
  std::vector<StalePlaces> stale_;  // by bee
  ZeroPlaces zeros_;
  std::vector<ZeroRunWatch> zero_runs_;  // by bee, of places in metres
  // By bee: its latest fix, and whether some go back in time.
  struct Last {
    std::optional<double> time_s = {};
    bool goes_back = false;
  };
  std::vector<Last> last_fix_;
  std::vector<RestartWatch> clocks_;                    // by bee, of times with a zero of their own
  std::vector<FrozenWatch> frozen_;                     // by bee
  std::vector<std::optional<std::uint64_t>> led_away_;  // the same: the first such fix
};

}  // namespace beespace::io
