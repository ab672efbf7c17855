// How fast a recording beyond memory is searched for conflicts, and with how much memory: beside
// the same search in memory.
//
//   recording_out_of_core_benchmark [FIXES [MEMORY_MB [FOLDER]]]     (3e7 fixes, 200 MB, /var/tmp)
//
// Agents that turn every now and then, one fix a second each, as they come to a receiver: all
// agents of one second, then those of the next one. They come and go.
#include <beespace/find_conflicts.hpp>
#include <beespace/recording_out_of_core.hpp>

#include "bench/peak_memory.hpp"
#include "scenes/random_stream.hpp"

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

namespace {

using beespace::AgentId;
using beespace::Point;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kAgents = 10'000;
constexpr double kThreshold_m = 50.0;
constexpr double kSide_m = 10'000.0;
constexpr double kSpeed_mps = 20.0;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// The fixes of one second after the other.
class Flights {
 public:
  Flights() : agents_(kAgents), positions_(kAgents), velocities_(kAgents) {
    for (std::size_t agent = 0; agent < kAgents; ++agent) {
      agents_[agent] = agent;
      positions_[agent] = {random_.uniform(0.0, kSide_m), random_.uniform(0.0, kSide_m),
                           random_.uniform(0.0, kSide_m / 20.0)};
      turn(agent);
    }
  }

  void next() {
    for (std::size_t agent = 0; agent < kAgents; ++agent) {
      if (random_.index(30) == 0) turn(agent);
      // A new one comes somewhere else, now and then.
      if (random_.index(2000) == 0) agents_[agent] += kAgents;
      Point& p = positions_[agent];
      Point& v = velocities_[agent];
      p = {p.x + v.x, p.y + v.y, p.z + v.z};
      if (p.x < 0.0 || p.x > kSide_m) v.x = -v.x;
      if (p.y < 0.0 || p.y > kSide_m) v.y = -v.y;
      if (p.z < 0.0 || p.z > kSide_m / 20.0) v.z = -v.z;
    }
    times_.assign(kAgents, seconds_);
    seconds_ += 1.0;
  }

  [[nodiscard]] const std::vector<AgentId>& agents() const { return agents_; }
  [[nodiscard]] const std::vector<double>& times() const { return times_; }
  [[nodiscard]] const std::vector<Point>& positions() const { return positions_; }

 private:
  void turn(std::size_t agent) {
    const double direction = random_.uniform(0.0, 6.283185307179586);
    velocities_[agent] = {kSpeed_mps * std::cos(direction), kSpeed_mps * std::sin(direction),
                          random_.uniform(-2.0, 2.0)};
  }

  beespace::scenes::RandomStream random_{1};
  std::vector<AgentId> agents_;
  std::vector<Point> positions_;
  std::vector<Point> velocities_;
  std::vector<double> times_;
  double seconds_ = 0.0;
};

[[noreturn]] void fail(const beespace::Error& error) {
  std::fprintf(stderr, "%s\n", to_string(error).c_str());
  std::exit(1);
}

struct Found {
  double seconds;
  std::uint64_t conflicts;
  double sum_s;  // of all their times: the same answer has the same one
};

Found out_of_core(std::size_t seconds, std::uint64_t memory, const std::string& folder) {
  beespace::OutOfCoreOptions options;
  options.memory_bytes = memory;
  options.folder = folder;
  options.threads = 0;
  double distributed_s = 0.0;
  double added_s = 0.0;
  auto begin = Clock::now();
  options.progress = [&](const beespace::OutOfCoreProgress& progress) {
    if (progress.phase == beespace::OutOfCoreProgress::Phase::kDistributing) {
      distributed_s = seconds_since(begin);
    }
  };
  Found found{0.0, 0, 0.0};
  Flights flights;
  beespace::RecordingOutOfCore recording(options);
  const std::uint64_t before = beespace::bench::anonymous_bytes();
  const beespace::bench::PeakMemory watched;
  for (std::size_t second = 0; second < seconds; ++second) {
    flights.next();
    begin = Clock::now();
    const auto added = recording.add(flights.agents(), flights.times(),
                                     std::span<const Point>(flights.positions()));
    if (!added) fail(added.error());
    added_s += seconds_since(begin);
  }
  begin = Clock::now();
  const auto status = recording.find_conflicts(
      {.threshold_m = kThreshold_m}, [&](std::span<const beespace::LargeConflict> some) {
        found.conflicts += some.size();
        for (const auto& conflict : some) found.sum_s += conflict.begins_s + conflict.ends_s;
      });
  if (!status) fail(status.error());
  found.seconds = added_s + seconds_since(begin);
  const auto facts = recording.facts();
  const auto fixes = static_cast<double>(recording.size());
  std::printf(
      "recording  %11.0f fixes: %7.1f s (adding %.1f, distributing %.1f), %5.0f ns a fix, %6.0f MB "
      "of %.0f; %llu windows, %.1f %% copies; %llu conflicts\n",
      fixes, found.seconds, added_s, distributed_s, found.seconds / fixes * 1e9,
      static_cast<double>(watched.bytes() - before) / 1e6, static_cast<double>(memory) / 1e6,
      static_cast<unsigned long long>(facts.windows),
      100.0 * static_cast<double>(facts.copies) / fixes,
      static_cast<unsigned long long>(found.conflicts));
  return found;
}

// Making tracks of fixes as they come is a part of it.
Found in_memory(std::size_t seconds) {
  Flights flights;
  std::vector<beespace::Track> tracks;
  double added_s = 0.0;
  for (std::size_t second = 0; second < seconds; ++second) {
    flights.next();
    const auto begin = Clock::now();
    for (std::size_t at = 0; at < kAgents; ++at) {
      const auto agent = static_cast<std::size_t>(flights.agents()[at]);
      if (agent >= tracks.size()) tracks.resize(agent + 1);
      tracks[agent].fixes.push_back({flights.times()[at], flights.positions()[at]});
    }
    added_s += seconds_since(begin);
  }
  const auto begin = Clock::now();
  const auto answer = beespace::find_conflicts(tracks, {.threshold_m = kThreshold_m, .threads = 0});
  if (!answer) fail(answer.error());
  Found found{added_s + seconds_since(begin), answer->conflicts.size(), 0.0};
  for (const auto& conflict : answer->conflicts) {
    found.sum_s += conflict.begins_s + conflict.ends_s;
  }
  return found;
}

}  // namespace

int main(int argc, char** argv) {
  const double fixes = argc > 1 ? std::atof(argv[1]) : 3e7;
  const auto memory = static_cast<std::uint64_t>((argc > 2 ? std::atof(argv[2]) : 200.0) * 1e6);
  const std::string folder = argc > 3 ? argv[3] : "/var/tmp";
  const auto seconds = static_cast<std::size_t>(fixes / kAgents);
  const Found cut = out_of_core(seconds, memory, folder);
  const Found whole = in_memory(seconds);
  const double count = static_cast<double>(seconds) * kAgents;
  const bool same = cut.conflicts == whole.conflicts && cut.sum_s == whole.sum_s;
  std::printf("%-10s %11.0f in memory: %6.1f s, %5.0f ns a fix; ratio %.2f; %s\n", "", count,
              whole.seconds, whole.seconds / count * 1e9, cut.seconds / whole.seconds,
              same ? "the same answer" : "ANOTHER ANSWER");
  return same ? 0 : 1;
}
