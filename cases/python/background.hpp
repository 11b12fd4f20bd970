// Work that takes a while: without Python's lock, with progress told to a callback, and ended by Ctrl-C as Python
// people expect.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <utility>

namespace delabole {

// Takes what the work tells from any thread, and stops it when asked to.
class BackgroundWatch {
  public:
    void tell(double share, std::string what);
    bool stopped() const { return stop_.load(); }
    const std::atomic<bool>* stop_flag() const { return &stop_; }

    void stop() { stop_ = true; }
    // Calls progress(share, what) if there is something new.
    void pass_on(const pybind11::object& progress);

  private:
    std::atomic<bool> stop_{false};
    std::mutex telling_;
    bool is_new_ = false;
    double share_ = 0;
    std::string what_;
};

// Tells the share done of `what`, for work that goes on while its watch says true.
inline std::function<bool(double)> telling(BackgroundWatch& watch, std::string what) {
    return [&watch, what = std::move(what)](double share) {
        watch.tell(share, what);
        return !watch.stopped();
    };
}

// Does the work in a thread of its own. `progress` (None: nobody asks) is called in the caller's thread, which looks
// for signals meanwhile. What either raises, KeyboardInterrupt among it, ends the work and is raised once it has ended;
// what the work throws is thrown.
void in_background(const pybind11::object& progress, const std::function<void(BackgroundWatch&)>& work);

}  // namespace delabole
