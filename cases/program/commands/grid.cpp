// delabole grid
#include "cases/program/commands/commands.hpp"
#include "cases/program/reader/document.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/results/study_output.hpp"
#include "cases/program/sweeps/support_report.hpp"
#include "cases/program/sweeps/sweep_report.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "cases/program/terminal/progress.hpp"
#include "fitting/work/bare_number.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>
#include <vector>

namespace delabole {

namespace {

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    while (true) {
        const std::size_t end = std::min(text.find(separator), text.size());
        std::string_view part = text.substr(0, end);
        part.remove_prefix(std::min(part.find_first_not_of(' '), part.size()));
        parts.emplace_back(part.substr(0, part.find_last_not_of(' ') + 1));
        if (end == text.size()) {
            return parts;
        }
        text.remove_prefix(end + 1);
    }
}

// A number unchanged, any other text in quotes.
std::string toml_value(const std::string& text) {
    return bare_number(text) ? text : in_quotes(text);
}

// Turns input=from:to[:points] or input=value,value,... into an element of sweep.vary.
std::string vary_of(const std::string& option) {
    const std::size_t equals = option.find('=');
    const std::string values = equals == std::string::npos ? "" : option.substr(equals + 1);
    const std::vector<std::string> range = split(values, ':');
    const std::vector<std::string> list = split(values, ',');
    std::string text = "{ input = " + in_quotes(option.substr(0, equals));
    if (equals != std::string::npos && (range.size() == 2 || range.size() == 3)) {
        text += ", from = " + toml_value(range[0]) + ", to = " + toml_value(range[1]);
        text += range.size() == 3 ? ", points = " + toml_value(range[2]) : "";
    } else if (range.size() == 1 && list.size() > 1) {
        text += ", values = [" + separated(list, ", ", toml_value) + "]";
    } else {
        throw UsageError("--vary " + option +
                         ": is neither input=from:to:points, as strength.cohesion=\"0 kPa:50 kPa:11\", nor "
                         "input=value,value");
    }
    return text + " }";
}

// The sweep given on the command line, which replaces those of the case.
Setting sweep_of(const Options& options) {
    if (options.vary.empty() || options.vary.size() > 2) {
        throw UsageError("grid: needs one or two --vary");
    }
    const std::vector<std::string> outputs =
        options.outputs.empty() ? std::vector<std::string>{"factor_of_safety"} : options.outputs;
    const std::string curves = separated(outputs, ", ", [](const std::string& output) {
        return "{ label = " + in_quotes(output) + ", output = " + in_quotes(output) + " }";
    });
    return {"sweep",
            "[{ name = \"grid\", vary = [" + separated(options.vary, ", ", vary_of) + "], curve = [" + curves + "] }]"};
}

// Does work with the sweep; errors in the sweep are reported for the options that it was made from.
template <class Work>
auto with_sweep(const Options& options, const Work& work) {
    try {
        return work();
    } catch (const CaseError& error) {
        std::vector<Problem> problems = error.problems();
        for (Problem& problem : problems) {
            for (std::size_t index = 0; index < options.vary.size(); ++index) {
                if (problem.key.starts_with("sweep[1]." + indexed("vary", index))) {
                    problem.file = "--vary";
                    problem.key = options.vary[index].substr(0, options.vary[index].find('='));
                    problem.value = "";
                }
            }
            if (problem.key == "sweep.output") {
                problem = {"--output " + problem.value, 0, 0, {}, {}, problem.message};
            }
        }
        throw CaseError(std::move(problems));
    }
}

// "Factor of safety against water depth"
std::string grid_title(const CaseSweep& sweep) {
    const auto output = [](const SweepCurve& curve) { return human_name(curve.output); };
    const auto input = [](const SweptInput& swept) {
        return human_name(swept.input.substr(swept.input.rfind('.') + 1));
    };
    return capitalised(separated(sweep.curves, ", ", output) + " against " + separated(sweep.vary, " and ", input));
}

// Finds where a curve over one input passes a level, by linear interpolation between its points.
std::vector<double> crossings_of(const SweptCurve& curve, const std::vector<double>& inputs, double level) {
    std::vector<double> crossings;
    for (std::size_t place = 1; place < inputs.size(); ++place) {
        const double from = curve.values[place - 1] - level;
        const double to = curve.values[place] - level;
        if (std::isfinite(from) && std::isfinite(to) && (from < 0) != (to < 0)) {
            crossings.push_back(inputs[place - 1] + (inputs[place] - inputs[place - 1]) * from / (from - to));
        }
    }
    return crossings;
}

// "Factor of safety 0.53 to 1.25; 1 at water.water_depth = 2.1 m."
HeadCard grid_answer(const SweepRun& run) {
    constexpr std::size_t most_sentences = 3;
    HeadCard head;
    for (const SweptCurve& curve : run.figures.front().curves) {
        std::vector<double> found;
        std::ranges::copy_if(curve.values, std::back_inserter(found),
                             [](double value) { return std::isfinite(value); });
        const std::string name = capitalised(human_name(curve.label));
        if (head.sentences.size() == most_sentences || found.empty()) {
            continue;
        }
        const auto [least, greatest] = std::ranges::minmax(found);
        std::string answer = name + " " + value_in_words(least, curve.dimension) +
                             (least < greatest ? " to " + value_in_words(greatest, curve.dimension) : "");
        const SweptInput& first = run.sweep.vary.front();
        if (curve.label == "factor_of_safety") {
            head.tone = least >= 1 ? AnswerTone::good : greatest < 1 ? AnswerTone::bad : AnswerTone::open;
            if (run.sweep.vary.size() == 1) {
                for (const double at : crossings_of(curve, first.values, 1)) {
                    answer += "; 1 at " + first.input + " = " + value_in_words(at, first.dimension);
                }
            }
        }
        head.sentences.push_back(answer + ".");
    }
    if (head.sentences.empty()) {
        head.sentences.emplace_back("No point has an answer.");
    }
    return head;
}

}  // namespace

ExitCode grid_command(const std::filesystem::path& path, const Options& options) {
    const Stopwatch watch;
    std::vector<Setting> settings = settings_of(options);
    settings.push_back(sweep_of(options));
    CaseFile file = with_sweep(options, [&] { return read_case(path, settings); });
    show_units_of(file);
    const std::optional<DesignedSupport> support = design_support_of(file, [](double) { return !interrupt_flag(); });
    CaseSweep& sweep = file.sweeps.front();
    sweep.title = grid_title(sweep);
    sweep.caption = "All points are in grid.csv.";
    const ResultFolder folder(options, stem_of(file) + "_grid", OnInterrupt::stop);
    const SweepRun run = with_sweep(options, [&] {
        Progress progress(options.quiet);
        return run_sweep(file, sweep, {.threads = options.threads, .progress = [&](double share) {
                                           progress.report(share, "points of the grid");
                                       }});
    });
    Report report{title_of(file, options), file.description, {}};
    Report own;
    document_sweep(run, {folder, own});
    HeadCard head = grid_answer(run);
    if (support) {
        add_to_head(*support, head);
    }
    take_picture(own.blocks, head);
    report.add(head);
    std::ranges::move(own.blocks, std::back_inserter(report.blocks));
    append_inputs(file, report);
    Json json;
    json["status"] = "ok";
    json["title"] = file.title;
    json["model"] = std::string(model_name(file.model));
    json["points"] = json_of(run);
    json["provenance"] = provenance(file, "grid", options, watch.seconds());
    const std::size_t points = run.figures.front().curves.front().values.size();
    const std::string of_support = support ? support->sentence + '\n' : "";
    return write_study({file, json, screen_of(run) + of_support + std::to_string(points) + " points in grid.csv\n", ""},
                       folder, options, report);
}

}  // namespace delabole
