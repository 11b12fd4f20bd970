#include "cases/program/terminal/interrupt.hpp"

#include "cases/program/terminal/options.hpp"

#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <ctime>
#include <string_view>

namespace delabole {

namespace {

std::atomic<bool> interrupted{false};
std::atomic<std::int64_t> first_interrupt{0};  // ns; 0: no interrupt yet
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free,
              "a signal handler may only touch lock-free atomics");

constexpr std::int64_t second = 1'000'000'000;  // ns

// Processor time, because on a busy machine work checks the flag less often in real time, and while a picture is drawn
// or the disk is waited for there is nothing to be ended.
constexpr std::int64_t patience = 1'800'000'000;  // ns
timer_t deadline;
std::atomic<bool> has_deadline{false};
std::atomic<bool> awaits_answer{false};
std::atomic<bool> on_terminal{false};

void set_deadline(std::int64_t from_now) {
    itimerspec when{};
    when.it_value.tv_sec = from_now / second;
    when.it_value.tv_nsec = from_now % second;
    timer_settime(deadline, 0, &when, nullptr);
}

extern "C" void end_deaf_work(int) {
    end_work();
}

std::int64_t time_now() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{now.tv_sec} * second + now.tv_nsec;
}

extern "C" void note_interrupt(int signal) {
    // `timeout` sends a signal twice: to its child and to the process group of the child.
    constexpr std::int64_t together = 200'000'000;  // ns
    const std::int64_t time = time_now();
    std::int64_t first = 0;
    if (first_interrupt.compare_exchange_strong(first, time)) {
        if (has_deadline) {
            awaits_answer.store(true);
            set_deadline(patience);
        }
        interrupted.store(true);
    } else if (time - first > together) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

}  // namespace

void catch_interrupts() {
    sigevent event{};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGALRM;
    if (timer_create(CLOCK_PROCESS_CPUTIME_ID, &event, &deadline) == 0) {
        on_terminal = isatty(STDERR_FILENO) != 0;
        std::signal(SIGALRM, end_deaf_work);
        has_deadline = true;
    }
    std::signal(SIGINT, note_interrupt);
    std::signal(SIGTERM, note_interrupt);
    // A terminal that closes ends the work like Ctrl-C, unless nohup asked for it to continue.
    if (std::signal(SIGHUP, note_interrupt) == SIG_IGN) {
        std::signal(SIGHUP, SIG_IGN);
    }
}

void end_work() {
    constexpr std::string_view message = "\ndelabole: interrupted: the work was ended where it was\n";
    const std::string_view text = message.substr(on_terminal ? 0 : 1);  // a terminal's line may hold a bar
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
    _exit(static_cast<int>(ExitCode::not_converged));
}

const std::atomic<bool>& interrupt_flag() {
    answer_interrupt();
    return interrupted;
}

double seconds_since_interrupt() {
    return interrupted ? static_cast<double>(time_now() - first_interrupt) / static_cast<double>(second) : 0;
}

void answer_interrupt() {
    if (interrupted && awaits_answer.exchange(false)) {
        set_deadline(0);
    }
}

void stop_if_interrupted() {
    if (interrupt_flag()) {
        throw Interrupted();
    }
}

}  // namespace delabole
