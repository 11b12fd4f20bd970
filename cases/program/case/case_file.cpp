#include "cases/program/case/case_file.hpp"

#include "cases/program/case/case_parts.hpp"
#include "cases/program/reader/described_reader.hpp"
#include "cases/program/reader/ordinary_file.hpp"
#include "fitting/work/words.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <iterator>
#include <utility>

namespace delabole {
namespace {

constexpr std::int64_t schema = 1;

[[noreturn]] void refuse(const std::string& file, std::string message) {
    throw CaseError({{file, 0, 0, {}, {}, std::move(message)}});
}

std::string read_text_file(const std::filesystem::path& path) {
    FileContent content = read_ordinary_file(path, "a case file", largest_case_bytes);
    if (!content.fault.empty()) {
        refuse(path.string(), std::move(content.fault));
    }
    return std::move(content.bytes);
}

std::string read_standard_input() {
    std::string text;
    std::array<char, 65536> part{};
    while (text.size() <= largest_case_bytes && std::cin.read(part.data(), part.size()).gcount() > 0) {
        text.append(part.data(), static_cast<std::size_t>(std::cin.gcount()));
    }
    return text;
}

void read_schema(Section& root) {
    const Node* node = root.require("schema", "the version of the case format, schema = 1");
    if (node != nullptr && (node->kind != Node::Kind::integer || node->integer != schema)) {
        root.complain("schema", *node, "must be 1, the only version of the case format");
    }
}

template <std::size_t... index>
std::optional<CaseModel> model_of_index(std::size_t wanted, std::index_sequence<index...>) {
    std::optional<CaseModel> model;
    ((wanted == index ? static_cast<void>(model.emplace(std::in_place_index<index>)) : void()), ...);
    return model;
}

template <std::size_t... index>
std::vector<CaseModel> one_of_each(std::index_sequence<index...>) {
    return {CaseModel(std::in_place_index<index>)...};
}

// "; it belongs to plane_failure and stepped_base" if other models have the key.
std::string models_that_have(const std::string& key) {
    std::vector<std::string> names;
    for (CaseModel& model : one_of_each(std::make_index_sequence<std::variant_size_v<Models>>{})) {
        Reading ignored{std::string()};
        const Node nothing;
        Section section(ignored, nothing, "");
        read_model(section, model);
        if (section.is_allowed(key)) {
            names.emplace_back(model_name(model));
        }
    }
    return names.empty() ? "" : "; it belongs to " + list_in_words(names);
}

// " (did you mean settings.watch?)" if another section of the model has a key of the unknown section.
std::string section_that_has_key_of(const Node& unknown, const Section& root, const CaseModel& model) {
    for (const std::string& name : root.allowed()) {
        Node tree;
        tree.entries.push_back({name, unknown});
        Reading ignored{std::string()};
        Section section(ignored, tree, "");
        CaseModel read = model;
        read_model(section, read);
        for (const auto& [key, value] : unknown.entries) {
            const std::string path = name + "." + key;
            if (ignored.knows(path)) {
                return " (did you mean " + path + "?)";
            }
        }
    }
    return "";
}

// The entries of a case that describe its model and how it is run, without studies and titles.
Node model_part(const Node& tree) {
    constexpr std::array others{"title", "description", "sources",     "expect",        "sweep",
                                "fit",   "report",      "sensitivity", "support_design"};
    Node part;
    part.place = tree.place;
    std::ranges::copy_if(tree.entries, std::back_inserter(part.entries),
                         [&](const Entry& entry) { return std::ranges::find(others, entry.key) == others.end(); });
    return part;
}

// Reads the number at a key that is known to the model, though not as an input; `value` is one that it may have.
std::optional<Quantity> number_at(const Node& tree, const std::string& key, const Node& value) {
    Node part = model_part(tree);
    std::vector<Problem> problems;
    apply_setting(part, {key, shown(value)}, problems);
    Reading reading{std::string()};
    reading.look_for(key);
    Section root(reading, part, "");
    if (std::optional<CaseModel> model = choose_model(root); model && problems.empty()) {
        read_model(root, *model);
    }
    return reading.found_number();
}

}  // namespace

CaseModel::CaseModel() = default;
CaseModel::CaseModel(const CaseModel&) = default;
CaseModel::CaseModel(CaseModel&&) noexcept = default;
CaseModel& CaseModel::operator=(const CaseModel&) = default;
CaseModel& CaseModel::operator=(CaseModel&&) noexcept = default;
CaseModel::~CaseModel() = default;

std::string_view model_name(const CaseModel& model) {
    return std::visit([](const auto& alternative) { return std::remove_cvref_t<decltype(alternative)>::kind; }, model);
}

std::vector<std::string> model_names() {
    return detail::kind_names<Models>();
}

std::vector<Quantity> named_inputs(const CaseModel& model) {
    return std::visit(
        [](const auto& parameters) {
            if constexpr (requires { parameters.model; }) {
                return inputs_of(parameters.model);
            } else {
                return inputs_of(parameters);
            }
        },
        model);
}

std::optional<CaseModel> choose_model(Section& section) {
    const std::vector<std::string> names = model_names();
    const Node* node = section.require("model", choices(names));
    const auto index =
        node == nullptr ? std::nullopt : read_choice(section.reading(), *node, section.path_of("model"), names);
    return index ? model_of_index(*index, std::make_index_sequence<std::variant_size_v<Models>>{}) : std::nullopt;
}

bool Expectation::is_word() const {
    const auto* text = std::get_if<std::string>(&value);
    return text != nullptr && !looks_like_quantity(*text);
}

void read_model(Section& section, CaseModel& model) {
    std::visit([&](auto& alternative) { read_fields(section, alternative); }, model);
}

void replace_in_model(Section& section, CaseModel& model) {
    std::visit([&](auto& alternative) { replace_fields(section, alternative); }, model);
}

CaseFile read_case(const std::filesystem::path& path, const std::vector<Setting>& settings,
                   const OutputsOf& outputs_of) {
    if (path == "-") {
        // The name serves for the result folder; as it has no folder, files named by the case are in the working
        // folder.
        return parse_case(read_standard_input(), "stdin.toml", settings, outputs_of);
    }
    return parse_case(read_text_file(path), path.string(), settings, outputs_of);
}

CaseFile parse_case(std::string_view text, std::string_view name, const std::vector<Setting>& settings,
                    const OutputsOf& outputs_of) {
    return case_of_tree(parse_document(text, name), name, settings, outputs_of);
}

CaseFile case_of_tree(Node tree, std::string_view name, const std::vector<Setting>& settings,
                      const OutputsOf& outputs_of) {
    Reading reading{std::string(name)};
    std::vector<Problem> setting_problems;
    for (const Setting& setting : settings) {
        apply_setting(tree, setting, setting_problems);
    }
    for (Problem& problem : setting_problems) {
        reading.complain(std::move(problem));
    }

    copy_alike_mechanisms(tree, reading);

    CaseFile result;
    result.name = std::string(name);
    Section root(reading, tree, "");
    read_schema(root);
    result.title = read_optional_text(root, "title");
    result.description = read_optional_text(root, "description");
    std::optional<CaseModel> model = choose_model(root);
    result.sources = read_sources(root);
    if (!model) {
        // Without a model no other key can be checked.
        reading.finish();
    }
    result.model = *std::move(model);
    read_model(root, result.model);
    complete_model(reading, result.model, name, "");
    const ModelNames names = names_of(result.model, outputs_of, reading.inputs_known());
    result.expectations = read_expectations(root, names);
    // A designed support is put into the model, not into the keys of the case.
    const bool has_own_model = tree.find("support_design") != nullptr;
    result.sweeps = read_sweeps(root, names, [&](const std::string& key, const Node& value) {
        return has_own_model || !reading.clean() ? std::nullopt : number_at(tree, key, value);
    });
    for_table(root, "fit", [&](Section& section) { result.fit = read_fit(section, result, outputs_of); });
    for_table(root, "sensitivity", [&](Section& section) { result.sensitivity = read_sensitivity(section, names); });
    for_table(root, "support_design",
              [&](Section& section) { result.support_design = read_support_design(section, result.model, names); });
    for_table(root, "report", [&](Section& section) { read_fields(section, result.report.emplace()); });
    root.finish([&](const std::string& key) {
        const std::string hint = models_that_have(key);
        const bool says_more = hint.empty() && suggestion(key, root.allowed()).empty() && !reading.full();
        return says_more ? section_that_has_key_of(*tree.find(key), root, result.model) : hint;
    });
    check_sources(reading, result.sources);
    reading.finish();
    result.places = reading.places();
    result.tree = std::move(tree);
    return result;
}

CaseModel model_with(const CaseFile& case_file, const std::vector<Setting>& settings) {
    return case_of_tree(model_part(case_file.tree), case_file.name, settings).model;
}

Problem problem_at(const CaseFile& case_file, const std::string& key, std::string message) {
    Problem problem{case_file.name, 0, 0, key, {}, std::move(message)};
    const auto found = case_file.places.find(key);
    if (found != case_file.places.end()) {
        const Place& place = found->second.place;
        problem.file = place.from_option ? "--set" : case_file.name;
        problem.line = place.line;
        problem.column = place.column;
        problem.value = found->second.value;
    }
    return problem;
}

}  // namespace delabole
