// The commented template of a model: an example that is a valid case, and everything else as comments.
#include "cases/program/case/case_writer.hpp"
#include "cases/program/case/model_cases.hpp"
#include "cases/program/case/starting_cases.hpp"
#include "cases/program/reader/described_reader.hpp"
#include "cases/program/reader/described_writer.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>

namespace delabole {
namespace {

struct ExampleNumber {
    std::string_view key;
    double value;                             // SI
    std::optional<Dimension> dimension = {};  // where keys of several have the name
};

// Examples that make sense beside each other once uncommented.
constexpr auto examples = std::to_array<ExampleNumber>({
    {"first_runs", 20.0},
    {"toe_elevation", 100.0},
    {"width", 5.0},
    {"daylight_height", 1.0},
    {"distance_behind_crest", 4.0},
    {"depth", 4.35},
    {"base_below_crest", 4.35},
    {"base_elevation", 108.0},
    {"water_depth", 3.0},
    {"water_elevation", 110.0},
    {"unit_weight", 9810.0},
    {"from_distance", 1.0},
    {"horizontal_coefficient", 0.1},
    {"vertical_coefficient", 0.0},
    {"lower_dip", degrees(20)},
    {"upper_dip", degrees(55)},
    {"factor_of_safety", 1.0},
    {"joint_roughness_coefficient", 8.0},
    {"roughness_angle", degrees(10)},
    {"residual_friction_angle", degrees(30)},
    {"joint_wall_strength", 50e6},
    {"dip_direction", degrees(95)},
    {"first_dip_direction", degrees(85)},
    {"last_dip_direction", degrees(105)},
    {"concentration", 80.0},
    {"sample_count", 4000.0},
    {"seed", 1967.0},
    {"most_sets", 8.0},
    {"window_dip_direction", degrees(95)},
    {"window_radius", degrees(20)},
    {"least_angle", degrees(15)},
    {"joint_dip", degrees(70)},
    {"spacing", 5.0},
    {"rows", 3.0},
    {"lowest_height", 2.0},
    {"row_spacing", 2.0},
    {"length", 3.0},
    {"head_x", 0.0},
    {"head_y", 1.0},
    {"axial_stiffness", 100e6},
    {"free_length_at_joints", 0.2},
    {"stagger", 1.5},
    {"snap_distance", 0.01},
    {"sliver_share", 0.02},
    {"scatter", 0.2},
    {"thickness", 1.0},
    {"base_inclination", degrees(35)},
    {"base_end_height", 25.0},
    {"step_above", 1.0},
    {"block", 2.0},
    {"other", 1.0},
    {"fixed_block", 3.0},
    {"runs", 8.0},
    {"height", 2.0},
    {"depth_behind", 2.0},
    {"depth_in_front", 0.5},
    {"joint", 1.0},
    {"edge", 1.0},
    {"lower", degrees(10), Dimension::angle},
    {"upper", degrees(40), Dimension::angle},
    {"tolerance", degrees(0.005), Dimension::angle},
    {"lower", 0.1, Dimension::ratio},
    {"upper", 10.0, Dimension::ratio},
    {"tolerance", 0.005, Dimension::ratio},
    {"final_tilt", degrees(20)},
    {"interval", 0.1},
    {"stiffness_ratio", 1e6},
    {"step_fraction", 0.6},
    {"time_step", 1e-4},
    {"viscous_damping", 0.2},
    {"local_damping", 0.2},
    {"equilibrium_ratio", 1e-6},
    {"onset_rotation", 0.01},
    {"onset_slide", 0.01},
    {"collapse_rotation", 0.5},
    {"collapse_displacement", 1.0},
    {"most_steps", 1e8},
    {"overlap_limit", 0.05},
    {"crack_opening", 0.01},
    {"taken_away_below", -10.0},
    {"young_modulus", 5e9},
    {"shear_modulus", 2e9},
    {"height_deviation", 0.05},
    {"friction_deviation", degrees(2)},
    {"belt_speed", 0.02},
    {"lower_inclination", degrees(20)},
    {"upper_inclination", degrees(50)},
    {"lower_end_height", 5.0},
    {"upper_end_height", 30.0},
});

// Stands for the name of an input; template_of replaces it where the model has none of that name.
constexpr std::string_view example_input = "strength.friction_angle";

double example_number(const FieldInfo& info) {
    const auto* const found = std::ranges::find_if(examples, [&](const ExampleNumber& example) {
        return example.key == info.key && example.dimension.value_or(info.dimension) == info.dimension;
    });
    if (found != examples.end()) {
        return found->value;
    }
    if (info.dimension == Dimension::ratio) {
        return 0.5;
    }
    const std::string_view in_quotation_marks = example_of(info.dimension);
    return parse_quantity(in_quotation_marks.substr(1, in_quotation_marks.size() - 2), info.dimension).value;
}

template <class Member>
void fill_with_examples(const FieldInfo& info, Member& member) {
    if constexpr (NumberType<Member>) {
        member = info.has_default ? member : static_cast<Member>(example_number(info));
    } else if constexpr (is_variant<Member>) {
        std::visit([&](auto& alternative) { fill_with_examples(info, alternative); }, member);
    } else if constexpr (std::same_as<Member, std::string>) {
        member = info.key == "parameter" || info.name_of == NameOf::input ? example_input : info.key;
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

// `value` with its explanation behind it.
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

// `named`: the dimension of what the section around names.
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
    return std::string(info.meaning) + (allowed.empty() ? "" : "; " + allowed);
}

// Values that a case leaves out stand there with an example, as comments.
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
            line.pop_back();
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

// Calls visit(field info, member, dimension named), the info with the dimension that its values have here.
template <Described Object, class Visit>
void visit_annotated(const Object& object, Dimension named, Visit&& visit) {
    const Dimension own = detail::dimension_named(object, named);
    visit_fields(object, [&](const FieldInfo& info, const auto& member) {
        FieldInfo here = info;
        here.dimension = info.dimension == Dimension::named ? own : info.dimension;
        visit(here, member, own);
    });
}

template <Described Object>
std::string annotated_values(const Object& object, Dimension named) {
    std::string text;
    visit_annotated(object, named, [&](const FieldInfo& info, const auto& member, Dimension own) {
        text += annotated_value(info, member, own);
    });
    return text;
}

template <Described Object>
std::string annotated_sections(const Object& object, const std::string& path, Dimension named) {
    std::string text;
    visit_annotated(object, named, [&](const FieldInfo& info, const auto& member, Dimension own) {
        text += annotated_section(info, member, path, own);
    });
    return text;
}

// A back-analysis and a sensitivity study of a starting case, with all that they may ask for.
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
    // Of no use without [[support]]: a comment still where the rest is not.
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
        // Behind a dot it ends a longer name.
        if (text[at - 1] != '.') {
            text.replace(at, example_input.size(), own->name);
        }
    }
    return text;
}

template <Described Model>
std::string template_of(const ModelExample<Model>& example) {
    const std::string text =
        "schema = 1\n"
        "title = " +
        in_quotes(example.title) +
        "\n"
        "# description = \"what the case is about\"\n"
        "model = " +
        in_quotes(Model::kind) + "\n" + annotated_values(example.model) + annotated_sections(example.model, "") + "\n" +
        commented(example.further_parts.substr(1)) +
        (std::same_as<Model, PlaneFailureStudy<>> ? commented(annotated_studies()) : "");
    return with_input_of(example.model, text);
}

template <std::size_t... index>
std::string template_of_name(std::string_view model, std::index_sequence<index...>) {
    std::string text;
    const auto try_model = [&]<class Model>(const Model* choice) {
        if (model == Model::kind) {
            text = template_of(example_case(choice));
        }
    };
    (try_model(static_cast<const std::variant_alternative_t<index, CaseModel>*>(nullptr)), ...);
    return text;
}

}  // namespace

std::string commented_template(std::string_view name) {
    const std::vector<std::string> starting = starting_case_names();
    const std::string model = std::ranges::find(starting, name) == starting.end()
                                  ? std::string(name)
                                  : std::string(model_name(parse_case(starting_case(name), name).model));
    std::string text = template_of_name(model, std::make_index_sequence<std::variant_size_v<CaseModel>>{});
    if (text.empty()) {
        throw std::invalid_argument("no model is named " + model + suggestion(model, model_names()));
    }
    return text;
}

}  // namespace delabole
