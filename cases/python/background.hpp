// Long work from Python: without Python's lock, with a callback for progress, and ended by Ctrl-C as usual in Python.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <utility>

namespace delabole {

// Receives the progress from any thread, and stops the work when asked to.
class BackgroundWatch {
  public:
    void tell(double share, std::string what);
    bool stopped() const { return stop_.load(); }
    const std::atomic<bool>* stop_flag() const { return &stop_; }

    void stop() { stop_ = true; }
    // Calls progress(share, what) if there is new progress.
    void pass_on(const pybind11::object& progress);

  private:
    std::atomic<bool> stop_{false};
    std::mutex telling_;
    bool is_new_ = false;
    double share_ = 0;
    std::string what_;
};

// A function that reports the share done of `what`; it returns whether the work is to continue.
inline std::function<bool(double)> telling(BackgroundWatch& watch, std::string what) {
    return [&watch, what = std::move(what)](double share) {
        watch.tell(share, what);
        return !watch.stopped();
    };
}

// Does the work in a thread of its own. `progress` (None if not wanted) is called in the caller's thread, which also
// checks for signals. An exception raised by either, such as KeyboardInterrupt, ends the work and is raised after that;
// an exception of the work is passed on.
void in_background(const pybind11::object& progress, const std::function<void(BackgroundWatch&)>& work);

}  // namespace delabole
