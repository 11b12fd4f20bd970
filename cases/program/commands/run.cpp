// delabole run
#include "cases/program/case/case_writer.hpp"
#include "cases/program/commands/commands.hpp"
#include "cases/program/models/relaxation/checkpoint_file.hpp"
#include "cases/program/models/stepped_base/bound.hpp"
#include "cases/program/reader/case_error.hpp"
#include "cases/program/reader/units.hpp"
#include "cases/program/reports/sensitivity_step.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/model_reports.hpp"
#include "cases/program/results/problems_of_case.hpp"
#include "cases/program/results/study_output.hpp"
#include "cases/program/sweeps/support_report.hpp"
#include "cases/program/sweeps/sweep_report.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "cases/program/terminal/progress.hpp"
#include "plots/drawing/atomic_file.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <map>
#include <system_error>

namespace delabole {

namespace {

Table output_table(const Analysis& analysis) {
    Table table{"", {"quantity", "value"_number, "meaning"}};
    for (const NamedOutput& output : analysis.outputs) {
        if (!output.detail) {
            table.rows.push_back({output.name, in_table_digits(output.value, output.dimension), output.meaning});
        }
    }
    return table;
}

void write_outputs(const ResultFolder& folder, const Analysis& analysis) {
    CsvTable csv({"quantity", "value", "unit", "meaning"});
    for (const NamedOutput& output : analysis.outputs) {
        const std::string unit(display_unit(output.dimension).symbol);
        if (const auto* number = std::get_if<double>(&output.value)) {
            csv.add_row({output.name, in_display_unit(*number, output.dimension), unit, output.meaning});
        } else {
            csv.add_row({output.name, std::get<std::string>(output.value), std::string(), output.meaning});
        }
    }
    folder.write("results.csv", csv.text());
}

void print(const CaseFile& file, const HeadCard& head, const Analysis& analysis, const ResultFolder& folder,
           const Options& options) {
    std::vector<std::vector<std::string>> rows;
    for (const NamedOutput& output : analysis.outputs) {
        if (!output.detail) {
            rows.push_back({output.name, in_table_digits(output.value, output.dimension)});
        }
    }
    std::cout << title_of(file, options) << '\n';
    for (const std::string& sentence : head.sentences) {
        std::cout << sentence << '\n';
    }
    std::cout << text_table(rows);
    for (const std::string& warning : analysis.warnings) {
        std::cout << "warning: " << warning << '\n';
    }
    std::cout << written_where(folder, options) << "\n\n";
}

void announce(const CaseFile& file, const Options& options) {
    const auto* columns = std::get_if<SteppedBaseStudy<>>(&file.model);
    const std::string text = columns != nullptr && !options.quiet ? announcement(*columns) : "";
    if (!text.empty()) {
        std::cerr << stem_of(file) << ": " << text << '\n';
    }
}

void append_sweeps(const CaseFile& file, const Sheet& sheet, const Options& options, Json& json) {
    if (file.sweeps.empty()) {
        return;
    }
    sheet.add(Heading{"Sweeps"});
    Progress progress(options.quiet);
    const auto tell = [&](double share) { progress.report(share, "sweeps"); };
    const std::vector<Comparison> compared =
        document_sweeps(file, {.threads = options.threads, .progress = tell}, sheet);
    if (!compared.empty()) {
        sheet.add(comparison_table(compared));
        json["printed_and_computed"] = json_of(compared);
    }
}

// One row for each case that was run: its name, its answer and its result folder.
using Overview = std::vector<std::vector<std::string>>;

ExitCode run_one(CaseFile file, const Options& options, Overview& overview) {
    const Stopwatch watch;
    show_units_of(file);
    announce(file, options);
    // The folder is claimed before the work, which may take hours and keeps its checkpoint there.
    ResultFolder folder(options, stem_of(file), OnInterrupt::stop);
    const std::optional<DesignedSupport> support = [&] {
        Progress progress(options.quiet);
        return design_support_of(file, [&](double share) {
            progress.report(share, "patterns of support");
            return !interrupt_flag();
        });
    }();
    stop_if_interrupted();
    const std::filesystem::path checkpoint = folder.path() / "relaxation.checkpoint";
    refuse_link(checkpoint);
    const CaseAnswer answer = [&] {
        Progress progress(options.quiet);
        AnalysisWork work;
        work.watch = [&](double share, const std::string& what, bool may_end_sooner) {
            progress.report(share, what, may_end_sooner);
            return !interrupt_flag();
        };
        if (!options.quiet) {
            work.say = [&](const std::string& text) { std::cerr << stem_of(file) << ": " << text << '\n'; };
        }
        work.threads = static_cast<unsigned>(options.threads);
        work.checkpoint = checkpoint;
        work.between_checkpoints = std::chrono::duration<double>(options.seconds_between_checkpoints);
        return analyse_case(file.model, work);
    }();
    const Analysis analysis = named_outputs(file.model, answer);
    if (!analysis.failure.empty()) {
        throw CaseError({impossible(file, analysis.failure)});
    }
    if (!analysis.unfinished.empty()) {
        folder.when_interrupted(OnInterrupt::finish);
    }
    const Json source = provenance(file, "run", options, watch.seconds());

    Json json = json_of(file, analysis);
    json["provenance"] = source;

    Report own;
    append_case_figures(file.model, answer, {folder, own}, deviations_of(file));
    HeadCard head = head_card(file.model, answer);
    take_picture(own.blocks, head);
    if (support) {
        add_to_head(*support, head);
    }
    Report report{title_of(file, options), file.description, {}};
    report.add(head);
    if (!analysis.unfinished.empty()) {
        report.add(
            Notice{NoticeKind::warning, interrupt_flag() ? "Interrupted" : "Not converged", {analysis.unfinished}});
    }
    if (!analysis.warnings.empty()) {
        report.add(Notice{NoticeKind::warning, "Warnings", analysis.warnings});
    }
    // A relaxation has dozens of outputs, most of which are not the answer, so their table is folded.
    if (std::holds_alternative<RelaxationStudy>(file.model)) {
        own.add(Folded{"All results", {output_table(analysis)}});
    } else {
        report.add(Heading{"Results"});
        report.add(output_table(analysis));
    }
    std::ranges::move(own.blocks, std::back_inserter(report.blocks));
    if (support) {
        json["support_design"] = document_support(*support, {folder, report});
    }
    append_sweeps(file, {folder, report}, options, json);
    append_inputs(file, report);
    report.add(Folded{"Provenance", {provenance_block(source)}});

    folder.write("resolved.toml", resolved_toml(file));
    write_outputs(folder, analysis);
    folder.write_report(report);
    folder.write("result.json", json_text(json));
    overview.push_back({stem_of(file), head.sentences.front(), folder.path().string()});
    if (options.json) {
        std::cout << json_text(json);
    } else if (!options.quiet) {
        print(file, head, analysis, folder, options);
    }
    // Other models have no checkpoint: a file there belongs to an interrupted run, which can still be continued.
    if (!interrupt_flag() && std::holds_alternative<RelaxationStudy>(file.model)) {
        remove_checkpoint(checkpoint);
    }
    if (analysis.unfinished.empty()) {
        return ExitCode::ok;
    }
    std::cerr << "delabole: " << (interrupt_flag() ? "interrupted: " : "not converged: ") << analysis.unfinished
              << '\n';
    std::error_code ignored;
    if (std::filesystem::exists(checkpoint, ignored)) {
        std::cerr << "delabole: the same command goes on from " << checkpoint.string() << '\n';
    }
    return ExitCode::not_converged;
}

// If there are several cases, each gets its own folder inside the one named by --out.
Options with_own_folder(const Options& options, const CaseFile& file, std::size_t cases) {
    Options own = options;
    if (cases > 1 && !options.out.empty()) {
        refuse_as_folder(stem_of(file), "in " + options.out.string() + ": rename " + file.name);
        own.out = options.out / stem_of(file);
        refuse_link(own.out);
    }
    return own;
}

// Two cases with the same name in different folders would write to the same result folder.
void refuse_shared_folders(const std::vector<CaseFile>& files, const Options& options) {
    std::map<std::filesystem::path, const CaseFile*> folders;
    for (const CaseFile& file : files) {
        const std::filesystem::path folder = result_path(with_own_folder(options, file, files.size()), stem_of(file));
        const auto [other, is_new] = folders.emplace(folder, &file);
        if (!is_new) {
            throw UsageError(other->second->name + " and " + file.name + " would both be written into " +
                             folder.string() + ": rename one of them, or run it alone");
        }
    }
}

}  // namespace

ExitCode run_command(const Paths& cases, const Options& options) {
    // All cases are read before the first is analysed, so that a mistake in the last one is reported at once.
    std::vector<CaseFile> files;
    for (const std::filesystem::path& path : cases) {
        files.push_back(read_case(path, settings_of(options)));
    }
    refuse_shared_folders(files, options);
    Overview overview;
    ExitCode worst = ExitCode::ok;
    for (const CaseFile& file : files) {
        try {
            stop_if_interrupted();
            worst = std::max(worst, run_one(file, with_own_folder(options, file, files.size()), overview));
        } catch (const Interrupted&) {
            std::cerr << "delabole: interrupted, " << overview.size() << " of " << files.size()
                      << " cases were analysed\n";
            return ExitCode::not_converged;
        }
    }
    if (files.size() > 1 && !options.json && !options.quiet) {
        std::cout << aligned_columns(overview);
    }
    return worst;
}

}  // namespace delabole
