#include "cases/interrupt.hpp"

#include <csignal>

namespace delabole {

namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

extern "C" void note_interrupt(int /*signal*/) {
    interrupted.store(true);
    // Whichever comes next ends the program, be it Ctrl-C or a request to terminate.
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
    std::signal(SIGINT, note_interrupt);
    std::signal(SIGTERM, note_interrupt);
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
