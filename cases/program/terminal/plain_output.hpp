// What the program prints holds titles, names and file names that somebody else may have written. A terminal obeys
// control characters in them: it moves its cursor, changes its title, hides or repeats what was typed.
#pragma once

#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>

namespace delabole {

// UTF-8 in which every control character but the line end and the tab stands as its number, "\u001b", and so do those
// that turn the direction of writing. JSON and TOML read that as the same character. Bytes that are no UTF-8 become
// U+FFFD.
std::string plain_text(std::string_view text);

// Makes all that a stream prints plain_text, as long as it lives.
class PlainOutput : private std::streambuf {
  public:
    explicit PlainOutput(std::ostream& stream);
    ~PlainOutput() override;
    PlainOutput(const PlainOutput&) = delete;
    PlainOutput& operator=(const PlainOutput&) = delete;

  private:
    std::streamsize xsputn(const char* text, std::streamsize size) override;
    int_type overflow(int_type letter) override;
    int sync() override;

    std::ostream& stream_;
    std::streambuf* target_;
    std::string unfinished_ = {};  // the beginning of a character whose other bytes have not come yet
};

}  // namespace delabole
