#include "tests/contract/variants.hpp"

#include "tests/contract/backward_crew.hpp"

#include <memory>
#include <utility>

namespace beespace::test {

namespace {

void append(std::vector<Variant>& all, std::vector<Variant> more) {
  for (Variant& variant : more) all.push_back(std::move(variant));
}

}  // namespace

std::vector<Variant> contract_variants() {
  std::vector<Variant> all = {
      public_functions(1),
      public_functions(8),
      public_functions_of_strided_points(),
      engine_with_threads(1),
      engine_with_threads(3),
      engine_with_crew("EngineWithBackwardCrew2", std::make_shared<BackwardCrew>(2)),
      engine_with_crew("EngineWithBackwardCrew5", std::make_shared<BackwardCrew>(5)),
  };
  append(all, forced_kernels());
  append(all, forced_crowds());
  append(all, forced_methods());
  append(all, forced_trees());
  return all;
}

std::vector<Variant> variants_with_threads() {
  std::vector<Variant> all;
  for (const unsigned threads : {2U, 3U, 5U, 8U}) all.push_back(public_functions(threads));
  all.push_back(engine_with_threads(5));
  all.push_back(engine_with_crew("EngineWithThreadCrew", std::make_shared<ThreadCrew>(3)));
  all.push_back(engine_with_crew("EngineWithBackwardCrew", std::make_shared<BackwardCrew>(4)));
  return all;
}

}  // namespace beespace::test
