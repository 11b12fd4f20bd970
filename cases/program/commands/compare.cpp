// delabole compare
#include "cases/program/case/case_writer.hpp"
#include "cases/program/commands/commands.hpp"
#include "cases/program/reader/case_error.hpp"
#include "cases/program/reader/document.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/reader/section.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/model_reports.hpp"
#include "cases/program/results/problems_of_case.hpp"
#include "cases/program/results/result_folder.hpp"
#include "cases/program/sweeps/support_report.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "fitting/work/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
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

    // Nothing unless both are numbers.
    std::optional<double> change() const {
        const auto* before = first ? std::get_if<double>(&*first) : nullptr;
        const auto* after = second ? std::get_if<double>(&*second) : nullptr;
        return before == nullptr || after == nullptr ? std::nullopt : std::optional(*after - *before);
    }
    // Numbers that differ by rounding alone, by a billionth, are the same.
    bool differs() const {
        const std::optional<double> by = change();
        const auto size = [](const std::optional<Cell>& number) { return std::abs(std::get<double>(*number)); };
        return first != second && (!by || (in_display_unit(*by, dimension) != 0 &&
                                           !(std::abs(*by) <= 1e-9 * std::max(size(first), size(second)))));
    }
};

// CSV and JSON hold a number in its display unit, or a word.
Cell in_file(const std::optional<Cell>& value, Dimension dimension) {
    const auto* number = value ? std::get_if<double>(&*value) : nullptr;
    return number != nullptr ? in_display_unit(*number, dimension) : value.value_or("absent");
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

// A case with its answer and its analysis.
struct Analysed {
    CaseFile file;
    CaseAnswer answer;
    Analysis analysis;
};

Analysed analysed(CaseFile file, const Options& options) {
    AnalysisWork work;
    work.watch = [](double, const std::string&, bool) { return !interrupt_flag(); };
    work.threads = static_cast<unsigned>(options.threads);
    CaseAnswer answer = analyse_case(file.model, work);
    stop_if_interrupted();
    Analysis analysis = named_outputs(file.model, answer);
    if (!analysis.failure.empty()) {
        throw CaseError({impossible(file, analysis.failure)});
    }
    return {std::move(file), std::move(answer), std::move(analysis)};
}

// The first figure of what `run` would report.
void draw_picture(const Analysed& one, const std::string& name, const ResultFolder& folder, FigureRow& row) {
    if (const auto picture = first_case_figure(one.file.model, one.answer)) {
        row.figures.push_back(folder.draw(picture->figure, name, stem_of(one.file) + "."));
    }
}

// Adds rows for the pairs that differ, and how many are the same; the pairs that differ also to CSV and JSON.
void add(const std::string& word, const std::vector<Compared>& pairs, std::vector<std::vector<std::string>>& rows,
         CsvTable& csv, Json& json) {
    std::size_t same = 0;
    json[word] = Json::array();
    for (const Compared& one : pairs) {
        if (!one.differs()) {
            ++same;
            continue;
        }
        const std::optional<double> by = one.change();
        const auto shown = [&](const auto& value) { return value ? in_table_digits(*value, one.dimension) : "-"; };
        rows.push_back({one.name, shown(one.first), shown(one.second), by ? value_in_words(*by, one.dimension) : ""});
        const std::vector<Cell> row = {one.name, in_file(one.first, one.dimension), in_file(one.second, one.dimension),
                                       in_file(by ? Cell(*by) : Cell(""), one.dimension),
                                       std::string(display_unit(one.dimension).symbol)};
        csv.add_row(row);
        Json& entry = json[word].emplace_back();
        for (std::size_t index = 0; index < row.size(); ++index) {
            const auto* number = std::get_if<double>(&row[index]);
            constexpr std::array names = {"name", "first", "second", "difference", "unit"};
            entry[names[index]] = number != nullptr ? json_number(*number) : Json(std::get<std::string>(row[index]));
        }
    }
    rows.push_back({std::to_string(same) + " " + word + " are the same"});
}

// Shows both answers, what differs between the cases, their first figures side by side and the table of differences.
void write_comparison(const std::vector<Analysed>& both, const std::vector<std::vector<std::string>>& rows,
                      const CsvTable& csv, Json json, const Options& options, double seconds) {
    const ResultFolder folder(options, "compare", OnInterrupt::stop);
    HeadCard head;
    for (const Analysed& one : both) {
        head.sentences.push_back(stem_of(one.file) + ": " + head_card(one.file.model, one.answer).sentences.front());
    }
    constexpr std::size_t most_named = 3;
    const std::size_t inputs = json["inputs"].size();
    std::string differing =
        separated(std::span(rows).subspan(1, std::min(inputs, most_named)), "; ",
                  [](const std::vector<std::string>& row) { return row[0] + " " + row[1] + " against " + row[2]; });
    if (inputs > most_named) {
        differing += "; and " + std::to_string(inputs - most_named) + " other inputs";
    }
    head.sentences.push_back(inputs == 0 ? "Their inputs are the same." : "They differ in " + differing + ".");
    FigureRow pictures;
    draw_picture(both.front(), "first", folder, pictures);
    draw_picture(both.back(), "second", folder, pictures);
    Table table{"", {}};
    for (const std::string& title : rows.front()) {
        table.columns.emplace_back(title, &title != &rows.front().front());
    }
    table.rows.assign(rows.begin() + 1, rows.end());
    Report report{stem_of(both.front().file) + " and " + stem_of(both.back().file), "", {}};
    report.blocks = {head, pictures, Heading{"What differs"}, table};
    json["provenance"] = provenance(both.front().file, "compare", options, seconds);
    folder.write("compare.csv", csv.text());
    folder.write_report(report);
    folder.write("result.json", json_text(json));
}

}  // namespace

ExitCode compare_command(const Paths& cases, const Options& options) {
    const Stopwatch watch;
    std::vector<CaseFile> files;
    for (const std::filesystem::path& path : cases) {
        files.push_back(read_case(path, settings_of(options)));
        design_support_of(files.back(), [](double) { return !interrupt_flag(); });
    }
    show_units_of(files.front());
    std::vector<Analysed> both;
    for (CaseFile& file : files) {
        both.push_back(analysed(std::move(file), options));
    }
    const Analysed& one = both.front();
    const Analysed& other = both.back();
    std::vector<std::vector<std::string>> rows = {
        {"what differs", stem_of(one.file), stem_of(other.file), "difference"}};
    CsvTable csv({"what differs", stem_of(one.file), stem_of(other.file), "difference", "unit"});
    Json json = {{"first", one.file.name}, {"second", other.file.name}};
    const auto value_of = [](const auto& one_of_them) { return one_of_them.value; };
    add("inputs", pair_up(inputs_of_case(one.file), inputs_of_case(other.file), value_of), rows, csv, json);
    add("outputs", pair_up(one.analysis.outputs, other.analysis.outputs, value_of), rows, csv, json);
    if (!options.out.empty()) {
        write_comparison(both, rows, csv, json, options, watch.seconds());
    }
    if (options.json) {
        std::cout << json_text(json);
    } else if (!options.quiet) {
        std::cout << text_table(rows);
    }
    return ExitCode::ok;
}

}  // namespace delabole
