#include "cases/python/background.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <thread>
#include <utility>

namespace delabole {

namespace py = pybind11;

void BackgroundWatch::tell(double share, std::string what) {
    const std::lock_guard lock(telling_);
    is_new_ = true;
    share_ = share;
    what_ = std::move(what);
}

void BackgroundWatch::pass_on(const py::object& progress) {
    std::unique_lock lock(telling_);
    if (!std::exchange(is_new_, false) || progress.is_none()) {
        return;
    }
    const double share = share_;
    const std::string what = what_;
    lock.unlock();
    progress(share, what);
}

void in_background(const py::object& progress, const std::function<void(BackgroundWatch&)>& work) {
    constexpr std::chrono::milliseconds between_looks(50);
    BackgroundWatch watch;
    std::exception_ptr thrown;
    std::exception_ptr raised;
    std::mutex ending;
    std::condition_variable ended;
    bool has_ended = false;
    std::thread thread([&] {
        try {
            work(watch);
        } catch (...) {
            thrown = std::current_exception();
        }
        const std::lock_guard lock(ending);
        has_ended = true;
        ended.notify_all();
    });
    const auto wait = [&] {
        const py::gil_scoped_release released;
        std::unique_lock lock(ending);
        return ended.wait_for(lock, between_looks, [&] { return has_ended; });
    };
    while (!wait()) {
        if (raised) {
            continue;
        }
        try {
            if (PyErr_CheckSignals() != 0) {
                throw py::error_already_set();
            }
            watch.pass_on(progress);
        } catch (...) {
            raised = std::current_exception();
            watch.stop();
        }
    }
    thread.join();
    if (raised) {
        std::rethrow_exception(raised);
    }
    if (thrown) {
        std::rethrow_exception(thrown);
    }
    watch.pass_on(progress);
}

}  // namespace delabole
