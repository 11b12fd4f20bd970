#include "cases/program/thesis/reproduction.hpp"

#include "cases/program/results/model_reports.hpp"
#include "cases/program/sweeps/sweep_report.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "cases/program/thesis/thesis_tables.hpp"

#include <algorithm>
#include <iterator>

namespace delabole {

namespace {

// A value from elsewhere, derived or found by this program, is computed beside nothing printed, and its source says
// what it agrees with. Else the source is the thesis, which `verify` names in a column of its own.
PrintedRow printed_row_of(const Comparison& comparison) {
    const bool met = comparison.verdict == Verdict::met;
    const bool printed = comparison.source.starts_with("thesis");
    Remark remark = printed && !(met && comparison.expected == "not printed") ? statement(met) : Remark();
    if (!printed) {
        const bool compared = comparison.expected != "not printed";
        remark += compared ? (met ? "agrees with " : "DIFFERS from ") + comparison.expected + ", " : "";
        remark += comparison.source;
    } else if (comparison.verdict == Verdict::unreachable) {
        remark += ": " + comparison.source;
    }
    if (!comparison.note.empty()) {
        remark += (in_words(remark).empty() ? "" : "; ") + comparison.note;
    }
    return {comparison.what, printed ? comparison.expected : "not printed", comparison.computed,
            printed ? comparison.difference : "", remark};
}

void reproduce_data(const CaseFile& file, const std::string& place, const Sheet& sheet, Reproduction& result) {
    sheet.add(Heading{file.title});
    if (!file.description.empty()) {
        sheet.add(Paragraph{file.description});
    }
    // Figures are placed below the table of printed values.
    Report drawn;
    std::vector<Comparison> comparisons = compare_expectations(file);
    if (file.sweeps.empty()) {
        const AnalysisWork work{.watch = [](double, const std::string&, bool) { return !interrupt_flag(); }};
        const CaseAnswer answer = analyse_case(file.model, work);
        stop_if_interrupted();
        sheet.folder.name_figures(place + ": ");
        append_case_figures(file.model, answer, {sheet.folder, drawn});
        sheet.folder.name_figures("");
    }
    std::ranges::move(document_sweeps(file, {.threads = sheet.folder.threads()}, {sheet.folder, drawn}),
                      std::back_inserter(comparisons));
    std::vector<PrintedRow> rows;
    std::ranges::transform(comparisons, std::back_inserter(rows), printed_row_of);
    if (!rows.empty()) {
        sheet.add(printed_table("Printed and computed", rows));
    }
    std::ranges::move(drawn.blocks, std::back_inserter(sheet.report.blocks));
    std::ranges::move(rows, std::back_inserter(result.rows));
}

}  // namespace

Reproduction reproduce_cases(const std::string& folder, const std::vector<std::string>& cases, const std::string& place,
                             const Sheet& sheet) {
    Reproduction result;
    for (const std::string& one : cases) {
        reproduce_data(built_in_case(folder, one), place, sheet, result);
        result.json["cases"].push_back(folder + "/" + one + ".toml");
    }
    return result;
}

ReproductionItem data_item(const std::string& name, const std::string& place, const std::string& meaning,
                           const std::string& folder, const std::vector<std::string>& cases, ReproductionCost cost) {
    const auto reproduce = [folder, cases, place](const Sheet& sheet) {
        return reproduce_cases(folder, cases, place, sheet);
    };
    return {name, place, meaning, reproduce, cost};
}

}  // namespace delabole
