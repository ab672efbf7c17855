// The parts of the fuzzer: examiners, each of which makes scenes of one kind, runs all variants of
// the library on them, and compares the answers with an oracle.
#pragma once

#include "tests/differential/random.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace beespace::differential {

// How much was examined.
class Tally {
 public:
  void scene() { ++scenes_; }
  void answer(const std::string& question) { ++answers_[question]; }

  [[nodiscard]] std::uint64_t scenes() const { return scenes_; }
  [[nodiscard]] const std::map<std::string, std::uint64_t>& answers() const { return answers_; }

 private:
  std::uint64_t scenes_ = 0;
  std::map<std::string, std::uint64_t> answers_;
};

struct Examiner {
  std::string name;
  // Makes a scene of the random numbers and examines it. Returns the difference that was found, as
  // text from which it can be had again.
  std::function<std::optional<std::string>(Random&, Tally&)> examine;
};

// For snapshots, with or without a vertical threshold.
Examiner snapshot_examiner(const std::string& name, bool upright);
// For an Index that changes.
Examiner index_examiner();
// For movers until a horizon.
Examiner prediction_examiner();
// For tracks.
Examiner recording_examiner();
// For reports that come one by one.
Examiner swarm_examiner();

std::vector<Examiner> all_examiners();

}  // namespace beespace::differential
