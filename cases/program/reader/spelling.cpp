#include "cases/program/reader/spelling.hpp"

#include <algorithm>

namespace delabole {
namespace {

constexpr std::size_t most_edits = 2;
constexpr std::size_t longest_word = 100;

}  // namespace

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blank);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::size_t edit_distance(std::string_view first, std::string_view second) {
    const std::size_t columns = second.size() + 1;
    std::vector<std::size_t> two_above(columns);
    std::vector<std::size_t> above(columns);
    std::vector<std::size_t> row(columns);
    for (std::size_t column = 0; column < columns; ++column) {
        row[column] = column;
    }
    for (std::size_t i = 1; i <= first.size(); ++i) {
        two_above.swap(above);
        above.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j < columns; ++j) {
            const std::size_t change = first[i - 1] == second[j - 1] ? 0 : 1;
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + change});
            if (i > 1 && j > 1 && first[i - 1] == second[j - 2] && first[i - 2] == second[j - 1]) {
                row[j] = std::min(row[j], two_above[j - 2] + 1);
            }
        }
    }
    return row.back();
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
    if (word.empty() || word.size() > longest_word) {
        return {};
    }
    constexpr std::size_t short_word = 3;
    std::size_t least = (word.size() <= short_word ? 1 : most_edits) + 1;
    std::string nearest;
    for (const std::string& candidate : candidates) {
        const std::size_t longer = std::max(candidate.size(), word.size());
        const std::size_t shorter = std::min(candidate.size(), word.size());
        if (longer - shorter > most_edits) {
            continue;
        }
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < least && distance < word.size()) {
            least = distance;
            nearest = candidate;
        }
    }
    if (nearest.empty()) {
        const auto ends_with_word = [&](const std::string& candidate) {
            return candidate.size() > word.size() && candidate.ends_with(word) &&
                   candidate[candidate.size() - word.size() - 1] == '.';
        };
        const auto found = std::ranges::find_if(candidates, ends_with_word);
        if (found != candidates.end()) {
            nearest = *found;
        }
    }
    return nearest;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates) {
    const std::string nearest = nearest_word(word, candidates);
    return nearest.empty() ? "" : " (did you mean " + nearest + "?)";
}

std::string choices(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t index = 0; index < words.size(); ++index) {
        if (index > 0) {
            text += index + 1 == words.size() ? " or " : ", ";
        }
        text += words[index];
    }
    return text;
}

}  // namespace delabole
