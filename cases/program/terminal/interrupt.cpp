#include "cases/program/terminal/interrupt.hpp"

#include "cases/program/terminal/options.hpp"
#include "plots/drawing/process.hpp"

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

// An interrupt that nobody has answered is checked every tick.
constexpr std::int64_t tick = second / 10;
// This is processor time, not real time: on a busy machine work takes longer until it checks the flag.
constexpr std::int64_t patience = 18 * tick;
// After so many ticks with hardly any work the process waits for something that may never come: input, a reader of its
// output, a store that another process has locked.
constexpr int most_idle_ticks = 18;
constexpr std::int64_t hardly = tick / 10;
timer_t ticks;
std::atomic<bool> has_ticks{false};
std::atomic<bool> awaits_answer{false};
std::atomic<bool> on_terminal{false};
std::atomic<std::int64_t> processor_time_then{0};  // ns, at the interrupt
std::atomic<std::int64_t> processor_time_last{0};  // ns, at the last tick
std::atomic<int> idle_ticks{0};

std::int64_t time_of(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return std::int64_t{now.tv_sec} * second + now.tv_nsec;
}

void set_ticks(std::int64_t interval) {
    itimerspec when{};
    when.it_value.tv_nsec = when.it_interval.tv_nsec = interval;
    timer_settime(ticks, 0, &when, nullptr);
}

extern "C" void check_answer(int) {
    const std::int64_t used = time_of(CLOCK_PROCESS_CPUTIME_ID);
    const bool idle = used - processor_time_last.exchange(used) < hardly;
    idle_ticks = idle ? idle_ticks + 1 : 0;
    if (awaits_answer && (used - processor_time_then > patience || idle_ticks >= most_idle_ticks)) {
        end_work();
    }
}

extern "C" void note_interrupt(int signal) {
    // `timeout` sends a signal twice: to its child and to the process group of the child.
    constexpr std::int64_t together = 200'000'000;  // ns
    const std::int64_t time = time_of(CLOCK_MONOTONIC);
    std::int64_t first = 0;
    if (first_interrupt.compare_exchange_strong(first, time)) {
        if (has_ticks) {
            processor_time_then = time_of(CLOCK_PROCESS_CPUTIME_ID);
            processor_time_last.store(processor_time_then);
            awaits_answer.store(true);
            set_ticks(tick);
        }
        interrupted.store(true);
    } else if (time - first > together) {
        kill_running_program();
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

}  // namespace

void catch_interrupts() {
    sigevent event{};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGALRM;
    if (timer_create(CLOCK_MONOTONIC, &event, &ticks) == 0) {
        on_terminal = isatty(STDERR_FILENO) != 0;
        std::signal(SIGALRM, check_answer);
        has_ticks = true;
    }
    std::signal(SIGINT, note_interrupt);
    std::signal(SIGTERM, note_interrupt);
    // A terminal that closes ends the work like Ctrl-C, unless nohup asked for it to continue.
    if (std::signal(SIGHUP, note_interrupt) == SIG_IGN) {
        std::signal(SIGHUP, SIG_IGN);
    }
}

void end_work() {
    constexpr std::string_view message =
        "\ndelabole: interrupted: the work was ended where it was; evaluations and checkpoints that were written stay, "
        "and the same command goes on from them\n";
    const std::string_view text = message.substr(on_terminal ? 0 : 1);  // a terminal's line may hold a bar
    kill_running_program();
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
    _exit(static_cast<int>(ExitCode::not_converged));
}

const std::atomic<bool>& interrupt_flag() {
    answer_interrupt();
    return interrupted;
}

double seconds_since_interrupt() {
    return interrupted ? static_cast<double>(time_of(CLOCK_MONOTONIC) - first_interrupt) / static_cast<double>(second)
                       : 0;
}

void answer_interrupt() {
    if (interrupted && awaits_answer.exchange(false)) {
        set_ticks(0);
    }
}

void stop_if_interrupted() {
    if (interrupt_flag()) {
        throw Interrupted();
    }
}

}  // namespace delabole
