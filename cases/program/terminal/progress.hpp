// How far long work has come: a bar with the time left on a terminal, a line now and then elsewhere, nothing when
// quiet.
#pragma once

#include <chrono>
#include <string>

namespace delabole {

// Tells the time left from the pace of all the work and from that of late.
class TimeLeft {
  public:
    // "12 s left" of work of which a share, more than 0, is done after so many seconds, or, where the two paces differ
    // by more than a factor of two, "time left not known". To be called as the work goes on.
    std::string in_words(double elapsed, double share);

  private:
    struct Mark {
        double elapsed = 0;
        double share = 0;
    };

    // The one stands at a quarter to a half of the time elapsed, the other at half of it or more.
    Mark older_ = {};
    Mark newer_ = {};
};

class Progress {
  public:
    explicit Progress(bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // Share of the work done, 0 to 1, and what is being done. Cheap: most calls print nothing. `may_end_sooner`: at a
    // verdict that nobody can foresee; no time left is told then.
    void report(double share, const std::string& what, bool may_end_sooner = false);

  private:
    using Clock = std::chrono::steady_clock;

    bool quiet_;
    bool terminal_;
    bool drawn_ = false;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    std::string what_ = {};  // last drawn
    TimeLeft time_left_ = {};
};

}  // namespace delabole
