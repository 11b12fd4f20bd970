// The progress of long work: a bar with the time left on a terminal, occasional lines elsewhere, nothing if quiet.
#pragma once

#include <chrono>
#include <string>

namespace delabole {

// Estimates the time left from the pace of the whole work and from those of its latest parts.
class TimeLeft {
  public:
    // "12 s left", given the share of the work done, more than 0, and the time it took; "time left not known" if
    // these paces differ by more than a factor of two, or if there is only one. To be called repeatedly during the
    // work.
    std::string in_words(double elapsed, double share);

  private:
    struct Mark {
        double elapsed = 0;
        double share = 0;
    };

    // The older mark is at a quarter to a half of the time elapsed, the newer one at half of it or later.
    Mark older_ = {};
    Mark newer_ = {};
};

class Progress {
  public:
    explicit Progress(bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // Reports the share of the work done, 0 to 1, and what is being done. It is cheap, since most calls print nothing.
    // If `may_end_sooner`, a verdict that cannot be foreseen may end the work, and no time left is given.
    void report(double share, const std::string& what, bool may_end_sooner = false);

  private:
    using Clock = std::chrono::steady_clock;

    bool quiet_;
    bool terminal_;
    bool drawn_ = false;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    std::string what_ = {};  // what was being done when the bar was last drawn
    TimeLeft time_left_ = {};
};

}  // namespace delabole
