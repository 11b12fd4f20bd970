// Decides what libFuzzer learns of the code that a case has reached.
#pragma once

namespace delabole::fuzzing {

// Hides what the present case has reached. libFuzzer makes further changes on cases that reached new code; on one that
// the reader refuses they would hardly ever reach the model: nine of ten cases were refused, most for the mistake of an
// earlier one.
void forget_what_was_reached();

}  // namespace delabole::fuzzing
