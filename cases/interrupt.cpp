#include "cases/interrupt.hpp"

#include <csignal>
#include <cstdint>
#include <ctime>

namespace delabole {

namespace {

std::atomic<bool> interrupted{false};
std::atomic<std::int64_t> first_interrupt{0};  // ns; 0: none yet
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free,
              "a signal handler may only touch lock-free atomics");

extern "C" void note_interrupt(int signal) {
    // What passes a signal on sends it twice, to its child and to the group that the child is in: `timeout` does.
    constexpr std::int64_t together = 200'000'000;  // ns
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    const std::int64_t time = std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
    std::int64_t first = 0;
    if (first_interrupt.compare_exchange_strong(first, time)) {
        interrupted.store(true);
    } else if (time - first > together) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

}  // namespace

void catch_interrupts() {
    std::signal(SIGINT, note_interrupt);
    std::signal(SIGTERM, note_interrupt);
    // A terminal that closes ends the work like Ctrl-C, unless nohup has asked to go on without it.
    if (std::signal(SIGHUP, note_interrupt) == SIG_IGN) {
        std::signal(SIGHUP, SIG_IGN);
    }
}

const std::atomic<bool>& interrupt_flag() {
    return interrupted;
}

void stop_if_interrupted() {
    if (interrupted) {
        throw Interrupted();
    }
}

}  // namespace delabole
