// The same work on several threads at once, the calling one included.
#pragma once

#include <functional>

namespace beespace::io {

// 0 becomes one per processor.
unsigned thread_count(unsigned asked);

// Calls work(0) ... work(threads - 1), at the same time, and returns when all have returned.
// Where the system refuses a thread, its share is done by the calling one afterwards: no share may
// wait for another. What `work` throws is thrown again here, once all have ended.
void run_on_threads(unsigned threads, const std::function<void(unsigned)>& work);

}  // namespace beespace::io
