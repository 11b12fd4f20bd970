#include "cases/program/terminal/plain_output.hpp"

#include <array>
#include <cstdint>

namespace delabole {

namespace {

struct Letter {
    std::size_t bytes = 1;
    std::uint32_t code = 0xFFFD;
    bool whole = true;  // false: the text ends within the letter
};

constexpr bool continues(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

// The first letter of a text that is not empty; a single byte if the text is not UTF-8 there.
Letter first_letter(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text.front());
    if (lead < 0x80U) {
        return {.code = lead};
    }
    const std::size_t bytes = lead >= 0xF0U && lead < 0xF5U ? 4 : lead >= 0xE0U ? 3 : lead >= 0xC2U ? 2 : 1;
    if (bytes == 1 || lead >= 0xF5U) {
        return {};
    }
    std::uint32_t code = lead & (0xFFU >> (bytes + 1));
    for (std::size_t index = 1; index < bytes; ++index) {
        if (index == text.size()) {
            return {.whole = false};
        }
        if (!continues(text[index])) {
            return {};
        }
        code = code << 6U | (static_cast<unsigned char>(text[index]) & 0x3FU);
    }
    constexpr std::array<std::uint32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800U && code < 0xE000U;
    return code < least.at(bytes) || surrogate || code > 0x10FFFFU ? Letter{} : Letter{.bytes = bytes, .code = code};
}

bool is_control(std::uint32_t code) {
    const bool moves = (code < 0x20U && code != '\n' && code != '\t') || (code >= 0x7FU && code < 0xA0U);
    const bool turns = code == 0x061CU || code == 0x200EU || code == 0x200FU || (code >= 0x202AU && code <= 0x202EU) ||
                       (code >= 0x2066U && code <= 0x2069U);
    return moves || turns;
}

// Moves letters from the text to the result; an incomplete letter at the end stays in the text.
std::string take_plain(std::string_view& text) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const Letter letter = first_letter(text);
        if (!letter.whole) {
            break;
        }
        if (is_control(letter.code)) {
            result += "\\u";
            for (const unsigned shift : {12U, 8U, 4U, 0U}) {
                result += "0123456789abcdef"[letter.code >> shift & 0xFU];
            }
        } else if (letter.bytes == 1 && letter.code == 0xFFFDU) {
            result += "\uFFFD";
        } else {
            result += text.substr(0, letter.bytes);
        }
        text.remove_prefix(letter.bytes);
    }
    return result;
}

}  // namespace

std::string plain_text(std::string_view text) {
    std::string result = take_plain(text);
    return text.empty() ? result : result + "\uFFFD";
}

PlainOutput::PlainOutput(std::ostream& stream) : stream_(stream), target_(stream.rdbuf(this)) {}

PlainOutput::~PlainOutput() {
    stream_.rdbuf(target_);
    if (!unfinished_.empty()) {
        stream_ << plain_text(unfinished_);
    }
}

std::streamsize PlainOutput::xsputn(const char* text, std::streamsize size) {
    const std::string all = unfinished_ + std::string(text, static_cast<std::size_t>(size));
    std::string_view rest = all;
    const std::string plain = take_plain(rest);
    unfinished_ = rest;
    const auto length = static_cast<std::streamsize>(plain.size());
    return target_->sputn(plain.data(), length) == length ? size : 0;
}

PlainOutput::int_type PlainOutput::overflow(int_type letter) {
    if (traits_type::eq_int_type(letter, traits_type::eof())) {
        return traits_type::not_eof(letter);
    }
    const char byte = traits_type::to_char_type(letter);
    return xsputn(&byte, 1) == 1 ? letter : traits_type::eof();
}

int PlainOutput::sync() {
    return target_->pubsync();
}

}  // namespace delabole
