// Independent tasks on a given number of threads.
#pragma once

#include <cstddef>
#include <functional>

namespace delabole {

// Calls task(0) ... task(count - 1), each once, on `threads` threads (on the caller's thread if 1). Results do not
// depend on the number of threads if each task writes only to its own data. If tasks throw, the others still run and
// the exception of the lowest number is rethrown.
void run_tasks(std::size_t count, int threads, const std::function<void(std::size_t)>& task);

}  // namespace delabole
