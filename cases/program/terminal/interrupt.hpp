// Ctrl-C as a flag that long work looks at, so that it can end with what it has.
#pragma once

#include <atomic>
#include <exception>

namespace delabole {

// The first interrupt, request to terminate or loss of the terminal (SIGHUP) sets the flag; a second one, if it does
// not come with the first, ends the program at once. So does the first, with a message and exit code 4, where nobody
// has answered it after another 1.8 s of processor time, all threads together: work that has nothing to finish need not
// look at the flag.
void catch_interrupts();

// Who asks for the flag once it is set answers: what follows ends in order, however long that takes. Work that was
// handed the reference before has to return; its caller answers.
const std::atomic<bool>& interrupt_flag();
void answer_interrupt();

// Ends the program as that does.
[[noreturn]] void end_work();

// Seconds by the clock since the first interrupt; 0 before it.
double seconds_since_interrupt();

// Ends work that has no use for what it has so far.
class Interrupted : public std::exception {
  public:
    const char* what() const noexcept override { return "interrupted"; }
};

// Throws Interrupted once the flag is set.
void stop_if_interrupted();

}  // namespace delabole
