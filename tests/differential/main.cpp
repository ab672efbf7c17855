// Random scenes, made by an adversary, and the library's answers about them against an oracle that
// shares nothing with it: as long as wanted, and the same again for the same seed.
//
//   differential_fuzzer --seconds 60 --seed 1
//   differential_fuzzer --seed 1 --only spheres --first 4711 --scenes 1     one scene again
#include "tests/differential/examiner.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace beespace::differential {

namespace {

struct Options {
  double seconds = 60.0;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;
  std::uint64_t scenes = std::numeric_limits<std::uint64_t>::max();  // of each kind
  std::string only = {};                                             // the name of an examiner
};

[[noreturn]] void explain() {
  std::fputs(
      "usage: differential_fuzzer [--seconds N] [--seed S] [--only KIND] [--first K] [--scenes N]\n"
      "  --seconds N  how long, at most (60)\n"
      "  --seed S     of the random numbers (1)\n"
      "  --only KIND  only scenes of this kind\n"
      "  --first K    begins with scene K of each kind (0)\n"
      "  --scenes N   ends after N scenes of each kind\n"
      "Ends with 0 when all answers were right, with 1 at the first that was not, which it "
      "shows.\n",
      stderr);
  std::exit(2);
}

Options options_of(int count, char** words) {
  Options options;
  for (int i = 1; i < count; i += 2) {
    const std::string name = words[i];
    if (i + 1 == count) explain();
    const char* value = words[i + 1];
    char* end = nullptr;
    if (name == "--only") {
      options.only = value;
      continue;
    }
    if (name == "--seconds") {
      options.seconds = std::strtod(value, &end);
    } else if (name == "--seed") {
      options.seed = std::strtoull(value, &end, 10);
    } else if (name == "--first") {
      options.first = std::strtoull(value, &end, 10);
    } else if (name == "--scenes") {
      options.scenes = std::strtoull(value, &end, 10);
    }
    if (end == nullptr || end == value || *end != '\0') explain();
  }
  return options;
}

class Clock {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  }

 private:
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

void show(const std::vector<Examiner>& examiners, const std::vector<Tally>& tallies) {
  for (std::size_t kind = 0; kind < examiners.size(); ++kind) {
    std::printf("%s: %llu scenes\n", examiners[kind].name.c_str(),
                static_cast<unsigned long long>(tallies[kind].scenes()));
    for (const auto& [question, count] : tallies[kind].answers()) {
      std::printf("  %12llu  %s\n", static_cast<unsigned long long>(count), question.c_str());
    }
  }
}

int run(const Options& options) {
  std::vector<Examiner> examiners;
  for (Examiner& one : all_examiners()) {
    if (options.only.empty() || options.only == one.name) examiners.push_back(std::move(one));
  }
  if (examiners.empty()) {
    std::fprintf(stderr, "no kind of scenes is called '%s'; there are", options.only.c_str());
    for (const Examiner& one : all_examiners()) std::fprintf(stderr, " %s", one.name.c_str());
    std::fputs("\n", stderr);
    return 2;
  }
  std::vector<Tally> tallies(examiners.size());
  const Clock clock;
  for (std::uint64_t done = 0; done < options.scenes; ++done) {
    const std::uint64_t scene = options.first + done;
    for (std::size_t kind = 0; kind < examiners.size(); ++kind) {
      if (clock.seconds() >= options.seconds) {
        show(examiners, tallies);
        std::printf("no difference in %.0f s, seed %llu\n", clock.seconds(),
                    static_cast<unsigned long long>(options.seed));
        return 0;
      }
      Random random(options.seed, scene);
      const auto difference = examiners[kind].examine(random, tallies[kind]);
      if (!difference) continue;
      show(examiners, tallies);
      std::printf(
          "DIFFERENCE after %.1f s, to be had again with\n"
          "  differential_fuzzer --seed %llu --only %s --first %llu --scenes 1\n%s",
          clock.seconds(), static_cast<unsigned long long>(options.seed),
          examiners[kind].name.c_str(), static_cast<unsigned long long>(scene),
          difference->c_str());
      return 1;
    }
  }
  show(examiners, tallies);
  std::printf("no difference in %.0f s, seed %llu\n", clock.seconds(),
              static_cast<unsigned long long>(options.seed));
  return 0;
}

}  // namespace

}  // namespace beespace::differential

int main(int count, char** words) {
  return beespace::differential::run(beespace::differential::options_of(count, words));
}
