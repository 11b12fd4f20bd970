// Ctrl-C as a flag that long work looks at, so that it can end with what it has.
#pragma once

#include <atomic>
#include <exception>

namespace delabole {

// The first interrupt, request to terminate or loss of the terminal (SIGHUP) sets the flag; a second one, if it does
// not come with the first, ends the program at once.
void catch_interrupts();

const std::atomic<bool>& interrupt_flag();

// Ends work that has no use for what it has so far.
class Interrupted : public std::exception {
  public:
    const char* what() const noexcept override { return "interrupted"; }
};

// Throws Interrupted once the flag is set.
void stop_if_interrupted();

}  // namespace delabole
