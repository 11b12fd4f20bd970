#include "cases/program/results/study_output.hpp"

#include "cases/program/case/case_writer.hpp"
#include "cases/program/reader/names.hpp"
#include "fitting/work/words.hpp"

#include <iostream>
#include <utility>

namespace delabole {

namespace {

// Adds the places of the cables whose tension is solved for, which are no inputs of the model itself.
void add_cables(std::vector<RequiredCable<>> cables, std::vector<Quantity>& inputs) {
    for (std::size_t index = 0; index < cables.size(); ++index) {
        for_each_named_number(cables[index], [&](const std::string& key, const FieldInfo& info, double value) {
            inputs.push_back({.name = "required_cable[" + std::to_string(index + 1) + "]." + key,
                              .dimension = info.dimension,
                              .meaning = std::string(info.meaning),
                              .value = value});
        });
    }
}

}  // namespace

void append_inputs(const CaseFile& file, Report& report) {
    Table table{"Inputs of the case", {"input", "value"_number, "meaning", "source"}};
    std::vector<Quantity> inputs = named_inputs(file.model);
    if (const auto* study = std::get_if<SteppedBaseStudy<>>(&file.model)) {
        add_cables(study->required_cable, inputs);
    }
    LongLists lists = long_lists(inputs);
    for (const Quantity& input : inputs) {
        const auto list = lists.find(list_of(input.name));
        if (list != lists.end()) {
            if (const std::size_t members = std::exchange(list->second, 0); members > 0) {
                table.rows.push_back({list->first, std::to_string(members) + " entries", "listed in resolved.toml"});
            }
            continue;
        }
        const auto source = file.sources.find(input.name);
        const bool is_metric = shown_unit(input.dimension).symbol == display_unit(input.dimension).symbol;
        table.rows.push_back(
            {input.name,
             is_metric ? readable_quantity(input.value, input.dimension) : in_six_digits(input.value, input.dimension),
             input.meaning, source == file.sources.end() ? "" : source->second});
    }
    report.add(Heading{"Inputs"});
    report.add(std::move(table));
}

Table evidence_table(const FitProblem& problem) {
    Table table{"Evidence and priors", {{"kind"}, {"what"}, {"source"}}};
    for (const QuantityObservation& observation : problem.observations) {
        table.rows.push_back({"observation", observation.label, observation.source});
    }
    if (problem.profile) {
        table.rows.push_back(
            {"profile", "standard deviation " + value_in_words(problem.profile->standard_deviation, Dimension::length),
             problem.profile->source});
    }
    for (const FieldEvidence& evidence : problem.evidence) {
        table.rows.push_back({"field evidence", evidence.statement, evidence.source});
    }
    for (const Mechanism& mechanism : problem.mechanisms) {
        for (const FreeParameter& parameter : mechanism.parameters) {
            if (parameter.prior) {
                table.rows.push_back({"prior (" + mechanism.name + ")", parameter.name, parameter.prior->source});
            }
        }
    }
    return table;
}

FitProgressCallback told_to(Progress& progress) {
    return [&progress](const FitProgress& state) {
        progress.report(state.fraction, std::string(state.mechanism) + ": " + std::string(state.stage));
    };
}

void say_left_out(const std::vector<std::string>& names, const std::string& and_so, Json& json, std::string& screen,
                  Report& report) {
    if (!names.empty()) {
        const std::string sentence =
            "Left out: " + list_in_words(names) + ". Every prediction is a run of dynamic relaxation" + and_so;
        json["left_out"] = names;
        screen += sentence + "\n";
        report.add(Paragraph{sentence});
    }
}

std::string written_where(const ResultFolder& folder, const Options& options) {
    return options.no_report ? "results in " + folder.path().string()
                             : "report in " + (folder.path() / "report.html").string();
}

void add_reservation(const std::string& reserved, bool interrupted, Report& report) {
    if (!reserved.empty()) {
        report.add(Notice{NoticeKind::warning, interrupted ? "Interrupted" : "Not converged", {reserved}});
    }
}

ExitCode write_study(const StudyOutput& output, const ResultFolder& folder, const Options& options, Report& report) {
    report.add(Folded{"Provenance", {provenance_block(output.json["provenance"])}});
    folder.write("resolved.toml", resolved_toml(output.file));
    folder.write_report(report);
    folder.write("result.json", json_text(output.json));
    if (options.json) {
        std::cout << json_text(output.json);
    } else if (!options.quiet) {
        std::cout << report.title << '\n' << output.screen << written_where(folder, options) << '\n';
    }
    if (!output.reserved.empty()) {
        std::cerr << "delabole: " << output.reserved << '\n';
        return ExitCode::not_converged;
    }
    return ExitCode::ok;
}

}  // namespace delabole
