#include "cases/program/reports/study_reports.hpp"

#include "cases/program/case/case_writer.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/reader/units.hpp"
#include "fitting/work/words.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

std::string in_words(ConclusionVerdict verdict) {
    return verdict == ConclusionVerdict::partly       ? "confirmed in part"
           : verdict == ConclusionVerdict::not_tested ? "not tested"
                                                      : std::string(word_of(verdict));
}

bool is_probability(const ConclusionTest& test) {
    return std::holds_alternative<ClaimOfMechanisms>(test.of);
}

std::string limit_in_words(const ConclusionTest& test) {
    return (test.relation == Relation::at_least ? "at least " : "at most ") +
           value_in_words(test.limit, test.dimension);
}

std::string value_in_words(const ConclusionTest& test, const TestFinding& finding) {
    if (std::isnan(finding.value)) {
        return "";
    }
    if (is_probability(test)) {
        return number_in_words(finding.value) + " \u00b1 " + number_in_words(2 * finding.standard_error);
    }
    const auto shown = [&](double value) {
        constexpr double rounding = 1e-9;  // of the limit: what is less is none
        return value_in_words(std::abs(value) < rounding * std::abs(test.limit) ? 0 : value, test.dimension);
    };
    const std::string middle = shown(finding.value);
    return finding.draws - finding.without_answer < 2
               ? middle
               : middle + " (" + shown(finding.interval_68.lower) + " to " + shown(finding.interval_68.upper) + ")";
}

std::string holding_in_words(const TestFinding& finding) {
    if (finding.draws == 0) {
        return "";
    }
    std::string text =
        std::to_string(finding.holding) + " of " + std::to_string(finding.draws - finding.without_answer);
    if (finding.without_answer > 0) {
        text += ", " + std::to_string(finding.without_answer) + " without answer";
    }
    return finding.improbable
               ? text + "; but its mechanism has a probability of " + number_in_words(*finding.improbable)
               : text;
}

std::string on_screen(const ConclusionTest& test, const TestFinding& finding) {
    const std::string holding = holding_in_words(finding);
    return "  " + test.claim + ": " + value_in_words(test, finding) + (holding.empty() ? "" : ", in " + holding);
}

std::string asked_in_words(const ConclusionTest& test) {
    const auto* claim = std::get_if<ClaimOfQuantity>(&test.of);
    return claim != nullptr ? claim->mechanism + ": " + claim->quantity
                            : "probability of " + list_in_words(std::get<ClaimOfMechanisms>(test.of).mechanisms);
}

// Names what would decide a test that is undecided or was not made.
std::string decision_of(const ConclusionTest& test, const TestFinding& finding) {
    const auto* claim = std::get_if<ClaimOfQuantity>(&test.of);
    const std::vector<std::string> asked =
        claim != nullptr ? std::vector{claim->mechanism} : std::get<ClaimOfMechanisms>(test.of).mechanisms;
    if (finding.verdict == ConclusionVerdict::not_tested) {
        return "a fit of " + list_in_words(asked) + " (--with-costly)";
    }
    if (claim == nullptr || finding.improbable) {
        return "evidence that tells " + list_in_words(asked) + " from the other mechanisms";
    }
    if (!finding.decider) {
        return "no parameter of " + claim->mechanism + " alone";
    }
    const auto shown = [&](double value) { return value_in_words(value, finding.decider->dimension); };
    return finding.decider->parameter + " of " + claim->mechanism + ", known better: it holds at about " +
           shown(finding.decider->where_it_holds) + ", not at about " + shown(finding.decider->where_it_fails);
}

// Names what would decide the tests of a conclusion, each once; empty if the conclusion is decided.
std::string decision_of(const Conclusion& conclusion, const ConclusionFinding& finding) {
    if (finding.verdict != ConclusionVerdict::undecided && finding.verdict != ConclusionVerdict::not_tested) {
        return {};
    }
    std::vector<std::string> deciding;
    for (std::size_t number = 0; number < conclusion.tests.size(); ++number) {
        const ConclusionVerdict verdict = finding.tests[number].verdict;
        if (verdict == ConclusionVerdict::undecided || verdict == ConclusionVerdict::not_tested) {
            const std::string one = decision_of(conclusion.tests[number], finding.tests[number]);
            if (std::ranges::find(deciding, one) == deciding.end()) {
                deciding.push_back(one);
            }
        }
    }
    return deciding.empty() ? "a test: this case has none of it" : separated(deciding, "; ");
}

Json json_of(const ConclusionTest& test, const TestFinding& finding) {
    Json json;
    json["claim"] = test.claim;
    json["asked"] = asked_in_words(test);
    json["verdict"] = word_of(finding.verdict);
    json["relation"] = word_of(test.relation);
    json["unit"] = display_unit(test.dimension).symbol;
    json["limit"] = json_of(test.limit, test.dimension);
    json["value"] = json_of(finding.value, test.dimension);
    if (is_probability(test)) {
        json["standard_error"] = json_number(finding.standard_error);
    } else {
        put<&TestFinding::draws, &TestFinding::without_answer, &TestFinding::holding>(json, finding);
    }
    return json;
}

}  // namespace

StudyDocuments document_conclusions(const std::vector<Conclusion>& conclusions,
                                    const std::vector<ConclusionFinding>& findings, const Sheet& sheet) {
    StudyDocuments documents;
    sheet.add(Heading{"Conclusions held against the fit"});
    Table table{"What was concluded",
                {"conclusion", "statement", "by this fit", "what would decide it", "source", "note"}};
    Table tests{
        "The median over draws of the posterior, with the range of 68 % of them (of all "
        "where they are fewer than twenty)",
        {"conclusion", "claim", "asked", "found", "claimed", "holds in", "verdict"}};
    CsvTable csv({"conclusion", "claim", "asked", "value", "limit", "relation", "unit", "draws", "holding", "verdict"});
    std::vector<std::vector<std::string>> screen{{"conclusion", "by this fit", "statement"}};
    for (std::size_t index = 0; index < conclusions.size(); ++index) {
        const Conclusion& conclusion = conclusions[index];
        const std::string verdict = in_words(findings[index].verdict);
        const std::string decision = decision_of(conclusion, findings[index]);
        table.rows.push_back(
            {conclusion.label, conclusion.statement, verdict, decision, conclusion.source, conclusion.note});
        screen.push_back({conclusion.label, verdict, conclusion.statement});
        Json& json = documents.json[conclusion.label];
        json["statement"] = conclusion.statement;
        json["verdict"] = word_of(findings[index].verdict);
        json["would_decide"] = decision;
        json["tests"] = Json::array();
        for (std::size_t number = 0; number < conclusion.tests.size(); ++number) {
            const ConclusionTest& test = conclusion.tests[number];
            const TestFinding& finding = findings[index].tests[number];
            if (!std::isnan(finding.value)) {
                screen.push_back({"", in_words(finding.verdict), on_screen(test, finding)});
            }
            tests.rows.push_back({conclusion.label, test.claim, asked_in_words(test), value_in_words(test, finding),
                                  limit_in_words(test), holding_in_words(finding), in_words(finding.verdict)});
            json["tests"].push_back(json_of(test, finding));
            csv.add_row({conclusion.label, test.claim, asked_in_words(test),
                         in_display_unit(finding.value, test.dimension), in_display_unit(test.limit, test.dimension),
                         std::string(word_of(test.relation)), std::string(display_unit(test.dimension).symbol),
                         static_cast<double>(finding.draws), static_cast<double>(finding.holding),
                         std::string(word_of(finding.verdict))});
        }
        if (!decision.empty()) {
            screen.push_back({"", "would decide it", decision});
        }
    }
    sheet.write("conclusions.csv", csv.text());
    sheet.add(std::move(table));
    if (!tests.rows.empty()) {
        sheet.add(Folded{"How each was tested", {std::move(tests)}});
    }
    documents.screen = '\n' + aligned_columns(screen);
    return documents;
}

}  // namespace delabole
