#include "cases/program/results/study_output.hpp"

#include "cases/program/case/case_writer.hpp"
#include "fitting/work/words.hpp"

#include <iostream>

namespace delabole {

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
        report.blocks.emplace_back(Paragraph{sentence});
    }
}

std::string written_where(const ResultFolder& folder, const Options& options) {
    return options.no_report ? "results in " + folder.path().string()
                             : "report in " + (folder.path() / "report.html").string();
}

void add_reservation(const std::string& reserved, bool interrupted, Report& report) {
    if (!reserved.empty()) {
        report.blocks.emplace_back(
            Notice{NoticeKind::warning, interrupted ? "Interrupted" : "Not converged", {reserved}});
    }
}

ExitCode write_study(const StudyOutput& output, const ResultFolder& folder, const Options& options, Report& report) {
    report.blocks.emplace_back(Folded{"Provenance", {provenance_block(output.json["provenance"])}});
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
