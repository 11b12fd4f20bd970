// Numbers and texts as bytes that give the same bits again, on any machine: little-endian, texts after their length.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace delabole {

class ByteWriter {
  public:
    void number(std::uint64_t value) {
        for (unsigned shift = 0; shift < 64; shift += 8) {
            bytes_ += static_cast<char>(static_cast<unsigned char>(value >> shift));
        }
    }
    void real(double value) { number(std::bit_cast<std::uint64_t>(value)); }
    void reals(std::span<const double> values) {
        number(values.size());
        for (const double value : values) {
            real(value);
        }
    }
    void text(std::string_view value) {
        number(value.size());
        bytes_ += value;
    }

    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

// What is asked for beyond the end of the bytes is zero or empty, and whole() says so.
class ByteReader {
  public:
    explicit ByteReader(std::string_view bytes) : left_(bytes) {}

    std::uint64_t number() {
        constexpr std::size_t size = 8;
        if (!has(size)) {
            return 0;
        }
        std::uint64_t value = 0;
        for (std::size_t index = size; index-- > 0;) {
            value = value << 8U | static_cast<unsigned char>(left_[index]);
        }
        left_.remove_prefix(size);
        return value;
    }
    double real() { return std::bit_cast<double>(number()); }
    std::vector<double> reals() {
        const std::uint64_t count = number();
        std::vector<double> values;
        for (std::uint64_t index = 0; index < count && !overrun_; ++index) {
            values.push_back(real());
        }
        return values;
    }
    std::string text() {
        const std::uint64_t size = number();
        if (!has(size)) {
            return {};
        }
        std::string value(left_.substr(0, size));
        left_.remove_prefix(size);
        return value;
    }

    // Everything was there, and nothing is left.
    bool whole() const { return !overrun_ && left_.empty(); }

  private:
    bool has(std::uint64_t size) {
        overrun_ = overrun_ || size > left_.size();
        return !overrun_;
    }

    std::string_view left_;
    bool overrun_ = false;
};

}  // namespace delabole
