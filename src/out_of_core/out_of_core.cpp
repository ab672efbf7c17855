// The class OutOfCore.
#include <beespace/out_of_core.hpp>

#include "base/kept_crew.hpp"
#include "exact/validate.hpp"
#include "out_of_core/nearest_question.hpp"
#include "out_of_core/plan.hpp"
#include "out_of_core/questions.hpp"
#include "out_of_core/search_cells.hpp"
#include "out_of_core/stored_points.hpp"

#include <beespace/engine.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace beespace {

namespace {

using namespace out_of_core;  // NOLINT(google-build-using-namespace): its own room

// Points that wait for their nearest ones, in the memory of the cell that is not read meanwhile.
std::size_t waiting_within(const Plan& plan, std::size_t length) {
  constexpr std::size_t kBytesOfPoint = 128;
  constexpr std::size_t kBytesOfEntry = 40;
  return std::max<std::size_t>(
      1, plan.cell * CellPoints::bytes_a_point(false) / (kBytesOfPoint + kBytesOfEntry * length));
}

Error invalid_option(const std::string& what) {
  return {ErrorCode::kInvalidArgument, what, {}};
}

}  // namespace

class __attribute__((visibility("hidden"))) OutOfCore::State {
 public:
  explicit State(const OutOfCoreOptions& options) : options_(options), crew_(nullptr) {}

  Status add(const PointsView& points) {
    if (auto error = wrong_points(points)) return *std::move(error);
    if (auto error = core::check_points(points, 0, points.size())) return *std::move(error);
    if (auto error = core::check_heights(points)) return *std::move(error);
    const auto plan = plan_of();
    if (!plan) return plan.error();
    return stored_.copy(points, options_.folder, plan->batch);
  }

  Status refer(const PointsView& points) {
    if (auto error = wrong_points(points)) return *std::move(error);
    return stored_.refer(points);
  }

  [[nodiscard]] std::uint64_t size() const { return stored_.size(); }
  void set_run(const RunOptions& run) {
    options_.threads = run.threads;
    options_.stop = run.stop;
  }
  [[nodiscard]] const OutOfCoreFacts& facts() const { return facts_; }

  Status find_at_risk(const SearchOptions& options, const LargeIdVisitor& visit) {
    return search(options, [&](const SearchOptions& how, const Plan& /*plan*/) {
      return AtRiskQuestion(engine_, how, visit);
    });
  }

  Status visit_pairs(const SearchOptions& options, const LargePairVisitor& visit) {
    return search(options, [&](const SearchOptions& how, const Plan& plan) {
      return PairsQuestion(engine_, how, plan.pairs, visit);
    });
  }

  Status count_neighbors(const SearchOptions& options, const LargeCountVisitor& visit) {
    return search(options, [&](const SearchOptions& how, const Plan& /*plan*/) {
      return CountQuestion(engine_, how, visit);
    });
  }

  Result<std::optional<LargeClosestPair>> find_closest_pair() {
    facts_ = {};
    if (auto error = wrong_heights()) return *std::move(error);
    const auto plan = plan_of();
    if (!plan) return plan.error();
    const RunOptions run(options_.threads, options_.stop);
    const Workplace at = workplace(*plan);
    const auto reach = reach_of_closest_pair(stored_, run, at);
    if (!reach) return reach.error();
    ClosestPairQuestion question(engine_, run);
    if (auto status = ask(question, *reach, at); !status) return std::move(status).error();
    return question.closest();
  }

  Status find_k_nearest(std::size_t k, const LargeNearestVisitor& visit) {
    facts_ = {};
    if (auto error = wrong_heights()) return *std::move(error);
    const auto plan = plan_of();
    if (!plan) return plan.error();
    const auto length = static_cast<std::size_t>(
        std::min<std::uint64_t>(k, std::max<std::uint64_t>(size(), 1) - 1));
    if (length == 0) return std::monostate{};
    const RunOptions run(options_.threads, options_.stop);
    const Workplace at = workplace(*plan);
    const auto reach = reach_of_nearest(stored_, length, run, at);
    if (!reach) return reach.error();
    const NearestQuestion::Setting setting = {run, length, reach->front(), plan->cell / 2,
                                              waiting_within(*plan, length)};
    NearestQuestion question(engine_, setting, visit);
    return ask(question, *reach, at);
  }

 private:
  Crew& crew() { return crew_.of(options_.threads, std::numeric_limits<std::size_t>::max()); }

  Result<Plan> plan_of() {
    if (options_.folder.empty())
      return invalid_option("a folder for temporary files must be named");
    return plan_for(options_.memory_bytes, crew().size(), stored_.have_heights());
  }

  // Searches cell after cell. No two cells have as many points, and what one of them has used would
  // wait for another one in vain.
  Status ask(CellQuestion& question, const Reach& reach, const Workplace& at) {
    engine_.bound_memory(at.plan.kept);
    auto status = search_cells(stored_, reach, at, question, facts_);
    engine_.release_memory();
    return status;
  }

  [[nodiscard]] std::optional<Error> wrong_points(const PointsView& points) const {
    if (!points.fits()) return core::check_size(points);
    if (auto error = core::check_height_count(points)) return error;
    if (size() == 0 || points.empty() || points.has_heights() == stored_.have_heights()) {
      return std::nullopt;
    }
    return invalid_option(points.has_heights()
                              ? "these points have heights apart from their positions, and those "
                                "that came before have none; give them to all, or to none"
                              : "these points have no heights apart from their positions, and "
                                "those that came before have; give them to all, or to none");
  }

  // Of questions without a threshold: the straight line is that of positions.
  [[nodiscard]] std::optional<Error> wrong_heights() const {
    return core::check_no_heights(stored_.have_heights(), core::kPointsName);
  }

  template <class MakeQuestion>
  Status search(const SearchOptions& options, const MakeQuestion& make_question) {
    facts_ = {};
    if (auto error = core::check_options(options)) return *std::move(error);
    const bool heights = stored_.have_heights();
    if (auto error = core::check_vertical(options, size(), heights)) return *std::move(error);
    const auto plan = plan_of();
    if (!plan) return plan.error();
    SearchOptions how = options;
    how.threads = options_.threads;
    how.stop = options_.stop;
    auto question = make_question(how, *plan);
    return ask(question, reach_of(how, heights), workplace(*plan));
  }

  Workplace workplace(const Plan& plan) {
    return {plan, options_.folder, crew(), options_.stop, options_.progress};
  }

  OutOfCoreOptions options_;
  core::KeptCrew crew_;
  Engine engine_;
  StoredPoints stored_;
  OutOfCoreFacts facts_;
};

OutOfCore::OutOfCore(const OutOfCoreOptions& options) : state_(std::make_unique<State>(options)) {
}
OutOfCore::OutOfCore(OutOfCore&&) noexcept = default;
OutOfCore& OutOfCore::operator=(OutOfCore&&) noexcept = default;
OutOfCore::~OutOfCore() = default;

Status OutOfCore::add(const PointsView& points) {
  return state_->add(points);
}

Status OutOfCore::refer(const PointsView& points) {
  return state_->refer(points);
}

std::uint64_t OutOfCore::size() const {
  return state_->size();
}

void OutOfCore::set_run(const RunOptions& run) {
  state_->set_run(run);
}

Status OutOfCore::find_at_risk(const SearchOptions& options, const LargeIdVisitor& visit) {
  return state_->find_at_risk(options, visit);
}

Status OutOfCore::visit_pairs(const SearchOptions& options, const LargePairVisitor& visit) {
  return state_->visit_pairs(options, visit);
}

Status OutOfCore::count_neighbors(const SearchOptions& options, const LargeCountVisitor& visit) {
  return state_->count_neighbors(options, visit);
}

Status OutOfCore::find_k_nearest(std::size_t k, const LargeNearestVisitor& visit) {
  return state_->find_k_nearest(k, visit);
}

Result<std::optional<LargeClosestPair>> OutOfCore::find_closest_pair() {
  return state_->find_closest_pair();
}

OutOfCoreFacts OutOfCore::facts() const {
  return state_->facts();
}

}  // namespace beespace
