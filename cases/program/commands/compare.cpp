// delabole compare
#include "cases/program/case/case_writer.hpp"
#include "cases/program/commands/commands.hpp"
#include "cases/program/reader/case_error.hpp"
#include "cases/program/reader/document.hpp"
#include "cases/program/reader/section.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/impossible_case.hpp"
#include "cases/program/results/result_folder.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "fitting/work/words.hpp"

#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <variant>
#include <vector>

namespace delabole {

namespace {

// An input or output that either case has.
struct Compared {
    std::string name;
    Dimension dimension = Dimension::ratio;
    std::optional<Cell> first = {};
    std::optional<Cell> second = {};

    bool differs() const { return first != second; }
};

std::string shown(const std::optional<Cell>& value, Dimension dimension) {
    if (!value) {
        return "-";
    }
    const auto* number = std::get_if<double>(&*value);
    return number == nullptr ? std::get<std::string>(*value) : in_six_digits(*number, dimension);
}

std::string change_of(const Compared& one) {
    const auto* before = one.first ? std::get_if<double>(&*one.first) : nullptr;
    const auto* after = one.second ? std::get_if<double>(&*one.second) : nullptr;
    return before == nullptr || after == nullptr ? "" : value_in_words(*after - *before, one.dimension);
}

// Pairs in the order of the first list, followed by those that only the second has.
template <class List, class ValueOf>
std::vector<Compared> pair_up(const List& first, const List& second, const ValueOf& value_of) {
    std::vector<Compared> pairs;
    std::map<std::string, std::size_t> places;
    for (const auto& one : first) {
        places.emplace(one.name, pairs.size());
        pairs.push_back({one.name, one.dimension, value_of(one)});
    }
    for (const auto& one : second) {
        const auto [place, is_new] = places.emplace(one.name, pairs.size());
        if (is_new) {
            pairs.push_back({one.name, one.dimension});
        }
        pairs[place->second].second = value_of(one);
    }
    return pairs;
}

struct CaseInput {
    std::string name;
    Dimension dimension;
    Cell value;
};

// Adds the texts and switches of a tree, but no numbers with a unit.
void add_words(const Node& node, const std::string& name, const std::set<std::string>& numbers,
               std::vector<CaseInput>& inputs) {
    for (const auto& [key, value] : node.entries) {
        add_words(value, name.empty() ? key : name + "." + key, numbers, inputs);
    }
    for (std::size_t index = 0; index < node.elements.size(); ++index) {
        add_words(node.elements[index], indexed(name, index), numbers, inputs);
    }
    if (numbers.count(name) == 0) {
        if (node.kind == Node::Kind::text) {
            inputs.push_back({name, Dimension::ratio, node.text});
        } else if (node.kind == Node::Kind::boolean) {
            inputs.push_back({name, Dimension::ratio, node.boolean ? "true" : "false"});
        }
    }
}

// Words come before numbers, because the kind of a part determines the meaning of its numbers.
std::vector<CaseInput> inputs_of_case(const CaseFile& file) {
    std::vector<CaseInput> inputs;
    std::set<std::string> numbers;
    for (const Quantity& number : named_inputs(file.model)) {
        numbers.insert(number.name);
    }
    add_words(parse_document(resolved_model(file.model), file.name), {}, numbers, inputs);
    for (const Quantity& number : named_inputs(file.model)) {
        inputs.push_back({number.name, number.dimension, number.value});
    }
    return inputs;
}

Analysis analysis_of_case(const CaseFile& file, const Options& options) {
    AnalysisWork work;
    work.watch = [](double, const std::string&, bool) { return !interrupt_flag(); };
    work.threads = static_cast<unsigned>(options.threads);
    Analysis analysis = analyse_model(file.model, work);
    stop_if_interrupted();
    if (!analysis.failure.empty()) {
        throw CaseError({impossible(file, analysis.failure)});
    }
    return analysis;
}

// Adds rows for the pairs that differ, below a heading, and the same to the JSON.
void add(const std::string& word, const std::vector<Compared>& pairs, std::vector<std::vector<std::string>>& rows,
         Json& json) {
    std::size_t same = 0;
    json[word] = Json::array();
    for (const Compared& one : pairs) {
        if (!one.differs()) {
            ++same;
            continue;
        }
        rows.push_back({one.name, shown(one.first, one.dimension), shown(one.second, one.dimension), change_of(one)});
        json[word].push_back({{"name", one.name},
                              {"first", shown(one.first, one.dimension)},
                              {"second", shown(one.second, one.dimension)},
                              {"difference", change_of(one)}});
    }
    rows.push_back({std::to_string(same) + " " + word + " are the same"});
}

}  // namespace

ExitCode compare_command(const Paths& cases, const Options& options) {
    const CaseFile first = read_case(cases.front(), settings_of(options));
    const CaseFile second = read_case(cases.back(), settings_of(options));
    show_units_of(first);
    const Analysis one = analysis_of_case(first, options);
    const Analysis other = analysis_of_case(second, options);
    std::vector<std::vector<std::string>> rows = {{"what differs", stem_of(first), stem_of(second), "difference"}};
    Json json = {{"first", first.name}, {"second", second.name}};
    const auto value_of = [](const auto& one_of_them) { return one_of_them.value; };
    add("inputs", pair_up(inputs_of_case(first), inputs_of_case(second), value_of), rows, json);
    add("outputs", pair_up(one.outputs, other.outputs, value_of), rows, json);
    if (options.json) {
        std::cout << json_text(json);
    } else if (!options.quiet) {
        std::cout << text_table(rows);
    }
    return ExitCode::ok;
}

}  // namespace delabole
