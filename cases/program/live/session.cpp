#include "cases/program/live/session.hpp"

#include "cases/program/live/case_text.hpp"
#include "cases/program/live/figure_json.hpp"
#include "cases/program/live/handles.hpp"
#include "cases/program/live/study.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/model_reports.hpp"
#include "cases/program/results/problems_of_case.hpp"
#include "cases/program/sweeps/support_report.hpp"
#include "fitting/mechanism/misfit.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"
#include "plots/report/shown_units.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace delabole {

namespace {

constexpr std::size_t most_handles = 60;  // more would cover the section
constexpr std::chrono::seconds longest_design{3};
constexpr int longest_motion = 1000;  // ms, of one request
constexpr std::size_t most_live_blocks = 20'000;
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

// "strength" for "strength.friction_angle", "bolt[1]" for "bolt[1].force", "case" for an input outside sections. All
// members of a long list are one group.
std::string group_of(const std::string& name, const LongLists& lists) {
    const std::string list = list_of(name);
    if (lists.contains(list)) {
        return list;
    }
    const std::size_t end = name.rfind('.');
    return end == std::string::npos ? "case" : name.substr(0, end);
}

// "joint set[1]: bedding"
std::string label_of(const std::string& group, const CaseFile& file) {
    std::string label = human_name(group);
    const auto name = file.places.find(group + ".name");
    if (name != file.places.end() && name->second.value.size() > 2) {
        label += ": " + human_name(name->second.value.substr(1, name->second.value.size() - 2));  // without its quotes
    }
    return label;
}

Json described(const Quantity& input, const std::string& group, const CaseFile& file) {
    const auto shown = [&](double value) { return in_shown_unit(value, input.dimension); };
    const auto source = file.sources.find(input.name);
    const bool is_listed = input.name.starts_with(group + "[");  // the label must tell which member it is
    return {{"name", input.name},
            {"label", human_name(input.name.substr((is_listed ? group : input.name).rfind('.') + 1))},
            {"unit", std::string(shown_unit(input.dimension).symbol)},
            {"value", shown(input.value)},
            {"lower", finite(shown(input.range.lower))},
            {"upper", finite(shown(input.range.upper))},
            {"lower_open", input.range.lower_open},
            {"upper_open", input.range.upper_open},
            {"meaning", input.meaning},
            {"source", source == file.sources.end() ? "" : source->second}};
}

// Finds an input with the first of these endings that occurs.
std::string first_ending(const std::vector<Quantity>& inputs, std::initializer_list<std::string_view> endings) {
    for (const std::string_view ending : endings) {
        const auto found =
            std::ranges::find_if(inputs, [&](const Quantity& input) { return input.name.ends_with(ending); });
        if (found != inputs.end()) {
            return found->name;
        }
    }
    return "";
}

Json json_of_handles(const CaseModel& model) {
    Json handles = Json::array();
    for (const Handle& handle : handles_of(model)) {
        if (handles.size() < most_handles) {
            handles.push_back({{"name", handle.name},
                               {"inputs", handle.inputs},
                               {"at", Json::array({handle.at.x(), handle.at.y()})},
                               {"is_origin", handle.is_origin}});
            if (handle.from) {
                handles.back()["from"] = Json::array({handle.from->x(), handle.from->y()});
            }
        }
    }
    return handles;
}

// Thrown to stop after the first figure of a report.
struct EnoughFigures {};

// Puts the support that a run designs into the model.
DesignedSupport designed_support(CaseFile& file) {
    const auto end = std::chrono::steady_clock::now() + longest_design;
    bool over = false;
    std::optional<DesignedSupport> support = design_support_of(file, [&](double) {
        over = std::chrono::steady_clock::now() > end;
        return !over;
    });
    if (!support) {
        throw LiveRefusal("the case has no [support_design]");
    }
    if (over) {
        throw LiveRefusal("the patterns of [support_design] take longer than " +
                          std::to_string(longest_design.count()) +
                          " s: the support is as the case has it, delabole run designs it");
    }
    return std::move(*support);
}

std::optional<FitProblem> fit_of(const CaseFile& file) {
    const ModelInterface model = interface_of(file.model);
    if (!file.fit || model.costly) {
        return std::nullopt;
    }
    for (const FitMechanism& mechanism : file.fit->mechanisms) {
        if (names_in(named_inputs(mechanism.model)) == names_in(named_inputs(file.model))) {
            return FitProblem{*file.fit, {Mechanism{mechanism, model}}};
        }
    }
    return std::nullopt;
}

}  // namespace

LiveSession::LiveSession(CaseFile file, std::string text, WriteReport write_report)
    : file_(std::move(file)),
      text_(std::move(text)),
      inputs_(named_inputs(file_.model)),
      fit_(fit_of(file_)),
      write_report_(std::move(write_report)) {}

std::vector<Condition> LiveSession::conditions(const Json& request) const {
    std::vector<Condition> conditions;
    const Json values = member_or<Json>(request, "values", Json::object());
    if (!values.is_object()) {
        throw LiveRefusal("'values' of the request is of the wrong kind");
    }
    for (const auto& [name, value] : values.items()) {
        const Quantity& input = input_named(inputs_, name);
        if (!value.is_number()) {
            throw LiveRefusal(name + " has to be a number");
        }
        const auto shown = value.get<double>();
        // If the page returns the value that it was shown, the input keeps its value to the last bit.
        const double si = shown == in_shown_unit(input.value, input.dimension)
                              ? input.value
                              : shown * shown_unit(input.dimension).si_per_unit;
        if (!std::isfinite(si) || !input.range.contains(si)) {
            throw LiveRefusal(name + " = " + readable_quantity(si, input.dimension) + ": must be " +
                              readable_range(input.range, input.dimension));
        }
        conditions.push_back({name, si});
    }
    return conditions;
}

CaseModel LiveSession::model(const Json& request) const {
    return with_conditions(file_.model, conditions(request));
}

Json LiveSession::open() const {
    Json groups = Json::array();
    const LongLists lists = long_lists(inputs_);
    for (const Quantity& input : inputs_) {
        const std::string group = group_of(input.name, lists);
        const auto found = std::ranges::find_if(groups, [&](const Json& one) { return one["name"] == group; });
        if (found == groups.end()) {
            groups.push_back({{"name", group},
                              {"label", label_of(group, file_)},
                              {"inputs", Json::array({described(input, group, file_)})}});
        } else {
            (*found)["inputs"].push_back(described(input, group, file_));
        }
    }
    const bool moves = std::holds_alternative<RelaxationStudy>(file_.model);
    const std::string friction = first_ending(
        inputs_, {"strength.friction_angle", "joints.friction_angle", "base.friction_angle", "friction_angle"});
    const std::string water =
        first_ending(inputs_, {"water.water_depth", "water.water_elevation", "water.filled_ratio", "cohesion", "dip"});
    Json json{{"title", title_of(file_, {})},
              {"description", file_.description},
              {"model", std::string(model_name(file_.model))},
              {"moves", moves},
              {"metre", 1 / shown_unit(Dimension::length).si_per_unit},
              {"studies", has_study(file_, fit_)},
              {"designs_support", file_.support_design.has_value()},
              {"groups", std::move(groups)}};
    if (fit_) {
        for (const FreeParameter& free : fit_->mechanisms.front().parameters) {
            json["fit"][free.name] = {in_shown_unit(free.lower, free.dimension),
                                      in_shown_unit(free.upper, free.dimension)};
        }
    }
    if (moves || find_quantity(interface_of(file_.model).outputs, "factor_of_safety") == nullptr) {
        return json;
    }
    if (fit_ && fit_->mechanisms.front().parameters.size() > 1) {
        const std::vector<FreeParameter>& free = fit_->mechanisms.front().parameters;
        json["map"] = {{"x", free[0].name}, {"y", free[1].name}, {"output", "factor_of_safety"}};
    } else if (!friction.empty() && !water.empty()) {
        json["map"] = {{"x", friction}, {"y", water}, {"output", "factor_of_safety"}};
    }
    return json;
}

Json LiveSession::answer_to(const CaseModel& model, bool all_figures) const {
    Json json{{"handles", json_of_handles(model)}, {"figures", Json::array()}};
    if (std::holds_alternative<RelaxationStudy>(model)) {
        return json;  // the page sets it in motion instead
    }
    const CaseAnswer answer = analyse_case(model);
    const Analysis analysis = named_outputs(model, answer);
    if (!analysis.failure.empty()) {
        CaseFile changed = file_;
        changed.model = model;
        json["failure"] = impossible(changed, analysis.failure).message;
        return json;
    }
    const HeadCard head = head_card(model, answer);
    json["verdict"] = head.sentences.front();
    json["sentences"] = std::vector<std::string>(head.sentences.begin() + 1, head.sentences.end());
    json["results"] = Json::array();
    for (const NamedOutput& output : analysis.outputs) {
        json["results"].push_back({{"name", output.name},
                                   {"meaning", output.meaning},
                                   {"text", in_table_digits(output.value, output.dimension)},
                                   {"detail", output.detail}});
    }
    json["warnings"] = analysis.warnings;
    Report ignored;
    const ResultFolder figures([&](const Figure& figure, const std::string& caption) {
        const Figure shown = in_shown_units(figure);
        if (json["figures"].empty()) {
            json["metre"] = shown.x.unit == figure.x.unit ? 1 : 1 / shown_unit(Dimension::length).si_per_unit;
        }
        json["figures"].push_back(json_of(shown));
        json["figures"].back()["caption"] = caption;
        if (!all_figures) {
            throw EnoughFigures();
        }
    });
    const Sheet sheet{figures, ignored};
    try {
        if (fit_ && fit_->profile) {  // the section with the ground that was observed and the one predicted
            MechanismFit here{};
            std::visit([&](const auto& study) { append_mechanism_figures(study, here, *fit_, sheet); }, model);
        }
        append_case_figures(model, answer, sheet);
    } catch (const EnoughFigures&) {
        return json;
    }
    return json;
}

Json LiveSession::answer(const Json& request) const {
    return answer_to(model(request), member_or<std::string>(request, "figures", "first") == "all");
}

Json LiveSession::drag(const Json& request) const {
    const CaseModel before = model(request);
    const auto to = member<std::vector<double>>(request, "to");
    if (to.size() != 2 || !std::isfinite(to[0]) || !std::isfinite(to[1])) {
        throw LiveRefusal("'to' of the request is a point: two numbers");
    }
    std::vector<Condition> moved;
    try {
        moved = dragged(before, member<std::string>(request, "handle"), {to[0], to[1]});
    } catch (const std::invalid_argument& error) {
        throw LiveRefusal(error.what());
    }
    Json json = answer_to(with_conditions(before, moved), false);
    for (const Condition& condition : moved) {
        json["values"][condition.input] =
            in_shown_unit(condition.value, find_quantity(inputs_, condition.input)->dimension);
    }
    return json;
}

Json LiveSession::map(const Json& request) const {
    const ModelInterface model = interface_of(this->model(request));
    const MapAxis x = axis_of_map(request, "x", "columns", model.inputs);
    const MapAxis y = axis_of_map(request, "y", "rows", model.inputs);
    const auto name = member<std::string>(request, "output");
    const auto output = place_of(model.outputs, name);
    if (!output || model.costly) {
        throw LiveRefusal("there is no map of '" + name + "'");
    }
    return over_grid(x, y, [&](double across, double up) {
        const Prediction prediction = model.predict(std::array{Assignment{x.input, across}, Assignment{y.input, up}});
        return prediction.outputs.empty() ? no_number : prediction.outputs[*output];
    });
}

Json LiveSession::fit(const Json& request) const {
    if (!fit_) {
        throw LiveRefusal("the case has no back-analysis of its own model");
    }
    FitProblem problem = *fit_;
    Mechanism& mechanism = problem.mechanisms.front();
    mechanism.model = interface_of(model(request));
    const Misfit misfit(mechanism, problem);
    std::vector<double> point;
    for (const FreeParameter& parameter : mechanism.parameters) {
        point.push_back(find_quantity(mechanism.model.inputs, parameter.name)->value);
    }
    const auto place = [&](const MapAxis& axis) {
        return std::ranges::find(mechanism.parameters, mechanism.model.inputs[axis.input].name, &FreeParameter::name) -
               mechanism.parameters.begin();
    };
    const MapAxis x = axis_of_map(request, "x", "columns", mechanism.model.inputs);
    const MapAxis y = axis_of_map(request, "y", "rows", mechanism.model.inputs);
    Json observations = Json::array();
    for (const ObservationFit& row : misfit.compare(point)) {
        observations.push_back({{"label", row.label},
                                {"observed", value_in_words(row.observed, row.dimension)},
                                {"relation", row.relation == Relation::equal ? "" : human_name(word_of(row.relation))},
                                {"predicted", row.predicted ? value_in_words(*row.predicted, row.dimension) : ""},
                                {"residual", finite(row.residual)}});
    }
    const auto across = static_cast<std::size_t>(place(x));
    const auto up = static_cast<std::size_t>(place(y));
    Json json = across < point.size() && up < point.size()
                    ? over_grid(x, y,
                                [&](double x_value, double y_value) {
                                    std::vector<double> at = point;
                                    at[across] = x_value;
                                    at[up] = y_value;
                                    const MisfitParts parts = misfit.parts(at);
                                    return parts.failure.empty() ? parts.data + parts.prior : no_number;
                                })
                    : Json::object();
    json["observations"] = std::move(observations);
    return json;
}

Json LiveSession::study(const Json& request) const {
    CaseFile changed = file_;
    changed.model = model(request);
    if (const std::string failure = failure_of(changed.model); !failure.empty()) {
        throw LiveRefusal(impossible(changed, failure).message);
    }
    try {
        return {{"sentences", studied(changed, fit_)}};
    } catch (const std::runtime_error& error) {
        throw LiveRefusal(error.what());
    }
}

Json LiveSession::support(const Json& request) const {
    CaseFile changed = file_;
    changed.model = model(request);
    const DesignedSupport designed = designed_support(changed);
    const std::vector<Quantity> inputs = named_inputs(changed.model);
    Json json{{"sentence", designed.sentence}, {"values", Json::object()}};
    for (const SupportChoice& choice : designed.design.choices) {
        const Quantity& input = input_named(inputs, choice.input);
        json["values"][input.name] = in_shown_unit(input.value, input.dimension);
    }
    return json;
}

// Returns the support that was chosen by hand, or nothing if it is the one that a run would choose. The two are
// compared within rounding, since the page has its values in display units.
std::vector<Condition> LiveSession::chosen_support(const std::vector<Condition>& conditions) const {
    CaseFile designed = file_;
    designed.model = with_conditions(file_.model, conditions);
    const std::vector<Quantity> asked = named_inputs(designed.model);
    const DesignedSupport support = designed_support(designed);
    const std::vector<Quantity> found = named_inputs(designed.model);
    constexpr double rounding = 1e-9;
    bool same = true;
    std::vector<Condition> chosen;
    for (const SupportChoice& choice : support.design.choices) {
        chosen.push_back({choice.input, input_named(asked, choice.input).value, choice.dimension});
        const double value = chosen.back().value;
        same = same && std::abs(value - input_named(found, choice.input).value) <= rounding * std::abs(value);
    }
    return same ? std::vector<Condition>() : chosen;
}

Json LiveSession::save(const Json& request) const {
    try {
        return {{"toml", with_values(text_, file_, conditions(request))}};
    } catch (const std::invalid_argument& error) {
        throw LiveRefusal(error.what());
    }
}

Json LiveSession::report(const Json& request) {
    std::vector<std::string> settings;
    std::vector<Condition> values = conditions(request);
    if (file_.support_design) {
        const std::vector<Condition> chosen = chosen_support(values);
        std::erase_if(values, [&](const Condition& value) {
            return std::ranges::find(file_.support_design->choices, value.input, &SupportChoice::input) !=
                   file_.support_design->choices.end();
        });
        values.insert(values.end(), chosen.begin(), chosen.end());
    }
    for (const Condition& condition : values) {
        settings.push_back(condition.input + "=" +
                           written_quantity(condition.value, find_quantity(inputs_, condition.input)->dimension));
    }
    const std::scoped_lock lock(writing_);
    try {
        return {{"folder", write_report_(settings).string()}};
    } catch (const std::runtime_error& error) {
        throw LiveRefusal(error.what());
    }
}

Json LiveSession::start_motion(const Json& request) {
    const CaseModel model = this->model(request);
    const auto* study = std::get_if<RelaxationStudy>(&model);
    if (study == nullptr) {
        throw LiveRefusal("only blocks of the model relaxation can be set in motion");
    }
    if (number_of_blocks(*study) > most_live_blocks) {
        throw LiveRefusal("there are more than " + std::to_string(most_live_blocks) + " blocks: use delabole run");
    }
    if (const std::string failure = failure_of(model); !failure.empty()) {
        CaseFile changed = file_;
        changed.model = model;
        throw LiveRefusal(impossible(changed, failure).message);
    }
    const std::scoped_lock lock(moving_);
    motion_.emplace(*study);
    return motion_->blocks();
}

std::string LiveSession::step_motion(const Json& request) {
    const auto steps = member_or<std::uint64_t>(request, "steps", std::uint64_t{1} << 32U);
    const int time = std::clamp(member_or<int>(request, "milliseconds", longest_motion), 0, longest_motion);
    const std::scoped_lock lock(moving_);
    if (!motion_) {
        throw LiveRefusal("nothing has been set in motion");
    }
    motion_->go_on(steps, std::chrono::milliseconds(time));
    return motion_->picture();
}

Json LiveSession::verdict_of_motion(const Json& /*request*/) {
    const std::scoped_lock lock(moving_);
    if (!motion_) {
        throw LiveRefusal("nothing has been set in motion");
    }
    return motion_->verdict();
}

Json LiveSession::change_motion(const Json& request) {
    const CaseModel model = this->model(request);
    const auto* study = std::get_if<RelaxationStudy>(&model);
    const std::scoped_lock lock(moving_);
    if (study == nullptr || !motion_) {
        throw LiveRefusal("nothing has been set in motion");
    }
    if (check(*study).check != SceneCheck::valid || !motion_->change(*study)) {
        throw LiveRefusal("blocks of another shape have to be set in motion anew");
    }
    return Json::object();
}

}  // namespace delabole
