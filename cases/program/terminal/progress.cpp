#include "cases/program/terminal/progress.hpp"

#include "cases/program/terminal/plain_output.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace delabole {

namespace {

using namespace std::chrono_literals;

constexpr auto terminal_interval = 100ms;
constexpr auto line_interval = 5s;
constexpr int bar_width = 30;

// "12 s", "3 min", "5 h": an estimate is not more accurate than that.
std::string duration_in_words(double seconds) {
    constexpr double minute = 60;
    constexpr double hour = 3600;
    const double unit = seconds < 2 * minute ? 1 : seconds < 2 * hour ? minute : hour;
    std::string text = std::to_string(std::lround(std::ceil(seconds / unit)));
    return text += unit == 1 ? " s" : unit == minute ? " min" : " h";
}

}  // namespace

Progress::Progress(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (drawn_ && terminal_) {
        std::fputs("\r\033[K", stderr);
    }
}

std::string TimeLeft::in_words(double elapsed, double share) {
    if (elapsed >= 2 * newer_.elapsed) {
        older_ = newer_;
        newer_ = {elapsed, share};
    }
    double least = std::numeric_limits<double>::infinity();
    double greatest = 0;
    for (const Mark& mark : {Mark{}, older_, newer_}) {
        constexpr double enough = 1.1;  // of the time at the mark, to measure a pace since then
        if (elapsed > enough * mark.elapsed) {
            const double left = (elapsed - mark.elapsed) * (1 - share) / std::max(share - mark.share, 0.0);
            least = std::min(least, left);
            greatest = std::max(greatest, left);
        }
    }
    constexpr double agreement = 2;
    const bool one_pace = older_.elapsed == 0 && elapsed == newer_.elapsed;
    const bool known = !one_pace && std::isfinite(greatest) && greatest <= agreement * least;
    return known ? duration_in_words(std::sqrt(least * greatest)) + " left" : "time left not known";
}

void Progress::report(double share, const std::string& what, bool may_end_sooner) {
    const Clock::time_point now = Clock::now();
    const bool next_part = terminal_ && what != what_;  // shown at once: it may be long before it reports
    const Clock::duration interval = terminal_ ? Clock::duration(terminal_interval) : Clock::duration(line_interval);
    if (quiet_ || (now - last_ < interval && !next_part)) {
        return;
    }
    last_ = now;
    what_ = what;
    drawn_ = true;
    const double done = std::clamp(share, 0.0, 1.0);
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    std::string left = done > 1e-6 && elapsed > 1 ? time_left_.in_words(elapsed, done) : "";
    if (may_end_sooner && !left.empty()) {
        left = "time left not known: the run ends when the blocks stand or fail";
    }
    const std::string doing = plain_text(what);
    const int percent = static_cast<int>(std::lround(100 * done));
    if (terminal_) {
        const auto filled = static_cast<std::size_t>(std::lround(done * bar_width));
        std::fprintf(stderr, "\r\033[K[%s%s] %3d %%  %s  %s", std::string(filled, '#').c_str(),
                     std::string(bar_width - filled, ' ').c_str(), percent, left.c_str(), doing.c_str());
        std::fflush(stderr);
    } else {
        std::fprintf(stderr, "%d %%: %s%s%s\n", percent, doing.c_str(), left.empty() ? "" : ", ", left.c_str());
    }
}

}  // namespace delabole
