// [sources] and [[expect]], and the names that they refer to.
#include "cases/program/case/case_parts.hpp"
#include "cases/program/reader/described_reader.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace delabole {
namespace {

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

void check_tolerance(Section& section, const Expectation& expectation) {
    if (!expectation.tolerance) {
        return;
    }
    const auto* words = std::get_if<std::string>(&*expectation.tolerance);
    if (is_negative(*expectation.tolerance)) {
        section.complain("tolerance", *section.peek("tolerance"), "must be at least 0");
    } else if (expectation.dimension) {
        check_written(section, "tolerance", *expectation.tolerance, *expectation.dimension);
    } else if (words != nullptr && !looks_like_quantity(*words)) {
        section.complain("tolerance", *section.peek("tolerance"),
                         "must be a number or a quantity of the value's dimension");
    }
}

Expectation read_expectation(Section& section, const ModelNames& names) {
    Expectation expectation{};
    expectation.place = section.place();
    section.refer_to({std::span(&names, 1), "an output of the model"});
    read_fields(section, expectation);
    if (const Quantity* output = find_quantity(names.outputs, expectation.quantity)) {
        expectation.dimension = output->dimension;
    }
    if (const Node* node = section.peek("value")) {
        if (node->kind == Node::Kind::real && !std::isfinite(node->real)) {
            section.complain("value", *node, "must be a finite number");
        } else if (expectation.dimension) {
            check_written(section, "value", expectation.value, *expectation.dimension);
        }
    }
    check_tolerance(section, expectation);
    const bool absolute = section.contains("tolerance");
    const bool relative = section.contains("relative_tolerance");
    const auto complain = [&](const std::string& message) {
        section.reading().complain(section.place(), section.path(), {}, message);
    };
    if (expectation.is_word() && !expectation.dimension) {
        if (absolute || relative) {
            complain("a word has no tolerance");
        }
    } else if (absolute && relative) {
        complain("takes only one of tolerance and relative_tolerance");
    } else if (!absolute && !relative && !expectation.unreachable) {
        complain("needs a tolerance (absolute) or a relative_tolerance");
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
