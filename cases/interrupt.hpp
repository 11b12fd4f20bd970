// Ctrl-C as a flag that long work looks at, so that it can end with what it has.
#pragma once

#include <atomic>

namespace delabole {

// The first interrupt (or request to terminate) sets the flag; a second one ends the program at once.
void catch_interrupts();

const std::atomic<bool>& interrupt_flag();

}  // namespace delabole
