#include "cases/program/reports/study_reports.hpp"

#include "cases/program/reports/sensitivity_parts.hpp"
#include "fitting/work/words.hpp"
#include "plots/figures/study_figures.hpp"

namespace delabole {

namespace {

std::string account_of(const MechanismRecovery& recovery) {
    std::string text = std::to_string(recovery.counted) + " repetitions count";
    if (recovery.not_converged > 0) {
        text += "; " + std::to_string(recovery.not_converged) + " whose chains did not converge are left out";
    }
    if (recovery.without_truth > 0) {
        text += "; in " + std::to_string(recovery.without_truth) +
                " no truth was found at which the model has answers and the inequalities hold";
    }
    text += recovery.profile_left_out ? "; the observed profile is left out, as its misfit is no probability" : "";
    return text + ".";
}

// "0.4 (-1.2 to 0.9)"
std::string bias_in_words(const Estimate& bias) {
    return number_in_words(bias.value) + " (" + number_in_words(bias.interval_95.lower) + " to " +
           number_in_words(bias.interval_95.upper) + ")";
}

std::string share_in_words(const Estimate& share) {
    return percent(share.value) + " (" + percent_range(share.interval_95) + ")";
}

Json json_of(const ParameterRecovery& parameter) {
    Json json;
    put<&ParameterRecovery::coverage_68, &ParameterRecovery::coverage_95, &ParameterRecovery::bias>(json, parameter);
    json[column_name("mean_standard_deviation", parameter.dimension)] = json_of(parameter.spread, parameter.dimension);
    json["rank_histogram"] = parameter.histogram;
    json["uniform_ranks_differ_by_as_much"] = json_number(parameter.uniformity);
    return json;
}

void write_repetitions(const MechanismRecovery& recovery, const ResultFolder& folder) {
    std::vector<std::string> columns{"status"};
    for (const ParameterRecovery& parameter : recovery.parameters) {
        for (const char* name : {".truth", ".mean", ".standard_deviation"}) {
            columns.push_back(column_name(parameter.name + name, parameter.dimension));
        }
        for (const char* name : {".rank", ".inside_68", ".inside_95"}) {
            columns.push_back(parameter.name + name);
        }
    }
    CsvTable csv(columns);
    for (const Recovered& one : recovery.repetitions) {
        if (!one.has_truth || one.mean.empty()) {
            continue;
        }
        std::vector<Cell> row{std::string(word_of(one.status))};
        for (std::size_t index = 0; index < recovery.parameters.size(); ++index) {
            const ParameterRecovery& parameter = recovery.parameters[index];
            for (const double value : {one.truth[parameter.index], one.mean[index], one.standard_deviation[index]}) {
                row.emplace_back(in_display_unit(value, parameter.dimension));
            }
            for (const int number : {one.rank[index], one.inside_68[index], one.inside_95[index]}) {
                row.emplace_back(static_cast<double>(number));
            }
        }
        csv.add_row(row);
    }
    folder.write("repetitions_" + recovery.name + ".csv", csv.text());
}

void document_mechanism(const MechanismRecovery& recovery, const Sheet& sheet, CsvTable& csv,
                        std::vector<std::vector<std::string>>& screen) {
    sheet.add(Heading{recovery.name, 3});
    sheet.add(Paragraph{account_of(recovery)});
    if (recovery.parameters.empty()) {
        sheet.add(Notice{NoticeKind::warning, "No answer", {"no repetition of " + recovery.name + " counts"}});
        return;
    }
    sheet.draw(coverage_figure(recovery), "coverage_" + recovery.name,
               "Share of the intervals between equal tails that held the truth, with its "
               "95 % interval (Wilson) for so many repetitions.");
    Table table{
        "Coverage, bias and ranks (95 % intervals)",
        {"parameter", "68 % intervals"_number, "95 % intervals"_number, "bias, posterior standard deviations"_number,
         "mean standard deviation"_number, "ranks: chance of as uneven"_number}};
    for (const ParameterRecovery& parameter : recovery.parameters) {
        const std::vector<std::string> row{parameter.name,
                                           share_in_words(parameter.coverage_68),
                                           share_in_words(parameter.coverage_95),
                                           bias_in_words(parameter.bias),
                                           value_in_words(parameter.spread, parameter.dimension),
                                           number_in_words(parameter.uniformity)};
        table.rows.push_back(row);
        screen.push_back({recovery.name + ", " + row[0], row[1], row[2], row[3], row[5]});
        csv.add_row({recovery.name, parameter.name, static_cast<double>(recovery.counted), parameter.coverage_68.value,
                     parameter.coverage_68.interval_95.lower, parameter.coverage_68.interval_95.upper,
                     parameter.coverage_95.value, parameter.coverage_95.interval_95.lower,
                     parameter.coverage_95.interval_95.upper, parameter.bias.value, parameter.bias.interval_95.lower,
                     parameter.bias.interval_95.upper, parameter.uniformity});
    }
    sheet.add(std::move(table));
    for (std::size_t index = 0; index < recovery.parameters.size(); ++index) {
        sheet.draw(rank_figure(recovery, recovery.parameters[index]),
                   "ranks_" + recovery.name + "_" + std::to_string(index + 1),
                   "How many of the draws of its posterior lay below the truth. Truths drawn from the prior have every "
                   "rank equally often; a peak in the middle means that intervals are too wide, peaks at both ends "
                   "that they are too narrow, a slope that they are biased.");
    }
    write_repetitions(recovery, sheet.folder);
}

}  // namespace

StudyDocuments document_recovery(const std::vector<MechanismRecovery>& recoveries, bool at_best, const Sheet& sheet) {
    StudyDocuments documents;
    sheet.add(Heading{"Known parameters found again"});
    sheet.add(Paragraph{
        std::string("Data were made from known parameters, ") +
        (at_best ? "those of the best fit" : "drawn from the prior") +
        ", with the errors that the observations are given, and back-analysed as real data are, time and again. " +
        (at_best ? "What departs from the nominal shares is the influence of the prior and the curvature of the model "
                   "over the posterior."
                 : "Were the sampling at fault, intervals would hold the truth too often or too seldom, and its rank "
                   "among the draws would not be uniform (Talts et al. 2018).")});
    CsvTable csv({"mechanism", "parameter", "repetitions", "coverage_68", "coverage_68_lower", "coverage_68_upper",
                  "coverage_95", "coverage_95_lower", "coverage_95_upper", "bias", "bias_lower", "bias_upper",
                  "uniformity"});
    std::vector<std::vector<std::string>> screen{
        {"mechanism, parameter", "68 % intervals", "95 % intervals", "bias", "ranks"}};
    for (const MechanismRecovery& recovery : recoveries) {
        document_mechanism(recovery, sheet, csv, screen);
        Json& json = documents.json["mechanisms"][recovery.name];
        json["repetitions"] = recovery.counted;
        put<&MechanismRecovery::not_converged, &MechanismRecovery::without_truth, &MechanismRecovery::profile_left_out>(
            json, recovery);
        json["parameters"] = Json::object();
        for (const ParameterRecovery& parameter : recovery.parameters) {
            json["parameters"][parameter.name] = json_of(parameter);
        }
    }
    sheet.write("coverage.csv", csv.text());
    documents.screen = text_table(screen);
    return documents;
}

}  // namespace delabole
