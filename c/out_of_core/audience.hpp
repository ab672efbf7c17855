// Who an answer out of core is shown to.
#pragma once

#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <stop_token>
#include <variant>

namespace beespace::c {

// What a visitor says, which may want no more; and the stop of the call.
class Audience {
 public:
  explicit Audience(const RunOptions& run)
      : threads_(run.threads), pass_on_(run.stop, End{&source_}) {}

  [[nodiscard]] RunOptions run() const { return {threads_, source_.get_token()}; }
  // Calls show(), which returns what the visitor says, unless it has gone.
  template <class Show>
  void tell(const Show& show) {
    if (gone_ || show() != 0) return;
    gone_ = true;
    source_.request_stop();
  }
  // A search that ended as the visitor wanted is none that failed.
  [[nodiscard]] Status status_of(Status status) const {
    if (gone_ && !status && status.error().code == ErrorCode::kStopped) return std::monostate{};
    return status;
  }

 private:
  struct End {
    std::stop_source* source;
    void operator()() const { source->request_stop(); }
  };

  unsigned threads_;
  std::stop_source source_;
  bool gone_ = false;
  std::stop_callback<End> pass_on_;  // last: it uses the source
};

}  // namespace beespace::c
