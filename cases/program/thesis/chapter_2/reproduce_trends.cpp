// Figs 2.11 to 2.14 of the thesis as trends: how much of the slope of Plate 2.III fails as its dimensions are changed,
// one, two or several at a time, with rank correlations, beside conclusions (i) to (iv) of 2.3.4.
#include "cases/program/thesis/chapter_2/chapter_2.hpp"
#include "fitting/probability/moments.hpp"
#include "plots/drawing/text.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace delabole {

namespace {

constexpr double duration = 0.8;  // s; the belt runs by 16 cm
// The slopes of one geometry differ in where their joints run, since the thesis does not print where they were cut.
constexpr std::size_t members = 4;

struct Trial {
    double slope_angle = degrees(60);
    double cleavage_dip = degrees(5);
    double cleavage_spacing = 0.02;  // m, as those of the joints
    double joint_a_spacing = 0.05;
    double joint_b_spacing = 0.025;
    // This dip is into the slope; a model with a fault is that of Plate 2.VI, and the rest stays as it is there.
    std::optional<double> fault_dip = {};
};

JointSetCut& set_of(RelaxationSlope& slope, std::string_view name) {
    const auto cut = std::ranges::find(slope.geometry.cut, name, &SlopeCut::name);
    return std::get<JointSetCut>(cut->trace);
}

// Rotates the fault of Plate 2.VI about the point where it daylights in the face.
void turn_fault(double dip, RelaxationSlope& slope) {
    const SectionPoint& crest = slope.geometry.outline.back();
    const auto fault = std::ranges::find(slope.geometry.cut, "discontinuity", &SlopeCut::name);
    std::vector<SectionPoint>& line = std::get<LineCut>(fault->trace).vertex;
    const double level = line.front().y;
    const double out = level / crest.y * crest.x;
    for (SectionPoint& end : line) {
        const double along = end.x - out;
        end = {out + along * std::cos(dip), level - along * std::sin(dip)};
    }
}

RelaxationStudy study_of(const Trial& trial) {
    RelaxationStudy study = slope_model(trial.fault_dip ? "plate_2_vi" : "plate_2_iii");
    study.settings->duration = duration;
    // Joints that cross anywhere leave sharp blocks, which softer contacts would press through their neighbours.
    study.settings->stiffness_ratio = 5000;
    study.ensemble = EnsembleRequest{static_cast<double>(members), {}, {}};
    auto& slope = std::get<RelaxationSlope>(study.model.scene);
    // From 25 deg on the model of Plate 2.III fails as the thesis's did (plate_2_iii.toml).
    for (SlopeJoint& joint : slope.joint) {
        if (joint.name != "frame") {
            joint.strength.friction_angle = degrees(25);
        }
    }
    if (trial.fault_dip) {
        turn_fault(*trial.fault_dip, slope);
        return study;
    }
    set_of(slope, "joint A").spacing = trial.joint_a_spacing;
    set_of(slope, "joint B").spacing = trial.joint_b_spacing;
    JointSetCut& cleavage = set_of(slope, "cleavage");
    cleavage.dip = -trial.cleavage_dip;
    cleavage.spacing = trial.cleavage_spacing;
    // The last corner is the crest.
    SectionPoint& crest = slope.geometry.outline.back();
    crest.x = crest.y / std::tan(trial.slope_angle);
    return study;
}

struct Response {
    double failed_columns;
    double surface_angle;
    double failed_width;  // m
};

// Returns nothing if the run was stopped without an answer.
std::optional<Response> respond(const Trial& trial, std::size_t member) {
    const RelaxationRun made = run(member_of(study_of(trial), member));
    if (!made.post_failure || made.result.outcome == RelaxationOutcome::overlap_too_large) {
        return {};
    }
    const PostFailureAnswer& answer = made.post_failure->answer;
    return Response{answer.failed_width * std::sin(joint_a_dip) / trial.joint_a_spacing, answer.lower_angle,
                    answer.failed_width};
}

struct Spread {
    double mean;
    double deviation;  // standard
};

Spread spread_of(const std::vector<Response>& responses, double Response::*value) {
    std::vector<double> values;
    std::ranges::transform(responses, std::back_inserter(values), value);
    return {mean_of(values), values.size() < 2 ? 0 : deviation_of(values)};
}

struct Variation {
    std::string parameter;  // as trends.csv has it; of several at once, none of its
    std::string figure;
    std::string name;
    std::string unit;
    std::vector<double> value;  // in that unit
    std::vector<Trial> trial;
    std::vector<std::vector<Response>> response = {};  // of the members that have one
};

constexpr std::size_t points = 5;
using Values = std::array<double, points>;

// The values are those listed in 2.3.3 and some between them.
constexpr Values cleavage_spacings{10, 15, 20, 30, 40};
constexpr Values cleavage_dips{5, 7.5, 10, 12.5, 15};
constexpr Values varied_slope_angles{50, 60, 65, 70, 75};
constexpr Values a_spacings{25, 33, 40, 50, 66};
constexpr Values b_spacings{20, 25, 33, 40, 50};

void set_cleavage_spacing(Trial& trial, std::size_t index) {
    trial.cleavage_spacing = 1e-3 * cleavage_spacings[index];
}
void set_cleavage_dip(Trial& trial, std::size_t index) {
    trial.cleavage_dip = degrees(cleavage_dips[index]);
}
void set_slope_angle(Trial& trial, std::size_t index) {
    trial.slope_angle = degrees(varied_slope_angles[index]);
}
void set_a_spacing(Trial& trial, std::size_t index) {
    trial.joint_a_spacing = 1e-3 * a_spacings[index];
}
void set_b_spacing(Trial& trial, std::size_t index) {
    trial.joint_b_spacing = 1e-3 * b_spacings[index];
}

std::vector<Variation> all_series() {
    std::vector<Variation> series;
    const auto vary = [&](const std::string& parameter, const std::string& figure, const std::string& name,
                          const std::string& unit, const Values& values,
                          const std::vector<std::function<void(Trial&, std::size_t)>>& changes) {
        Variation made{parameter, figure, name, unit, {values.begin(), values.end()}, std::vector<Trial>(points)};
        for (std::size_t index = 0; index < points; ++index) {
            for (const auto& change : changes) {
                change(made.trial[index], index);
            }
        }
        series.push_back(std::move(made));
    };
    const std::string single = "Figs 2.11 and 2.12";
    vary("cleavage_spacing", single, "cleavage spacing", "mm", cleavage_spacings, {set_cleavage_spacing});
    vary("cleavage_inclination", single, "cleavage inclination", "deg", cleavage_dips, {set_cleavage_dip});
    vary("slope_angle", single, "slope angle", "deg", varied_slope_angles, {set_slope_angle});
    vary("joint_a_spacing", single, "joint A spacing", "mm", a_spacings, {set_a_spacing});
    vary("joint_b_spacing", single, "joint B spacing", "mm", b_spacings, {set_b_spacing});
    // It is not legible which way the faults of the thesis dip.
    const auto vary_fault = [&](const std::string& name, double way, const Values& dips) {
        vary("fault_inclination", single, name, "deg", dips,
             {[=](Trial& trial, std::size_t index) { trial.fault_dip = way * degrees(dips[index]); }});
    };
    vary_fault("fault inclination into the slope", 1, {0, 30, 45, 60, 70});
    vary_fault("fault inclination to the pit", -1, {0, 10, 20, 30, 45});
    vary("slope_angle", "Fig 2.13", "slope angle, cleavage spacing growing", "deg", varied_slope_angles,
         {set_slope_angle, set_cleavage_spacing});
    vary("joint_a_spacing", "Fig 2.13", "joint A spacing, cleavage inclination growing", "mm", a_spacings,
         {set_a_spacing, set_cleavage_dip});
    vary("", "Fig 2.14", "spacings of A and B, constant cleavage", "mm", a_spacings, {set_a_spacing, set_b_spacing});
    vary("", "Fig 2.14", "spacings of A and B, cleavage inclination growing", "mm", a_spacings,
         {set_a_spacing, set_b_spacing, set_cleavage_dip});
    return series;
}

std::vector<double> means_of(const Variation& series, double Response::*value) {
    std::vector<double> means;
    for (const std::vector<Response>& responses : series.response) {
        means.push_back(spread_of(responses, value).mean);
    }
    return means;
}

// Differences of the means below a tenth of a column, or below 2 deg, do not count.
PrintedChange change_of(const std::vector<double>& response, const RankCorrelation& rank, double notable) {
    const auto [least, greatest] = std::ranges::minmax_element(response);
    if (*greatest - *least < notable || rank.significance > 0.1) {
        return PrintedChange::none;
    }
    return rank.value > 0 ? PrintedChange::rises : PrintedChange::falls;
}

// A slight change is one by less than half.
bool agrees(PrintedChange printed, PrintedChange found, const std::vector<double>& response) {
    const auto [least, greatest] = std::ranges::minmax_element(response);
    return printed == found ||
           (printed == PrintedChange::falls_slightly && found == PrintedChange::falls && *least > *greatest / 2);
}

void add_trend(const PrintedTrend& printed, const Variation& series, Reproduction& result) {
    const bool of_columns = printed.response == "failed_columns";
    const auto response = of_columns ? &Response::failed_columns : &Response::surface_angle;
    const double unit = of_columns ? 1 : degrees(1);
    std::vector<double> values = means_of(series, response);
    std::ranges::transform(values, values.begin(), [&](double value) { return value / unit; });
    double variance = 0;  // between slopes of one geometry, the mean over the geometries
    std::vector<double> varied;
    std::vector<double> of_slopes;
    for (std::size_t index = 0; index < points; ++index) {
        const std::vector<Response>& slopes = series.response[index];
        variance += std::pow(spread_of(slopes, response).deviation / unit, 2) / points;
        varied.insert(varied.end(), slopes.size(), series.value[index]);
        std::ranges::transform(slopes, std::back_inserter(of_slopes), response);
    }
    const RankCorrelation rank = rank_correlation(varied, of_slopes);
    const PrintedChange change = change_of(values, rank, of_columns ? 0.1 : 2);
    const bool met = agrees(printed.change, change, values);
    const auto [least, greatest] = std::ranges::minmax_element(values);
    result.add(series.figure + ", (" + printed.conclusion + ") " + series.name + ": " + human_name(printed.response),
               human_name(word_of(printed.change)),
               human_name(word_of(change)) + ": " + human_number(values.front(), 2) + " to " +
                   human_number(values.back(), 2) + ", between " + human_number(*least, 2) + " and " +
                   human_number(*greatest, 2),
               statement(met) + ": rank correlation " + human_number(rank.value, 2) + ", significance " +
                   human_number(rank.significance, 2) + " (of 0.1) over all slopes" +
                   (met ? ""
                        : "; the means differ by " + human_number(*greatest - *least, 2) +
                              (of_columns ? " of a column, of which the thesis counted whole ones" : "") +
                              ", slopes whose joints run elsewhere by " + human_number(std::sqrt(variance), 2) +
                              " (standard deviation)") +
                   (printed.doubt.empty() ? "" : "; in the thesis too: " + printed.doubt));
}

// Beside its drawings Fig 2.14 states how wide the failure is at the crest.
void add_widths(const Variation& constant, const Variation& growing, Reproduction& result) {
    const auto mean = [](const Variation& series) { return mean_of(means_of(series, &Response::failed_width)); };
    const double one = mean(constant);
    const double other = mean(growing);
    result.add("Fig 2.14: failed width, cleavage inclination constant / growing", "120 to 150 / 65 to 80 mm",
               human_number(one * 1e3, 3) + " / " + human_number(other * 1e3, 3) + " mm",
               std::string(other < one ? "less" : "NOT less") +
                   " where the inclination grows, as printed; the widths cannot be compared, because what "
                   "else was varied is not printed");
}

// A figure shows this response over the varied value.
struct Drawn {
    double Response::*value;
    double unit;
    Axis axis;
};

Figure figure_of(const Variation& series, const Drawn& drawn) {
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    Figure figure{
        .title = series.figure + ": " + series.name, .x = {.title = series.name, .unit = series.unit}, .y = drawn.axis};
    Line means{.legend = "mean, and standard deviation between slopes"};
    Line bars{.width = 1.5};
    Points singles{.legend = "slopes whose joints run elsewhere", .colour = Colour::vermilion, .size = 0.8};
    for (std::size_t index = 0; index < series.value.size(); ++index) {
        const double at = series.value[index];
        const Spread spread = spread_of(series.response[index], drawn.value);
        const double mean = spread.mean / drawn.unit;
        const double deviation = spread.deviation / drawn.unit;
        means.points.emplace_back(at, mean);
        bars.points.insert(bars.points.end(),
                           {Point(at, mean - deviation), Point(at, mean + deviation), Point(at, nothing)});
        for (const Response& response : series.response[index]) {
            singles.points.emplace_back(at, response.*drawn.value / drawn.unit);
        }
    }
    figure.series = {bars, means, singles};
    return figure;
}

}  // namespace

RankCorrelation rank_correlation(const std::vector<double>& parameter, const std::vector<double>& response) {
    const auto changes = [](const std::vector<double>& values) {
        return std::ranges::adjacent_find(values, std::ranges::not_equal_to{}) != values.end();
    };
    if (!changes(parameter) || !changes(response)) {
        return {0, 1};
    }
    const std::size_t count = parameter.size();
    std::vector<double> ranks(2 * count);
    const double value = gsl_stats_spearman(parameter.data(), 1, response.data(), 1, count, ranks.data());
    const double freedom = static_cast<double>(count) - 2;
    const double unexplained = std::max(1 - value * value, std::numeric_limits<double>::min());
    return {value, 2 * gsl_cdf_tdist_Q(std::abs(value) * std::sqrt(freedom / unexplained), freedom)};
}

Reproduction reproduce_trends(const Sheet& sheet) {
    std::vector<Variation> series = all_series();
    const std::vector<PrintedTrend> trends = rows_of<PrintedTrend>();
    std::vector<std::optional<Response>> made(series.size() * points * members);
    run_part(sheet.folder, {"slopes", 0, 1}, made.size(), [&](std::size_t task) {
        const std::size_t trial = task / members;
        made[task] = respond(series[trial / points].trial[trial % points], task % members);
    });
    Reproduction result;
    Table table{"Mean of " + std::to_string(members) + " slopes and their standard deviation, after 16 cm of belt.",
                {"parameter", "value"_number, "slopes"_number, "failed columns of joint A"_number,
                 "their width, mm"_number, "angle of the lower surface, °"_number}};
    std::size_t stopped = 0;
    for (std::size_t index = 0; index < series.size(); ++index) {
        Variation& one = series[index];
        one.response.resize(points);
        for (std::size_t trial = 0; trial < points; ++trial) {
            std::vector<Response>& responses = one.response[trial];
            for (std::size_t member = 0; member < members; ++member) {
                if (const auto& response = made[(index * points + trial) * members + member]) {
                    responses.push_back(*response);
                }
            }
            stopped += members - responses.size();
            const auto words = [&](double Response::*value, double unit) {
                const Spread spread = spread_of(responses, value);
                return human_number(spread.mean / unit, 3) + " ± " + human_number(spread.deviation / unit, 2);
            };
            table.rows.push_back({one.name, human_number(one.value[trial], 3) + " " + one.unit,
                                  std::to_string(responses.size()), words(&Response::failed_columns, 1),
                                  words(&Response::failed_width, 1e-3), words(&Response::surface_angle, degrees(1))});
            result.json["runs"][one.name].push_back(
                {{"value", one.value[trial]},
                 {"slopes", responses.size()},
                 {"failed_columns", spread_of(responses, &Response::failed_columns).mean},
                 {"failed_columns_deviation", spread_of(responses, &Response::failed_columns).deviation},
                 {"surface_angle_deg", spread_of(responses, &Response::surface_angle).mean / degrees(1)}});
        }
        for (const PrintedTrend& printed : trends) {
            if (printed.parameter == one.parameter) {
                add_trend(printed, one, result);
            }
        }
    }
    add_widths(series[series.size() - 2], series.back(), result);
    sheet.add(Heading{"Figs 2.11 to 2.14: what dimensions of the slope do (2.3.4)"});
    sheet.add(Paragraph{
        "The significance is that of the rank correlation over all slopes of a parameter. Above 0.1, or where the "
        "means differ by less than a tenth of a column or 2 deg, no change is stated. Joints have 25° of friction, "
        "with which the model of Plate 2.III fails as the thesis's did. The fault is that of Plate 2.VI, on which "
        "joint B ends, turned about where it comes out in the face; which way the faults dip is not legible, nor what "
        "was varied together in Figs 2.13 and 2.14. The thesis counted whole columns of mostly two slopes and could "
        "not see less than half of one. Runs that stopped without an answer: " +
        std::to_string(stopped) + " of " + std::to_string(made.size()) + "."});
    sheet.add(printed_table("Conclusions (i) to (iv)", result.rows));
    sheet.add(table);
    // One vertical axis in all figures of a response.
    const auto range = [&](double Response::*value, double unit) {
        double top = 0;
        for (const std::optional<Response>& response : made) {
            top = std::max(top, response ? 1.1 * (*response).*value / unit : 0);
        }
        return std::pair(-0.05 * top, top);
    };
    const Drawn columns{&Response::failed_columns,
                        1,
                        {.title = "failed columns of joint A", .range = range(&Response::failed_columns, 1)}};
    const Drawn angle{
        &Response::surface_angle,
        degrees(1),
        {.title = "angle of the lower surface", .unit = "deg", .range = range(&Response::surface_angle, degrees(1))}};
    const std::string slopes = " of " + std::to_string(members) + " slopes at each value.";
    for (std::size_t index = 0; index < series.size(); ++index) {
        const std::string name = "trend_" + std::to_string(index + 1);
        sheet.draw(figure_of(series[index], columns), name, "Failed columns at the ground" + slopes);
        // Conclusion (iv) is on this angle.
        if (std::ranges::any_of(trends, [&](const PrintedTrend& printed) {
                return printed.parameter == series[index].parameter && printed.response != "failed_columns";
            })) {
            sheet.draw(figure_of(series[index], angle), name + "_angle", "Angle of the lower surface" + slopes);
        }
    }
    return result;
}

}  // namespace delabole
