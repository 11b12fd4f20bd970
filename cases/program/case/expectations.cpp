// [sources] and [[expect]], and the names they use.
#include "cases/program/case/case_parts.hpp"
#include "cases/program/reader/spelling.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace delabole {
namespace {

const Node* take_table(Section& section, std::string_view key) {
    const Node* node = section.take(key);
    return node == nullptr ? nullptr : as_table(section.reading(), *node, section.path_of(key));
}

void check_written(Section& section, std::string_view key, const WrittenValue& value, Dimension dimension) {
    const ParsedQuantity parsed = parse_value(value, dimension);
    if (parsed.status != QuantityStatus::ok) {
        section.complain(key, *section.peek(key), parsed.message);
    }
}

bool is_negative(const WrittenValue& value) {
    const auto* number = std::get_if<double>(&value);
    return number != nullptr ? !(*number >= 0) : std::get<std::string>(value).find('-') == 0;
}

void read_tolerances(Section& section, Expectation& expectation) {
    if (const Node* node = section.take("tolerance")) {
        expectation.tolerance = read_written(section.reading(), *node, section.path_of("tolerance"));
        if (expectation.tolerance && is_negative(*expectation.tolerance)) {
            section.complain("tolerance", *node, "must be at least 0");
        } else if (expectation.tolerance && expectation.dimension) {
            check_written(section, "tolerance", *expectation.tolerance, *expectation.dimension);
        } else if (expectation.tolerance && std::holds_alternative<std::string>(*expectation.tolerance) &&
                   !looks_like_quantity(std::get<std::string>(*expectation.tolerance))) {
            section.complain("tolerance", *node, "must be a number or a quantity of the value's dimension");
        }
    }
    if (const Node* node = section.take("relative_tolerance")) {
        expectation.relative_tolerance =
            read_number(section.reading(), *node, section.path_of("relative_tolerance"), Dimension::ratio, at_least(0));
    }
}

Expectation read_expectation(Section& section, const ModelNames& names) {
    Expectation expectation;
    expectation.place = section.place();
    expectation.label = read_optional_text(section, "label");
    expectation.quantity = require_text(section, "quantity", "name of an output of the model");
    if (const Quantity* output = find_quantity(names.outputs, expectation.quantity)) {
        expectation.dimension = output->dimension;
    }
    if (const Node* node = section.require("value", "the value to compare with")) {
        expectation.value = read_written(section.reading(), *node, section.path_of("value")).value_or(0.0);
        if (node->kind == Node::Kind::real && !std::isfinite(node->real)) {
            section.complain("value", *node, "must be a finite number");
        } else if (expectation.dimension) {
            check_written(section, "value", expectation.value, *expectation.dimension);
        }
    }
    read_tolerances(section, expectation);
    section.refer_to({std::span(&names, 1), "an output of the model"});
    expectation.conditions = read_conditions(section, "with");
    expectation.source = read_optional_text(section, "source");
    expectation.note = read_optional_text(section, "note");
    if (section.contains("unreachable")) {
        expectation.unreachable = require_text(section, "unreachable", "why the value cannot be reached");
    } else {
        section.allow("unreachable");
    }
    const bool absolute = section.contains("tolerance");
    const bool relative = section.contains("relative_tolerance");
    if (expectation.is_word() && !expectation.dimension) {
        if (absolute || relative) {
            section.reading().complain(section.place(), section.path(), {}, "a word has no tolerance");
        }
    } else if (absolute && relative) {
        section.reading().complain(section.place(), section.path(), {},
                                   "takes only one of tolerance and relative_tolerance");
    } else if (!absolute && !relative && !section.contains("unreachable")) {
        section.reading().complain(section.place(), section.path(), {},
                                   "needs a tolerance (absolute) or a relative_tolerance");
    }
    return expectation;
}

}  // namespace

ModelNames names_of(const CaseModel& model, const OutputsOf& outputs_of, bool inputs_known) {
    return {{}, named_inputs(model), outputs_of(model), inputs_known};
}

std::vector<Expectation> read_expectations(Section& root, const ModelNames& names) {
    std::vector<Expectation> expectations;
    for_each_table(root, "expect", [&](Section& section) { expectations.push_back(read_expectation(section, names)); });
    return expectations;
}

std::map<std::string, std::string> read_sources(Section& root) {
    std::map<std::string, std::string> sources;
    const Node* table = take_table(root, "sources");
    if (table == nullptr) {
        return sources;
    }
    const auto read = [&](const std::string& key, const Node& node) {
        const std::string path = "sources." + key;
        root.reading().remember(path, node);
        const auto text = read_text(root.reading(), node, path);
        if (text && !sources.emplace(key, *text).second) {
            root.reading().complain(node.key_place, path, {}, "is given twice");
        }
    };
    for_each_flat_entry(*table, read);
    return sources;
}

void check_sources(Reading& reading, const std::map<std::string, std::string>& sources) {
    std::vector<std::string> keys;
    for (const auto& [key, place] : reading.places()) {
        if (!key.starts_with("sources")) {
            keys.push_back(key);
        }
    }
    for (const auto& [key, text] : sources) {
        if (std::ranges::binary_search(keys, key) || reading.full()) {
            continue;
        }
        reading.complain_at("sources." + key, "names a key that the case does not have" + suggestion(key, keys));
    }
}

}  // namespace delabole
