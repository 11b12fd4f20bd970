// The output of the program holds titles, names and file names that somebody else may have written. A terminal would
// obey control characters in them: they can move its cursor, change its title, and hide or repeat what was typed.
#pragma once

#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>

namespace delabole {

// UTF-8 in which every control character except line end and tab, and every character that changes the direction of
// writing, is replaced by its number, such as "\u001b", which JSON and TOML read as the same character. Bytes that are
// not UTF-8 become U+FFFD.
std::string plain_text(std::string_view text);

// Changes everything printed to a stream to plain_text while this object exists.
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
    std::string unfinished_ = {};  // the beginning of a character whose other bytes have not yet arrived
};

}  // namespace delabole
