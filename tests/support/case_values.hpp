// Finds the values of a case in its text, so that each can be made wrong without another parser of TOML.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace delabole::testing {

struct CaseValue {
    std::string path;       // without the indices of list elements: "scene.block.width", "fit.parameter.lower"
    std::size_t key_begin;  // of `key = value` in the text; equal to begin if a list holds the value
    std::size_t begin;
    std::size_t end;
    bool is_list = false;
    bool has_line = false;  // its key is at the beginning of a line
};

// The values in the order of the text, up to a point where it cannot be parsed.
class CaseValues {
  public:
    explicit CaseValues(std::string_view text) : text_(text) { read(); }

    const std::vector<CaseValue>& found() const { return found_; }

  private:
    void read() {
        std::string header;
        while (skip_blank(true)) {
            if (text_[at_] == '[') {
                const std::size_t end = line_end();
                header = text_.substr(at_, end - at_);
                header = header.substr(0, header.find('#'));
                std::erase_if(header, [](char letter) { return letter == '[' || letter == ']' || letter == ' '; });
                at_ = end;
            } else if (!read_entry(header, true)) {
                return;
            }
        }
    }

    std::size_t line_end() const {
        const std::size_t end = text_.find('\n', at_);
        return end == std::string_view::npos ? text_.size() : end;
    }

    // False at the end of the text.
    bool skip_blank(bool lines) {
        while (at_ < text_.size()) {
            const char letter = text_[at_];
            if (lines && letter == '#') {
                at_ = line_end();
            } else if (letter == ' ' || letter == '\t' || (lines && (letter == '\n' || letter == '\r'))) {
                ++at_;
            } else {
                return true;
            }
        }
        return false;
    }

    bool read_entry(const std::string& table, bool begins_line) {
        const std::size_t key_begin = at_;
        while (at_ < text_.size() && text_[at_] != '=' && text_[at_] != '\n') {
            if (text_[at_] == '"') {
                at_ = std::min(text_.find('"', at_ + 1), text_.size() - 1);
            }
            ++at_;
        }
        if (at_ >= text_.size() || text_[at_] != '=') {
            return false;
        }
        std::string key(text_.substr(key_begin, at_ - key_begin));
        key.erase(key.find_last_not_of(" \t") + 1);
        ++at_;
        return read_value(table.empty() ? key : table + '.' + key, key_begin, begins_line);
    }

    bool read_value(const std::string& path, std::size_t key_begin, bool has_line) {
        constexpr int deepest = 100;  // of the recursion, so that it ends
        if (!skip_blank(true) || depth_ == deepest) {
            return false;
        }
        ++depth_;
        const std::size_t index = found_.size();
        found_.push_back({path, key_begin, at_, at_, text_[at_] == '[', has_line});
        bool whole = true;
        if (text_[at_] == '"' || text_[at_] == '\'') {
            whole = read_string();
        } else if (text_[at_] == '[') {
            whole = read_members(']', [&] { return read_value(path, at_, false); });
        } else if (text_[at_] == '{') {
            whole = read_members('}', [&] { return read_entry(path, false); });
        } else {
            const std::size_t end = std::min(text_.find_first_of(",]}# \t\r\n", at_), text_.size());
            whole = end > at_;  // otherwise a list would be read without end
            at_ = end;
        }
        found_[index].end = at_;
        --depth_;
        return whole;
    }

    template <class Read>
    bool read_members(char last, Read&& read) {
        ++at_;
        while (skip_blank(true)) {
            if (text_[at_] == last) {
                ++at_;
                return true;
            }
            if (text_[at_] == ',') {
                ++at_;
            } else if (!read()) {
                return false;
            }
        }
        return false;
    }

    bool read_string() {
        const std::string_view mark = text_.substr(at_, 1);
        const std::string_view three = text_.substr(at_, 3);
        const bool of_lines = three == R"(""")" || three == "'''";
        const std::string_view quotes = of_lines ? three : mark;
        at_ += quotes.size();
        while (at_ < text_.size() && text_.substr(at_, quotes.size()) != quotes) {
            at_ += text_[at_] == '\\' && mark == "\"" ? 2 : 1;
        }
        at_ = std::min(at_ + quotes.size(), text_.size());
        return at_ < text_.size();
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int depth_ = 0;
    std::vector<CaseValue> found_ = {};
};

}  // namespace delabole::testing
