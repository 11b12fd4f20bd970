// How far long work has come: a bar with the time left on a terminal, a line now and then elsewhere, nothing when
// quiet.
#pragma once

#include <chrono>
#include <string>

namespace delabole {

class Progress {
  public:
    explicit Progress(bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // Share of the work done, 0 to 1, and what is being done. Cheap: most calls print nothing.
    void report(double share, const std::string& what);

  private:
    using Clock = std::chrono::steady_clock;

    bool quiet_;
    bool terminal_;
    bool drawn_ = false;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    std::string what_ = {};  // last drawn
};

}  // namespace delabole
