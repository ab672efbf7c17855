#include "io/bytes/worker_threads.hpp"

#include <algorithm>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

namespace beespace::io {

unsigned thread_count(unsigned asked) {
  return asked != 0 ? asked : std::max(1u, std::thread::hardware_concurrency());
}

void run_on_threads(unsigned threads, const std::function<void(unsigned)>& work) {
  std::vector<std::exception_ptr> thrown(threads);
  const auto guarded = [&work, &thrown](unsigned worker) {
    try {
      work(worker);
    } catch (...) {
      thrown[worker] = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  others.reserve(threads);
  unsigned started = 1;
  try {
    for (; started < threads; ++started) others.emplace_back(guarded, started);
  } catch (const std::system_error&) {
    // Too many threads for the system: the rest is done below.
  }
  guarded(0);
  for (unsigned worker = started; worker < threads; ++worker) guarded(worker);
  for (auto& thread : others) thread.join();
  for (const auto& exception : thrown) {
    if (exception) std::rethrow_exception(exception);
  }
}

}  // namespace beespace::io
