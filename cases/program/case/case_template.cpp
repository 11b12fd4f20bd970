// The commented template of a model: a valid example case, with everything else as comments.
#include "cases/program/case/case_writer.hpp"
#include "cases/program/case/model_cases.hpp"
#include "cases/program/case/starting_cases.hpp"
#include "cases/program/reader/data_table.hpp"
#include "cases/program/reader/described_writer.hpp"

#include <algorithm>
#include <stdexcept>

namespace delabole {
namespace {

struct ExampleValue {
    std::string key;
    double value;
    std::string unit;  // empty for a ratio
    static constexpr auto fields() {
        return FieldTable{section<&ExampleValue::key>("the key"), number<&ExampleValue::value>("a value"),
                          with_default(section<&ExampleValue::unit>("its unit, of whose dimension the key is meant"))};
    }
};

// Example name of an input; commented_template replaces it if the model has no input of that name.
constexpr std::string_view example_input = "strength.friction_angle";

double example_number(const FieldInfo& info) {
    static const std::vector<ExampleValue> examples = parse_table<ExampleValue>(template_values, "values.csv");
    for (const ExampleValue& example : examples) {
        if (example.key == info.key) {
            const ParsedQuantity parsed =
                example.unit.empty()
                    ? unitless_quantity(example.value, info.dimension)
                    : parse_quantity(shortest_number(example.value) + " " + example.unit, info.dimension);
            if (parsed.status == QuantityStatus::ok) {
                return parsed.value;
            }
        }
    }
    if (info.dimension == Dimension::ratio) {
        return 0.5;
    }
    const std::string_view in_quotation_marks = dimension_words(info.dimension).example;
    return parse_quantity(in_quotation_marks.substr(1, in_quotation_marks.size() - 2), info.dimension).value;
}

template <class Member>
void fill_with_examples(const FieldInfo& info, Member& member) {
    if constexpr (NumberType<Member>) {
        member = info.has_default ? member : static_cast<Member>(example_number(info));
    } else if constexpr (is_variant<Member>) {
        std::visit([&](auto& alternative) { fill_with_examples(info, alternative); }, member);
    } else if constexpr (std::same_as<Member, std::string>) {
        member = info.key == "parameter" || info.name_of == NameOf::input ? example_input
                 : info.key == "outline_file"                             ? "my_slope.dxf"
                 : info.key.ends_with("file")                             ? "my_record.csv"
                                                                          : info.key;
    } else if constexpr (std::same_as<Member, Polyline>) {
        member = {Point(0, 0), Point(10, 8), Point(10, 12)};
    } else if constexpr (std::same_as<Member, PairOfTexts>) {
        member = {"strength.cohesion", std::string(example_input)};
    } else if constexpr (std::same_as<Member, std::vector<Condition>>) {
        member = {{std::string(example_input), degrees(35), Dimension::angle}};
    } else if constexpr (Described<Member>) {
        visit_fields(member,
                     [](const FieldInfo& inner, auto& inner_member) { fill_with_examples(inner, inner_member); });
    }
}

template <class Type>
Type example() {
    Type value{};
    fill_with_examples(FieldInfo{}, value);
    return value;
}

std::string commented(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        result += line.empty() ? "#\n" : "# " + std::string(line) + "\n";
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return result;
}

// `line` followed by its explanation.
std::string explained(const std::string& line, const std::string& explanation) {
    constexpr std::size_t explanation_column = 36;
    const std::size_t padding = line.size() < explanation_column ? explanation_column - line.size() : 2;
    return line + std::string(padding, ' ') + "# " + explanation + "\n";
}

std::string after_blank_line(const std::string& text) {
    return std::string(1, '\n').append(text);
}

std::string header_of(const std::string& path) {
    return std::string(1, '[').append(path).append(1, ']');
}

// `named` is the dimension of the quantity that the section around names.
template <Described Object>
std::string annotated_values(const Object& object, Dimension named = Dimension::ratio);
template <Described Object>
std::string annotated_sections(const Object& object, const std::string& path, Dimension named = Dimension::ratio);

template <class Member>
std::string explanation_of(const FieldInfo& info) {
    std::string allowed;
    if constexpr (NumberType<Member>) {
        allowed = readable_range(info.range, info.dimension);
    } else if constexpr (std::is_enum_v<Member>) {
        allowed = choices(detail::enum_words<Member>());
    }
    return text_of(info) + (allowed.empty() ? "" : "; " + allowed);
}

// Keys that the case leaves out appear as comments with an example.
template <class Member>
std::string annotated_value(const FieldInfo& info, const Member& member, Dimension named) {
    if constexpr (is_optional<Member>) {
        using Inner = typename Member::value_type;
        if (member) {
            return annotated_value(info, *member, named);
        }
        if constexpr (detail::is_value<Inner>) {
            Inner inner{};
            fill_with_examples(info, inner);
            return commented(annotated_value(info, inner, named));
        }
    } else if constexpr (detail::is_value<Member>) {
        std::string line;
        detail::write_value(line, info, member, named);
        if (!line.empty()) {
            // Without the ".0" of a case that the program writes: many numbers are counts.
            line.resize(line.size() - (line.ends_with(".0\n") ? 3 : 1));
            return explained(line, explanation_of<Member>(info));
        }
        if constexpr (is_list_of_texts<Member>) {
            return commented(explained(std::string(info.key) + " = [\"name\"]", explanation_of<Member>(info)));
        } else {
            Member example{};
            fill_with_examples(info, example);
            return commented(annotated_value(info, example, named));
        }
    } else if constexpr (is_variant<Member>) {
        if (!info.key.empty()) {
            return {};
        }
        const auto values = [&]<class Alternative>(const Alternative& alternative) {
            std::string text;
            if constexpr (requires { Alternative::kind; }) {
                write_line(text, kind_key<Member>(), in_quotes(Alternative::kind));
            }
            return text + annotated_values(alternative, named);
        };
        std::string text = std::visit(values, member);
        detail::for_each_alternative<Member>([&]<std::size_t index, class Alternative>() {
            if (index != member.index()) {
                text += commented("or:\n" + values(example<Alternative>()));
            }
        });
        return text;
    } else if constexpr (Described<Member>) {
        return info.key.empty() ? annotated_values(member, named) : "";
    }
    return {};
}

template <class Alternative>
std::string annotated_kind(std::string_view key, const Alternative& alternative, const FieldInfo& info,
                           const std::string& path, Dimension named) {
    return std::string(key) + " = " + in_quotes(Alternative::kind) + "\n" + annotated_values(alternative, named) +
           annotated_sections(alternative, joined_path(path, info.key), named);
}

template <class Member>
std::string annotated_section(const FieldInfo& info, const Member& member, const std::string& path, Dimension named) {
    const std::string inner = joined_path(path, info.key);
    if constexpr (is_optional<Member>) {
        using Inner = typename Member::value_type;
        if (member) {
            return annotated_section(info, *member, path, named);
        }
        if constexpr (!detail::is_value<Inner>) {
            return after_blank_line(commented(annotated_section(info, example<Inner>(), path, named).substr(1)));
        }
    } else if constexpr (detail::is_value<Member>) {
        return {};
    } else if constexpr (is_vector<Member>) {
        using Element = typename Member::value_type;
        const auto one = [&](const Element& element) {
            return explained(header_of(header_of(inner)), std::string(info.meaning) + "; one section each") +
                   annotated_values(element, named) + annotated_sections(element, inner, named);
        };
        std::string text;
        for (const Element& element : member) {
            text += after_blank_line(one(element));
        }
        return member.empty() ? after_blank_line(commented(one(example<Element>()))) : text;
    } else if constexpr (detail::is_keyed_variant<Member>) {
        if (info.key.empty()) {
            return {};
        }
        std::string text = after_blank_line(explained(header_of(inner), std::string(info.meaning)));
        constexpr std::string_view key = kind_key<Member>();
        text += std::visit([&](const auto& alternative) { return annotated_kind(key, alternative, info, path, named); },
                           member);
        detail::for_each_alternative<Member>([&]<std::size_t index, class Alternative>() {
            if (index != member.index()) {
                text += commented("or:\n" + annotated_kind(key, example<Alternative>(), info, path, named));
            }
        });
        return text;
    } else if constexpr (Described<Member>) {
        if (info.key.empty()) {
            return annotated_sections(member, path, named);
        }
        return after_blank_line(explained(header_of(inner), std::string(info.meaning))) +
               annotated_values(member, named) + annotated_sections(member, inner, named);
    }
    return {};
}

// The field with the dimension of its values in a section that names a quantity of the dimension `named`.
FieldInfo in_this_section(FieldInfo info, Dimension named) {
    info.dimension = info.dimension == Dimension::named ? named : info.dimension;
    return info;
}

template <Described Object>
std::string annotated_values(const Object& object, Dimension named) {
    const Dimension own = detail::dimension_named(object, named);
    std::string text;
    visit_fields(object, [&](const FieldInfo& info, const auto& member) {
        text += annotated_value(in_this_section(info, own), member, own);
    });
    return text;
}

template <Described Object>
std::string annotated_sections(const Object& object, const std::string& path, Dimension named) {
    const Dimension own = detail::dimension_named(object, named);
    std::string text;
    visit_fields(object, [&](const FieldInfo& info, const auto& member) {
        text += annotated_section(in_this_section(info, own), member, path, own);
    });
    return text;
}

// The sections of a back-analysis and a sensitivity study of starting cases, with all their possible keys.
std::string annotated_studies() {
    const CaseFit fit = *parse_case(starting_case("fit"), "fit").fit;
    std::string text = after_blank_line(explained("[fit]", "delabole fit"));
    text += annotated_values(fit) + annotated_sections(fit, "fit");
    for (const FitMechanism& mechanism : fit.mechanisms) {
        text += after_blank_line(explained("[[fit.mechanism]]", "what may have happened; one section each"));
        text += annotated_values(mechanism) + annotated_sections(mechanism, "fit.mechanism");
    }
    const CaseFile supported = parse_case(starting_case("support"), "support");
    text += after_blank_line(explained("[sensitivity]", "delabole sensitivity"));
    text += annotated_values(*supported.sensitivity) + annotated_sections(*supported.sensitivity, "sensitivity");
    // [support_design] is useless without [[support]], so it is always a comment.
    return text + "\n" +
           commented(explained("[support_design]", "the cheapest of the patterns of [[support]]") +
                     annotated_values(*supported.support_design) +
                     annotated_sections(*supported.support_design, "support_design"));
}

std::string with_input_of(const CaseModel& model, std::string text) {
    const std::vector<Quantity> inputs = named_inputs(model);
    if (std::ranges::find(inputs, example_input, &Quantity::name) != inputs.end()) {
        return text;
    }
    const auto own = std::find_if(inputs.rbegin(), inputs.rend(),
                                  [](const Quantity& input) { return input.name.ends_with(".friction_angle"); });
    for (std::size_t at = text.find(example_input); own != inputs.rend() && at != std::string::npos;
         at = text.find(example_input, at + own->name.size())) {
        // After a dot the text is the end of a longer name.
        if (text[at - 1] != '.') {
            text.replace(at, example_input.size(), own->name);
        }
    }
    return text;
}

}  // namespace

std::string commented_template(std::string_view name) {
    const std::vector<std::string> models = model_names();
    const bool known = std::ranges::find(models, name) != models.end();
    const std::vector<std::string> starting = starting_case_names();
    if (!known && std::ranges::find(starting, name) == starting.end()) {
        throw std::invalid_argument("no model is named " + std::string(name) + suggestion(std::string(name), models));
    }
    const std::string_view model = known ? name : model_name(parse_case(starting_case(name), name).model);
    // A jointed slope is another scene than that of the model's template.
    const std::string text = name == "jointed_slope" ? starting_case(name) : template_case(model);
    const CaseFile file = parse_case(text, model);
    const std::size_t further = std::min(text.find("[sources]"), text.find("[[expect]]"));
    return with_input_of(
        file.model,
        "schema = 1\ntitle = " + in_quotes(file.title) +
            "\n# description = \"what the case is about\"\nmodel = " + in_quotes(model) + "\n" +
            std::visit([](const auto& study) { return annotated_values(study) + annotated_sections(study, ""); },
                       file.model) +
            "\n" + commented(std::string_view(text).substr(std::min(further, text.size()))) +
            (std::holds_alternative<PlaneFailureStudy<>>(file.model) ? commented(annotated_studies()) : ""));
}

}  // namespace delabole
