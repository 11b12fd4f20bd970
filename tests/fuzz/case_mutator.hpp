// Changes of a case that keep most of it readable: bytes changed at random seldom leave TOML.
#pragma once

#include "tests/support/case_values.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <string_view>
#include <vector>

// This is libFuzzer's own mutator, which changes bytes.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace delabole::fuzzing {

class CaseMutator {
  public:
    CaseMutator(std::string text, unsigned seed) : text_(std::move(text)), random_(seed) {}

    std::string take() && { return std::move(text_); }

    void change() {
        const testing::CaseValues values(text_);
        if (values.found().empty()) {
            return;
        }
        const testing::CaseValue value = values.found()[below(values.found().size())];
        switch (below(8)) {
        case 0:
            replace(value, std::string(wrong_values[below(wrong_values.size())]));
            break;
        case 1:
        case 2:
        case 3:
            change_number(value);
            break;
        case 4: {
            const testing::CaseValue& other = values.found()[below(values.found().size())];
            replace(value, text_.substr(other.begin, other.end - other.begin));
            break;
        }
        case 5:
            text_.insert(value.key_begin, value.has_line ? "#" : "wrong_");
            break;
        case 6:
            repeat_lines();
            break;
        default:
            drop_lines();
            break;
        }
    }

  private:
    static constexpr std::array<std::string_view, 18> wrong_values{
        "nan",  "inf",  "-inf",    "0",       "-1",      "1e308",   "1e-308",    "[]",        "{}",
        "true", "\"\"", "\"0 m\"", "\"7 V\"", "\"1 m\"", "\"1 s\"", "\"1 kPa\"", "\"1 deg\"", "\"nan m\""};

    std::size_t below(std::size_t count) { return count == 0 ? 0 : random_() % count; }

    void replace(const testing::CaseValue& value, const std::string& by) {
        text_.replace(value.begin, value.end - value.begin, by);
    }

    // Changes the number and keeps its unit.
    void change_number(const testing::CaseValue& value) {
        constexpr std::array<double, 12> factors{-1, 0, 0.5, 0.9, 1.1, 2, 10, 1e3, 1e6, 0.1, 1e-3, 1e-6};
        const std::size_t first = text_.find_first_of("0123456789", value.begin);
        if (first == std::string::npos || first >= value.end) {
            return;
        }
        double number = 0;
        const char* const begin = text_.data() + first;
        const auto [end, error] = std::from_chars(begin, text_.data() + value.end, number);
        if (error != std::errc{}) {
            return;
        }
        number *= factors[below(factors.size())];
        std::array<char, 32> digits{};
        const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), number);
        text_.replace(first, static_cast<std::size_t>(end - begin), std::string(digits.data(), written.ptr));
    }

    // Returns the range of a section from its header on, or of some lines.
    std::pair<std::size_t, std::size_t> lines() {
        std::vector<std::size_t> begins{0};
        for (std::size_t at = text_.find("\n["); at != std::string::npos; at = text_.find("\n[", at + 1)) {
            begins.push_back(at + 1);
        }
        begins.push_back(text_.size());
        const std::size_t section = below(begins.size() - 1);
        return {begins[section], begins[section + 1] - begins[section]};
    }

    void repeat_lines() {
        const auto [begin, length] = lines();
        text_.insert(begin, text_.substr(begin, length));
    }

    void drop_lines() {
        const auto [begin, length] = lines();
        text_.erase(begin, length);
    }

    std::string text_;
    std::minstd_rand random_;
};

inline std::size_t mutate_case(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    constexpr unsigned one_in = 10;
    if (seed % one_in == 0) {
        return LLVMFuzzerMutate(data, size, most);
    }
    CaseMutator mutator(std::string(reinterpret_cast<const char*>(data), size), seed);
    for (unsigned changes = 1 + seed / one_in % 3; changes > 0; --changes) {
        mutator.change();
    }
    const std::string text = std::move(mutator).take();
    if (text.empty() || text.size() > most) {
        return LLVMFuzzerMutate(data, size, most);
    }
    std::memcpy(data, text.data(), text.size());
    return text.size();
}

}  // namespace delabole::fuzzing
