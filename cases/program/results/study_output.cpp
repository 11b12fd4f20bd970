#include "cases/program/results/study_output.hpp"

#include "cases/program/case/case_writer.hpp"

#include <iostream>

namespace delabole {

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
        std::cout << report.title << '\n'
                  << output.screen << (options.no_report ? "results in " : "report in ")
                  << (options.no_report ? folder.path() : folder.path() / "report.html").string() << '\n';
    }
    if (!output.reserved.empty()) {
        std::cerr << "delabole: " << output.reserved << '\n';
        return ExitCode::not_converged;
    }
    return ExitCode::ok;
}

}  // namespace delabole
