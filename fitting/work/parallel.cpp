#include "fitting/work/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace delabole {

void run_tasks(std::size_t count, int threads, const std::function<void(std::size_t)>& task) {
    std::vector<std::exception_ptr> thrown(count);
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t number = next++; number < count; number = next++) {
            try {
                task(number);
            } catch (...) {
                thrown[number] = std::current_exception();
            }
        }
    };
    const std::size_t helpers =
        std::min(static_cast<std::size_t>(std::max(threads, 1)), std::max<std::size_t>(count, 1)) - 1;
    {
        std::vector<std::jthread> pool;
        for (std::size_t helper = 0; helper < helpers; ++helper) {
            pool.emplace_back(work);
        }
        work();
    }
    for (const std::exception_ptr& exception : thrown) {
        if (exception) {
            std::rethrow_exception(exception);
        }
    }
}

}  // namespace delabole
