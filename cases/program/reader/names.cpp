#include "cases/program/reader/names.hpp"

#include <algorithm>
#include <iterator>
#include <unordered_set>

namespace delabole {

namespace {

constexpr std::size_t most_edits = 2;
constexpr std::size_t longest_word = 100;
constexpr std::size_t most_members = 12;  // of a list whose members are meant to be set one by one

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

namespace {

bool may_be(NameOf what, NameOf one) {
    return what == one || what == NameOf::measurable;
}

const Quantity* find_known(const KnownNames& names, NameOf what, const std::string& name) {
    for (const ModelNames& model : names.models) {
        const Quantity* output = may_be(what, NameOf::output) ? find_quantity(model.outputs, name) : nullptr;
        const Quantity* found =
            output == nullptr && may_be(what, NameOf::input) ? find_quantity(model.inputs, name) : output;
        if (found != nullptr) {
            return found;
        }
    }
    return nullptr;
}

// All names that would have been right, each once.
std::vector<std::string> right_names(const KnownNames& names, NameOf what) {
    std::vector<std::string> right;
    std::unordered_set<std::string> known;  // a section of many blocks has a million names
    const auto add = [&](const std::string& name) {
        if (known.insert(name).second) {
            right.push_back(name);
        }
    };
    for (const ModelNames& model : names.models) {
        if (what == NameOf::mechanism) {
            add(model.mechanism);
        }
        for (const auto& [one, quantities] :
             {std::pair{NameOf::output, &model.outputs}, std::pair{NameOf::input, &model.inputs}}) {
            if (may_be(what, one)) {
                std::ranges::for_each(*quantities, add, &Quantity::name);
            }
        }
    }
    return right;
}

bool can_judge(const KnownNames& names, NameOf what) {
    return !names.models.empty() && (what == NameOf::output || what == NameOf::mechanism ||
                                     std::ranges::all_of(names.models, &ModelNames::inputs_known));
}

// "is not an input of this case (did you mean ...?)"
std::string unknown_name(const Section& section, NameOf what, const std::string& name) {
    const std::string_view is_not = what == NameOf::mechanism    ? "is not a mechanism of this case"
                                    : what == NameOf::input      ? "is not an input of this case"
                                    : what == NameOf::measurable ? "is neither an output nor an input of any mechanism"
                                                                 : "is not ";
    const bool full = section.reading().full();  // then no correction is searched for
    const std::string meant = full ? std::string() : suggestion(name, right_names(section.names(), what));
    const std::string_view listed_by = what == NameOf::mechanism ? "" : what == NameOf::output ? "outputs" : "inputs";
    return std::string(is_not).append(what == NameOf::output ? section.names().output : "") +
           (meant.empty() && !listed_by.empty() ? " (`delabole " + std::string(listed_by) + "` lists them)" : meant);
}

const ModelNames* find_mechanism(const KnownNames& names, const std::string& name) {
    const auto found = std::ranges::find(names.models, name, &ModelNames::mechanism);
    return found == names.models.end() ? nullptr : &*found;
}

}  // namespace

std::string list_of(std::string_view name) {
    const std::size_t bracket = name.rfind('[');
    return std::string(bracket == std::string_view::npos ? std::string_view() : name.substr(0, bracket));
}

LongLists long_lists(const std::vector<Quantity>& quantities) {
    LongLists lists;
    std::string_view member;
    for (const Quantity& quantity : quantities) {  // quantities of one member follow each other
        const std::string_view name = quantity.name;
        const std::size_t end = name.rfind(']');
        if (end != std::string_view::npos && name.substr(0, end) != member) {
            member = name.substr(0, end);
            ++lists[list_of(name)];
        }
    }
    std::erase_if(lists, [](const auto& list) { return list.second <= most_members; });
    return lists;
}

std::vector<std::string> names_in(const std::vector<Quantity>& quantities) {
    std::vector<std::string> names;
    names.reserve(quantities.size());
    std::ranges::transform(quantities, std::back_inserter(names), &Quantity::name);
    return names;
}

void for_each_flat_entry(const Node& table, const std::function<void(const std::string&, const Node&)>& visit) {
    for (const auto& [key, node] : table.entries) {
        if (node.kind != Node::Kind::table) {
            visit(key, node);
            continue;
        }
        // In clang 14 a lambda cannot capture a structured binding directly.
        for_each_flat_entry(node, [&visit, prefix = key + "."](const std::string& inner, const Node& value) {
            visit(prefix + inner, value);
        });
    }
}

std::string read_name(Section& section, std::string_view key, NameOf what, std::string_view meaning) {
    std::string name = require_text(section, key, meaning);
    bool known = false;
    if (what == NameOf::mechanism) {
        const ModelNames* found = find_mechanism(section.names(), name);
        known = found != nullptr;
        if (!name.empty() && !known && can_judge(section.names(), what)) {
            section.complain(key, *section.peek(key), unknown_name(section, what, name));
        }
        section.refer_to({known ? std::span(found, 1) : std::span<const ModelNames>{}, "an output of the mechanism"});
        return name;
    }
    const Quantity* found = find_known(section.names(), what, name);
    if (!name.empty() && found == nullptr && can_judge(section.names(), what)) {
        section.complain(key, *section.peek(key), unknown_name(section, what, name));
    }
    section.name_quantity(found);
    return name;
}

void read_names(Section& section, std::string_view key, NameOf what, std::string_view meaning,
                std::vector<std::string>& names) {
    const Node* node = section.peek(key);
    if (what == NameOf::measurable && (node == nullptr || node->kind == Node::Kind::text)) {
        names = {read_name(section, key, what, meaning)};
        return;
    }
    read_words(section, key, names);
    if (what == NameOf::measurable && node->kind == Node::Kind::array && names.empty()) {
        section.complain(key, *node, "is empty");
    }
    const Quantity* first = what == NameOf::input ? section.named().value_or(nullptr) : nullptr;
    for (const std::string& name : names) {
        const bool is_mechanism = what == NameOf::mechanism;
        const Quantity* found = is_mechanism ? nullptr : find_known(section.names(), what, name);
        const bool known = is_mechanism ? find_mechanism(section.names(), name) != nullptr : found != nullptr;
        std::string complaint;
        if (!known && can_judge(section.names(), what)) {
            complaint = unknown_name(section, what, name);
        } else if (found != nullptr && first != nullptr && found->dimension != first->dimension) {
            complaint = "has another dimension than " + first->name;
        }
        if (!complaint.empty()) {
            section.complain(key, *section.peek(key), std::string(name).append(1, ' ').append(complaint));
        }
        first = first == nullptr ? found : first;
    }
    if (what == NameOf::measurable) {
        section.name_quantity(first);
    }
}

std::vector<Condition> read_conditions(Section& section, std::string_view key) {
    std::vector<Condition> conditions;
    const Node* table = take_table(section, key);
    if (table == nullptr) {
        return conditions;
    }
    for_each_flat_entry(*table, [&](const std::string& name, const Node& value) {
        const std::string path = section.path_of(key) + "." + name;
        const Quantity* input = find_known(section.names(), NameOf::input, name);
        if (input == nullptr) {
            if (can_judge(section.names(), NameOf::input)) {
                section.reading().complain(value.key_place, path, {}, unknown_name(section, NameOf::input, name));
            }
        } else if (std::ranges::find(conditions, name, &Condition::input) != conditions.end()) {
            section.reading().complain(value.key_place, path, {}, "is given twice");
        } else {
            const auto number = read_number(section.reading(), value, path, input->dimension, input->range);
            conditions.push_back({name, number.value_or(0), input->dimension});
        }
    });
    return conditions;
}

}  // namespace delabole
