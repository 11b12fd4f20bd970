// Ctrl-C sets a flag that long work checks, so that the work can end with what it has finished.
#pragma once

#include <atomic>
#include <exception>

namespace delabole {

// The first interrupt, request to terminate or loss of the terminal (SIGHUP) sets the flag; a second one, unless it
// comes with the first, ends the program at once. If nobody has answered the first within another 1.8 s of processor
// time, all threads together, or while the process waited for 1.8 s, the program ends with a message and exit code 4,
// so that work with nothing to finish need not check the flag.
void catch_interrupts();

// Asking for the flag after it was set answers the interrupt: the program then ends in order, however long that takes.
// If work was given the reference earlier, its caller answers once the work has returned.
const std::atomic<bool>& interrupt_flag();
void answer_interrupt();

// Ends the program as an unanswered interrupt does.
[[noreturn]] void end_work();

// Seconds of real time since the first interrupt; 0 before it.
double seconds_since_interrupt();

// Ends work whose unfinished results are of no use.
class Interrupted : public std::exception {
  public:
    const char* what() const noexcept override { return "interrupted"; }
};

// Throws Interrupted once the flag is set.
void stop_if_interrupted();

}  // namespace delabole
