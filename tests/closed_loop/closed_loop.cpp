#include "tests/closed_loop/closed_loop.hpp"

#include "tests/closed_loop/looks.hpp"
#include "tests/closed_loop/true_bee.hpp"
#include "tests/closed_loop/watch_process.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace beespace::closed_loop {
namespace {

constexpr int kPatience_ms = 5000;
constexpr int kFirstSteps = 3;  // until it is known how often bees report
constexpr int kFirstPatience_ms = 120;

std::vector<std::string> watch_arguments(const FlightPlan& plan) {
  const auto text = [](double value) {
    char out[40];
    std::snprintf(out, sizeof out, "%.17g", value);
    return std::string(out);
  };
  return {"watch",
          "--advise",
          "--horizon",
          "0",
          "--threshold",
          text(plan.threshold_m),
          "--step",
          text(plan.step_s),
          "--max-speed",
          text(plan.max_speed_mps),
          "--max-acceleration",
          std::isinf(plan.max_acceleration_mps2) ? "none" : text(plan.max_acceleration_mps2),
          "--uncertainty",
          text(plan.uncertainty_m),
          "--max-age",
          text(plan.max_age_s)};
}

class Loop {
 public:
  Loop(const std::string& command, const FlightPlan& plan, const std::string& flown_path)
      : command_(command),
        plan_(plan),
        flown_path_(flown_path),
        flown_(flown_path_),
        random_(plan.seed),
        watch_(command, watch_arguments(plan)) {
    bees_.reserve(plan.bees.size());
    for (std::size_t i = 0; i < plan.bees.size(); ++i) {
      bees_.emplace_back(std::string("b").append(std::to_string(i)), plan.bees[i], plan,
                         random_.bits());
    }
    flown_ << "id,time_s,x,y,z,vx,vy,vz\n";
    watch_.send(header());
  }

  Outcome run() {
    write_flown(0, true);
    // A look that does not come is waited for: a few tell enough.
    constexpr std::uint64_t kMostMissing = 3;
    for (int step = 0; step < plan_.steps && outcome_.looks_missing < kMostMissing; ++step) {
      fly(step);
      write_flown(step + 1, false);
      judge(step);
      for (TrueBee& bee : bees_) bee.heard_before_s = bee.heard_s;
      send_reports(step);
      next_ = await_look(step);
      if (!next_ && step >= kFirstSteps) ++outcome_.looks_missing;
    }
    end();
    return std::move(outcome_);
  }

 private:
  void fly(int step) {
    // The advice of the step before takes effect.
    before_ = std::exchange(certified_, {});
    if (next_) {
      certified_ = certified_in(*next_);
      look_ = *next_;
      heard_at_look_.clear();
      for (const TrueBee& bee : bees_) {
        heard_at_look_.push_back(bee.heard_before_s);
        check_conditions(step - 1, bee);
      }
    } else {
      certified_ = before_;
    }
    for (TrueBee& bee : bees_) {
      std::optional<Vector> advised;
      if (next_) {
        const auto named = next_->bees.find(bee.id());
        if (named != next_->bees.end()) advised = named->second.velocity;
      }
      bee.fly(step, next_.has_value() || !bee.named, advised);
    }
  }

  // What must hold of bees that are certified in a round of advice.
  void check_conditions(int step, const TrueBee& bee) {
    if (certified_.count(bee.id()) == 0) return;
    constexpr double kOldest = 2.05;
    const double age = step - bee.heard_s / plan_.step_s;
    if (plan_.velocities && age <= kOldest) return;
    outcome_.broken.push_back(bee.id() + " is certified with a report that is " +
                              std::to_string(age) + " steps old" +
                              (plan_.velocities ? "" : " and says no velocity"));
  }

  std::set<std::string> certified_in(const Look& look) {
    std::set<std::string> certified;
    ++outcome_.looks;
    for (TrueBee& bee : bees_) {
      const auto named = look.bees.find(bee.id());
      if (named != look.bees.end()) bee.named = true;
      if (!bee.named) continue;
      const bool is = named == look.bees.end() || named->second.certified;
      if (is) certified.insert(bee.id());
      ++(is ? outcome_.certified : outcome_.uncertified);
      if (!is) ++outcome_.because[named->second.because];
    }
    return certified;
  }

  // Whether each pair of bees that were both certified for this step kept its distance in it, if
  // both have flown as advised since watch heard them first.
  void judge(int step) {
    // Reports with an error of this size confirm paths with a larger error.
    constexpr double kSteps = 4;
    const Faults& faults = plan_.faults;
    const double least =
        plan_.threshold_m - 2 * (faults.position_m + kSteps * plan_.step_s * faults.velocity_mps);
    for (std::size_t i = 0; i < bees_.size(); ++i) {
      for (std::size_t j = i + 1; j < bees_.size(); ++j) {
        const auto apart = static_cast<double>(closest(bees_[i].stretch(), bees_[j].stretch()));
        outcome_.closest_m = std::min(outcome_.closest_m, apart);
        if (apart < plan_.threshold_m) ++outcome_.losses;
        // The other bee keeps its distance from a stale one, whatever that one does.
        const bool i_is = promised(i);
        const bool j_is = promised(j);
        if (!(i_is && (j_is || stale(j))) && !(j_is && stale(i))) continue;
        ++(i_is && j_is ? outcome_.certified_pairs : outcome_.stale_pairs);
        outcome_.closest_certified_m = std::min(outcome_.closest_certified_m, apart);
        if (apart >= least) continue;
        outcome_.broken.push_back(
            bees_[i].id() + " and " + bees_[j].id() +
            (i_is && j_is ? " are certified and " : ", one of which is stale, ") +
            std::to_string(apart) + " m apart in step " + std::to_string(step) +
            ", by: " + look_.closing);
      }
    }
  }

  bool promised(std::size_t i) const {
    if (certified_.count(bees_[i].id()) == 0) return false;
    const double since_s = heard_at_look_[i];
    if (since_s < 0) return false;
    return bees_[i].as_advised_since(static_cast<int>(std::floor(since_s / plan_.step_s + 1e-6)));
  }

  bool stale(std::size_t i) const {
    const auto named = look_.bees.find(bees_[i].id());
    return named != look_.bees.end() && named->second.because == "stale";
  }

  void send_reports(int step) {
    for (TrueBee& bee : bees_) {
      for (TrueBee::Line& line : bee.reports(step)) {
        waiting_.push_back({&bee, std::move(line)});
      }
    }
    if (plan_.shuffled) {
      for (std::size_t i = waiting_.size(); i > 1; --i) {
        std::swap(waiting_[i - 1], waiting_[random_.below(i)]);
      }
    } else {
      std::stable_sort(waiting_.begin(), waiting_.end(), [](const Waiting& a, const Waiting& b) {
        return a.line.sent_s < b.line.sent_s;
      });
    }
    std::string text;
    const double ends_s = (step + 1) * plan_.step_s;
    std::vector<Waiting> later;
    for (Waiting& one : waiting_) {
      if (one.line.sent_s >= ends_s) {
        later.push_back(std::move(one));
        continue;
      }
      // Not before the first report: it is of no kind that is known.
      if (sent_any_ && random_.happens(plan_.faults.garbage / 10)) text += garbage();
      text += one.line.text;
      sent_any_ = true;
      one.bee->heard_s = std::max(one.bee->heard_s, one.line.made_s);
    }
    waiting_ = std::move(later);
    if (sent_any_ && random_.happens(plan_.faults.garbage)) text += garbage();
    if (plan_.beacon) {
      char line[200];
      std::snprintf(line, sizeof line, "beacon,%.6f,1e6,1e6,0%s\n",
                    plan_.epoch_s + (step + 0.55) * plan_.step_s, plan_.velocities ? ",0,0,0" : "");
      text += line;
    }
    watch_.send(text);
  }

  [[nodiscard]] const char* header() const {
    return plan_.velocities ? "id,time_s,x,y,z,vx,vy,vz\n" : "id,time_s,x,y,z\n";
  }

  // Lines that are no reports. Another header would end the input.
  std::string garbage() {
    const char* const lines[] = {"\n",
                                 "b0,nan,1,2,3,4,5,6\n",
                                 "b0,1,nan,2,3,0,0,0\n",
                                 "b1,1e300,1,2,3,0,0,0\n",
                                 "b1,1,1e200,2,3,0,0,0\n",
                                 ",,,,,,,\n",
                                 "b1,1\n",
                                 header(),
                                 "\xff\xfe\x01,,;\"\n",
                                 "{\"id\": 3\n"};
    return lines[random_.below(std::size(lines))];
  }

  // The look that is about the step after this one. It may have come before.
  std::optional<Look> await_look(int step) {
    const double wanted_s = plan_.epoch_s + (step + 1) * plan_.step_s;
    const int patience_ms = step < kFirstSteps ? kFirstPatience_ms : kPatience_ms;
    std::string line;
    // Too late to be flown: no promise follows from it.
    const double late_s = wanted_s - 0.1 * plan_.step_s;
    while (said_.empty() || said_.front().effective_s < late_s) {
      if (!said_.empty()) {
        said_.pop_front();
        continue;
      }
      if (!watch_.next_line(line, patience_ms)) return std::nullopt;
      if (auto look = looks_.take(line)) said_.push_back(*std::move(look));
    }
    if (said_.front().effective_s > wanted_s + 0.1 * plan_.step_s) return std::nullopt;
    Look look = std::move(said_.front());
    said_.pop_front();
    return look;
  }

  void write_flown(int step, bool first) {
    char text[400];
    for (const TrueBee& bee : bees_) {
      const Vector p = first ? bee.stretch().position : bee.position();
      const Vector v = first ? bee.stretch().velocity : bee.velocity();
      std::snprintf(text, sizeof text, "%s,%.6f,%.17Lg,%.17Lg,%.17Lg,%.17Lg,%.17Lg,%.17Lg\n",
                    bee.id().c_str(), step * plan_.step_s, p[0], p[1], p[2], v[0], v[1], v[2]);
      flown_ << text;
    }
  }

  void end() {
    outcome_.watch_status = watch_.finish();
    outcome_.watch_errors = watch_.errors();
    flown_.close();
    char threshold[40];
    std::snprintf(threshold, sizeof threshold, "%.17g", plan_.threshold_m);
    std::vector<std::string> arguments = {"verify", flown_path_, "--threshold", threshold,
                                          "--quiet"};
    if (std::isinf(plan_.max_acceleration_mps2)) {
      arguments.emplace_back("--straight");
    } else {
      arguments.emplace_back("--max-acceleration");
      arguments.push_back(std::to_string(plan_.max_acceleration_mps2 * 1.001));
    }
    WatchProcess verify(command_, arguments);
    outcome_.verify_status = verify.finish();
    if (outcome_.watch_status != 0) {
      outcome_.broken.push_back("watch ended with " + std::to_string(outcome_.watch_status));
    }
    const bool agree = (outcome_.verify_status == 1) == (outcome_.losses > 0) ||
                       std::abs(outcome_.closest_m - plan_.threshold_m) < 1e-9;
    if (!agree || outcome_.verify_status > 1) {
      outcome_.broken.push_back("verify ended with " + std::to_string(outcome_.verify_status) +
                                ": " + verify.errors());
    }
  }

  struct Waiting {
    TrueBee* bee;
    TrueBee::Line line;
  };

  std::string command_;
  const FlightPlan& plan_;
  std::string flown_path_;
  std::ofstream flown_;
  Random random_;
  WatchProcess watch_;
  std::vector<TrueBee> bees_;
  std::vector<Waiting> waiting_;
  bool sent_any_ = false;
  Looks looks_;
  std::deque<Look> said_;     // looks that have come, and are not yet flown by
  std::optional<Look> next_;  // of the step to come
  Look look_;                 // the last that was flown by
  std::set<std::string> certified_;
  std::set<std::string> before_;
  std::vector<double> heard_at_look_;
  Outcome outcome_;
};

}  // namespace

Outcome fly(const std::string& command, const FlightPlan& plan, const std::string& flown_path) {
  return Loop(command, plan, flown_path).run();
}

}  // namespace beespace::closed_loop
