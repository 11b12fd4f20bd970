// Kinematic feasibility: verdicts, tables and stereonets for reports.
#include "cases/program/reader/document.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/results/model_reports.hpp"
#include "fitting/work/words.hpp"
#include "kinematics/kinematics.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/stereonet.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace delabole {

namespace {

// Returns a sentence with the names of the items that can move at their mean orientation.
template <class Items, class Verdict, class Name>
std::string feasible_at_mean(const Items& items, Verdict&& verdict, Name&& name) {
    std::vector<std::string> names;
    for (const auto& item : items) {
        if (verdict(item) == Feasibility::feasible) {
            names.push_back(name(item));
        }
    }
    return names.empty() ? "none" : list_in_words(names);
}

std::string pair_name(const PairFeasibility& pair) {
    return pair.first + " with " + pair.second;
}

void append_summary(Analysis& analysis, const KinematicsResult& result) {
    const auto append = [&](const std::string& name, const std::string& meaning, std::string value) {
        analysis.outputs.push_back({name, meaning, Dimension::ratio, std::move(value)});
    };
    const auto set_name = [](const JointSetFeasibility& set) { return set.name; };
    append("planar_sliding", "sets on whose mean plane a block can slide",
           feasible_at_mean(
               result.joint_set, [](const auto& set) { return set.planar_sliding.at_mean; }, set_name));
    append("wedge_sliding", "pairs of sets between whose mean planes a wedge can slide",
           feasible_at_mean(
               result.pair, [](const auto& pair) { return pair.wedge_sliding.at_mean; }, pair_name));
    append("flexural_toppling", "sets whose layers can topple at their mean orientation",
           feasible_at_mean(
               result.joint_set, [](const auto& set) { return set.flexural_toppling.at_mean; }, set_name));
    append("direct_toppling", "pairs of sets whose mean planes cut columns that can topple",
           feasible_at_mean(
               result.pair, [](const auto& pair) { return pair.direct_toppling; }, pair_name));
}

// An angle rounded to a tenth of a degree; a rounding error becomes 0.
std::string tenths_of_degree(double angle) {
    return human_number(std::round(angle / degrees(0.1)) / 10, 4);
}

// Rounds the error of the conversion from radians, so that whole and half degrees are written as such.
double degrees_to_write(double angle) {
    constexpr double places = 1e12;
    return std::round(angle / degrees(1) * places) / places;
}

std::string degrees_shown(double angle) {
    return tenths_of_degree(angle) + "°";
}

std::string attitude(double inclination, double azimuth) {
    return tenths_of_degree(inclination) + "/" + tenths_of_degree(azimuth);
}

std::string share_shown(double share) {
    return human_number(std::round(share * 1000) / 10, 4) + " %";
}

std::string verdict_shown(Feasibility verdict) {
    return human_name(word_of(verdict));
}

std::string critical_shown(double friction_angle) {
    return friction_angle > 0 ? degrees_shown(friction_angle) : "–";
}

std::string or_dash(const std::string& text) {
    return text.empty() ? "–" : text;
}

Table set_table(const KinematicsResult& result) {
    Table table{"The joint sets at their means, as dip/dip direction, and in the section across the face",
                {"set", "mean"_number, "scatter of the sampled poles"_number, "apparent dip in section"_number}};
    for (const JointSetFeasibility& set : result.joint_set) {
        table.rows.push_back(
            {set.name, attitude(set.mean.dip, set.mean.dip_direction), degrees_shown(set.angular_standard_deviation),
             degrees_shown(std::abs(set.apparent_dip)) + (std::abs(set.apparent_dip) < degrees(0.05) ? ""
                                                          : set.apparent_dip > 0 ? " out of the slope"
                                                                                 : " into the slope")});
    }
    return table;
}

Table mechanism_table(const KinematicsResult& result, const std::string& caption,
                      MechanismFeasibility JointSetFeasibility::*mechanism) {
    Table table{caption, {"set", "at the mean", "feasible below friction of"_number, "share"_number}};
    for (const JointSetFeasibility& set : result.joint_set) {
        const MechanismFeasibility& answer = set.*mechanism;
        table.rows.push_back({set.name, verdict_shown(answer.at_mean), critical_shown(answer.critical_friction_angle),
                              share_shown(answer.feasible_share)});
    }
    return table;
}

Table base_table(const KinematicsResult& result) {
    Table table{"Bases of toppling columns", {"set", "at the mean", "share"_number}};
    for (const JointSetFeasibility& set : result.joint_set) {
        table.rows.push_back({set.name, verdict_shown(set.toppling_base), share_shown(set.toppling_base_share)});
    }
    return table;
}

// Pairs have the numbers of their intersections in the stereonet.
Table wedge_table(const KinematicsResult& result) {
    Table table{"Sliding of wedges, the intersection as plunge/trend",
                {"no.", "pair", "intersection"_number, "at the mean", "carried by", "feasible below friction of"_number,
                 "in balance at friction of"_number, "share"_number}};
    for (std::size_t index = 0; index < result.pair.size(); ++index) {
        const PairFeasibility& pair = result.pair[index];
        const std::string carrier = pair.wedge_contact == SlidingContact::none          ? ""
                                    : pair.wedge_contact == SlidingContact::both_planes ? "both planes"
                                    : pair.wedge_contact == SlidingContact::first_plane ? pair.first
                                                                                        : pair.second;
        table.rows.push_back({std::to_string(index + 1), pair_name(pair),
                              pair.wedge_sliding.at_mean == Feasibility::planes_parallel
                                  ? "–"
                                  : attitude(pair.intersection.plunge, pair.intersection.trend),
                              verdict_shown(pair.wedge_sliding.at_mean), or_dash(carrier),
                              critical_shown(pair.wedge_sliding.critical_friction_angle),
                              critical_shown(pair.wedge_limiting_friction_angle),
                              share_shown(pair.wedge_sliding.feasible_share)});
    }
    return table;
}

Table direct_toppling_table(const KinematicsResult& result) {
    Table table{"Direct toppling of the columns that two sets cut",
                {"no.", "pair", "at the mean", "base", "share"_number}};
    for (std::size_t index = 0; index < result.pair.size(); ++index) {
        const PairFeasibility& pair = result.pair[index];
        table.rows.push_back({std::to_string(index + 1), pair_name(pair), verdict_shown(pair.direct_toppling),
                              or_dash(pair.toppling_base), share_shown(pair.direct_toppling_share)});
    }
    return table;
}

Table zone_table(const Kinematics& model) {
    const std::string friction = degrees_shown(model.strength.friction_angle);
    const LateralLimit& limit = model.lateral_limit;
    return {
        "What the zones and curves mean",
        {{"on the net"}, {"what lies in it"}, {"what it says"}},
        {{"daylight envelope (poles)", "poles of planes that dip out of the slope flatter than the face",
          "the plane comes out in the face: a block on it has room to move"},
         {"friction circle (poles)", "inside: planes that dip less than " + friction, "friction alone holds a block"},
         {"zone of planar sliding (poles)",
          "inside the envelope, outside the circle, within " + degrees_shown(limit.planar_sliding) +
              " of the face's dip direction",
          "a block can slide on the plane"},
         {"zone of flexural toppling (poles)",
          "poles of layers that dip steeply into the slope, within " + degrees_shown(limit.flexural_toppling) +
              " of the face's strike",
          "face dip exceeds 90° less the dip of the layers, plus friction: they can slip over one another and bend out "
          "of the slope"},
         {"primary zone of wedge sliding (intersections)",
          "lines that come out in the face and plunge more than " + friction,
          "a wedge between the two planes can slide; Hocking's test says on which of them"},
         {"secondary zone of wedge sliding (intersections)",
          "lines that plunge less than " + friction + ", but more than a plane that dips with the face by " + friction,
          "a wedge can slide where Hocking's test lets it slide on one plane, and that one dips more than " + friction},
         {"axes of toppling columns (intersections)",
          "lines that plunge into the slope at less than 90° to the face, within " +
              degrees_shown(limit.direct_toppling) + " of it",
          "the columns lean out of the slope; they topple where a third set gives them a base"},
         {"oblique axes (intersections)", "lines that plunge into the slope within " + friction + " of vertical",
          "columns nearly upright: they may topple in any direction that the face leaves free, on a base as above"}}};
}

std::string sets_csv(const KinematicsResult& result) {
    CsvTable csv({"set", "dip_deg", "dip_direction_deg", "apparent_dip_deg", "angular_standard_deviation_deg",
                  "planar_sliding", "planar_sliding_critical_friction_angle_deg", "planar_sliding_feasible_share",
                  "flexural_toppling", "flexural_toppling_critical_friction_angle_deg",
                  "flexural_toppling_feasible_share", "toppling_base", "toppling_base_share"});
    const auto angle = degrees_to_write;
    const auto word = [](Feasibility verdict) { return std::string(word_of(verdict)); };
    for (const JointSetFeasibility& set : result.joint_set) {
        csv.add_row({set.name, angle(set.mean.dip), angle(set.mean.dip_direction), angle(set.apparent_dip),
                     angle(set.angular_standard_deviation), word(set.planar_sliding.at_mean),
                     angle(set.planar_sliding.critical_friction_angle), set.planar_sliding.feasible_share,
                     word(set.flexural_toppling.at_mean), angle(set.flexural_toppling.critical_friction_angle),
                     set.flexural_toppling.feasible_share, word(set.toppling_base), set.toppling_base_share});
    }
    return csv.text();
}

std::string pairs_csv(const KinematicsResult& result) {
    CsvTable csv({"pair", "first", "second", "plunge_deg", "trend_deg", "wedge_sliding", "wedge_contact",
                  "wedge_sliding_critical_friction_angle_deg", "wedge_limiting_friction_angle_deg",
                  "wedge_sliding_feasible_share", "direct_toppling", "toppling_base", "direct_toppling_share"});
    const auto angle = degrees_to_write;
    for (std::size_t index = 0; index < result.pair.size(); ++index) {
        const PairFeasibility& pair = result.pair[index];
        csv.add_row({static_cast<double>(index + 1), pair.first, pair.second, angle(pair.intersection.plunge),
                     angle(pair.intersection.trend), std::string(word_of(pair.wedge_sliding.at_mean)),
                     std::string(word_of(pair.wedge_contact)), angle(pair.wedge_sliding.critical_friction_angle),
                     angle(pair.wedge_limiting_friction_angle), pair.wedge_sliding.feasible_share,
                     std::string(word_of(pair.direct_toppling)), pair.toppling_base, pair.direct_toppling_share});
    }
    return csv.text();
}

StereonetDrawing stereonet_drawing(const Kinematics& model, const KinematicsResult& result) {
    StereonetDrawing drawing{.title = "Joint sets",
                             .slope = model.slope,
                             .friction_angle = model.strength.friction_angle,
                             .lateral_limit = model.lateral_limit,
                             .without_set = result.without_set,
                             .weights_without_set = result.weights_without_set,
                             .measured = result.poles.has_value()};
    for (std::size_t set = 0; set < result.sampled.size(); ++set) {
        const JointSetFeasibility& own = result.joint_set[set];
        drawing.joint_set.push_back({own.name, own.mean, {}, {}});
        // Beside measured poles, sampled ones would be mistaken for measured ones.
        if (own.measured || !drawing.measured) {
            drawing.joint_set.back().planes = result.sampled[set];
            drawing.joint_set.back().weights = result.sampled_weights[set];
        }
    }
    for (std::size_t pair = 0; pair < result.pair.size(); ++pair) {
        if (result.pair[pair].wedge_sliding.at_mean != Feasibility::planes_parallel) {
            drawing.intersection.push_back({std::to_string(pair + 1), result.pair[pair].intersection});
        }
    }
    return drawing;
}

Table statistics_table(const KinematicsResult& result) {
    Table table{"Fisher's statistics of the measured sets",
                {"set", "poles"_number, "mean, dip/dip direction"_number, "K"_number, "95 % bounds of K"_number,
                 "cone that holds the true mean, 95 %"_number, "cone that holds 68 % of the poles"_number}};
    for (const JointSetFeasibility& set : result.joint_set) {
        if (const auto& own = set.measured) {
            table.rows.push_back(
                {set.name, human_number(own->count, 6), attitude(own->mean_dip, own->mean_dip_direction),
                 human_number(own->concentration, 3),
                 human_number(own->lower_concentration, 3) + " to " + human_number(own->upper_concentration, 3),
                 degrees_shown(own->confidence_cone), degrees_shown(own->variability_cone)});
        }
    }
    return table;
}

Table count_table(const PoleCounts& counts, double friction_angle) {
    const std::string friction = degrees_shown(friction_angle);
    const auto row = [](const std::string& what, double count, double of) {
        return std::vector<std::string>{what, human_number(count, 7), human_number(of, 7),
                                        of > 0 ? share_shown(count / of) : "–"};
    };
    return {"Every measured pole, and every line along which two of the planes meet, counted once",
            {"what", "number"_number, "out of"_number, "share"_number},
            {row("poles of planes that can slide", counts.planar_sliding, counts.count),
             row("poles of layers that can topple (flexural)", counts.flexural_toppling, counts.count),
             row("poles of planes that can be a base of direct toppling", counts.toppling_base, counts.count),
             row("lines of wedges that can slide, plunging more than " + friction + " (primary zone)",
                 counts.wedge_sliding - counts.wedge_sliding_secondary, counts.intersections),
             row("lines of wedges that can slide on one plane alone, plunging less (secondary zone)",
                 counts.wedge_sliding_secondary, counts.intersections),
             row("lines that can be the axis of toppling columns", counts.toppling_axis, counts.intersections),
             row("poles that belong to no set", counts.without_set, counts.count)}};
}

Table number_of_sets_table(const KinematicsResult& result) {
    const std::vector<double>& criterion = result.information_criterion;
    const std::size_t taken = result.joint_set.size();
    Table table{
        "Evidence for the number of sets: the least criterion among those whose sets all have three poles or more",
        {"sets"_number, "Bayesian information criterion"_number}};
    const double least = *std::ranges::min_element(criterion);
    for (std::size_t sets = 0; sets < criterion.size(); ++sets) {
        const double above = criterion[sets] - least;
        const std::string because = sets == taken            ? ": taken"
                                    : result.too_small[sets] ? ": a set would have fewer than three poles"
                                                             : "";
        table.rows.push_back({std::to_string(sets), (above > 0 ? "+" + human_number(above, 4) : "least") + because});
    }
    return table;
}

// Quotes the text, if necessary, so that bash reads it as one word of a command line.
std::string in_shell(const std::string& text) {
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/._-";
    if (text.find_first_not_of(plain) == std::string::npos) {
        return text;
    }
    std::string word = "'";
    for (const char letter : text) {
        word += letter == '\'' ? "'\\''" : std::string(1, letter);
    }
    return word + "'";
}

// Lists every measured pole with its set and the set whose mean is nearest.
std::string poles_csv(const Kinematics& model, const KinematicsResult& result) {
    CsvTable csv({"pole", "survey", "dip_deg", "dip_direction_deg", "set", "nearest_set", "angle_to_its_mean_deg"});
    std::size_t pole = 0;
    for (std::size_t survey = 0; survey < model.poles.size(); ++survey) {
        for (const Orientation& plane : model.poles[survey].plane) {
            const auto name_of = [&](std::size_t set) { return result.joint_set[set].name; };
            const std::string names = separated(result.sets_of_pole[pole], "; ", name_of);
            const auto cosine = [&](const JointSetFeasibility& set) {
                return std::abs(upward_normal(plane).dot(upward_normal(set.mean)));
            };
            const auto nearest = std::ranges::max_element(result.joint_set, {}, cosine);
            csv.add_row({static_cast<double>(++pole), static_cast<double>(survey + 1), degrees_to_write(plane.dip),
                         degrees_to_write(plane.dip_direction), names, nearest->name,
                         std::round(std::acos(std::min(1.0, cosine(*nearest))) / degrees(0.01)) / 100});
        }
    }
    return csv.text();
}

// The sets as sections that can be pasted into another case of model kinematics.
std::string sets_to_paste(const KinematicsResult& result) {
    std::string text = "# Sets of a case of model kinematics.\n";
    for (const JointSetFeasibility& set : result.joint_set) {
        text += "\n[[joint_set]]\nname = " + in_quotes(set.name) + "\ndip = \"" + tenths_of_degree(set.mean.dip) +
                " deg\"\ndip_direction = \"" + tenths_of_degree(set.mean.dip_direction) + " deg\"\n";
        if (set.measured && std::isfinite(set.measured->concentration)) {
            text += "concentration = " + human_number(std::min(set.measured->concentration, 1e6), 4) + "\n";
        }
    }
    return text;
}

void append_measured(const Kinematics& model, const KinematicsResult& result, const StereonetDrawing& drawing,
                     const Sheet& sheet) {
    sheet.add(Heading{"Measured poles"});
    sheet.add(count_table(*result.poles, model.strength.friction_angle));
    sheet.add(statistics_table(result));
    if (!result.information_criterion.empty()) {
        sheet.add(number_of_sets_table(result));
    }
    sheet.draw(kamb_figure(drawing), "stereonet_kamb",
               "Contours of the measured poles after Kamb: densities that uniform poles would hardly give.");
    std::vector<Orientation> planes = drawing.without_set;
    std::vector<double> weights = drawing.weights_without_set;
    for (const DrawnJointSet& set : drawing.joint_set) {
        planes.insert(planes.end(), set.planes.begin(), set.planes.end());
        weights.insert(weights.end(), set.weights.begin(), set.weights.end());
    }
    sheet.draw(rosette_figure("Rosette of strikes", planes, weights), "rosette",
               "Strikes of the measured planes in classes of 10°; areas are proportional "
               "to their number, weighted where a scanline is given.");
    sheet.write("sets_to_paste.toml", sets_to_paste(result));
    sheet.write("poles.csv", poles_csv(model, result));
}

}  // namespace

Analysis named_outputs(const KinematicsStudy&, const KinematicsResult& result) {
    Analysis analysis;
    append_summary(analysis, result);
    append_outputs(analysis, result);
    for (std::size_t index = 0; index < result.pair.size(); ++index) {
        if (result.pair[index].wedge_sliding.at_mean == Feasibility::planes_parallel) {
            mark_none(analysis, "pair[" + std::to_string(index + 1) + "].intersection");
        }
    }
    return analysis;
}

HeadCard head_card(const KinematicsStudy&, const KinematicsResult& result) {
    Analysis summary;
    append_summary(summary, result);
    std::vector<std::string> open;
    std::vector<std::string> closed;
    for (const NamedOutput& mechanism : summary.outputs) {
        const std::string& sets = std::get<std::string>(mechanism.value);
        const std::string name = human_name(mechanism.name);
        if (sets == "none") {
            closed.push_back(name);
        } else {
            open.push_back(name + " (" + human_name(sets) + ")");
        }
    }
    HeadCard head{open.empty() ? AnswerTone::good : AnswerTone::bad, {}, {}};
    head.sentences.push_back(open.empty() ? "Geometry and friction leave no movement open."
                                          : "Geometry and friction leave open: " + list_in_words(open) + ".");
    if (!closed.empty() && !open.empty()) {
        head.sentences.push_back("They close: " + list_in_words(closed) + ".");
    }
    head.sentences.emplace_back(
        "This holds for the mean orientations; the tables give the share of each set's spread. Cohesion, water, "
        "spacing, persistence and height are not considered.");
    return head;
}

void append_case_figures(const KinematicsStudy& study, const KinematicsResult& result, const Sheet& sheet) {
    const StereonetDrawing drawing = stereonet_drawing(study.model, result);
    const std::string ground = study.model.slope.upper_surface
                                   ? " The zones are drawn for level ground behind the crest; the verdicts below know "
                                     "the ground that the case gives."
                                   : "";
    sheet.draw(pole_figure(drawing), "stereonet_poles",
               "Poles of the joint sets, their means and the zones in which a pole slides or topples. " +
                   std::string(result.poles ? "The poles are measured; shares of pairs are of planes drawn from "
                                              "both sets independently of each other."
                                            : "The poles are not measurements: they are sampled from what the "
                                              "case says of each set, every set independently of the others.") +
                   ground);
    sheet.add(Heading{"Mean planes and zones"});
    sheet.draw(plane_figure(drawing), "stereonet_planes",
               "Mean planes and the lines along which they meet, numbered as the pairs in "
               "the tables, with the zones of wedges and toppling columns." +
                   ground);
    sheet.add(zone_table(study.model));
    if (result.poles) {
        append_measured(study.model, result, drawing, sheet);
    }
    sheet.add(Heading{"Joint sets"});
    sheet.add(set_table(result));
    sheet.add(
        Paragraph{"A slope cut by these sets, to be run in motion, is written by: delabole init jointed_slope --sets " +
                  in_shell(sheet.folder.path().string()) + " --out my_slope.toml"});
    sheet.add(mechanism_table(result, "Sliding on a plane of one set", &JointSetFeasibility::planar_sliding));
    sheet.add(
        mechanism_table(result, "Flexural toppling of the layers of one set", &JointSetFeasibility::flexural_toppling));
    sheet.add(base_table(result));
    sheet.write("joint_sets.csv", sets_csv(result));
    if (!result.pair.empty()) {
        sheet.add(Heading{"Pairs of joint sets"});
        sheet.add(wedge_table(result));
        sheet.add(direct_toppling_table(result));
    }
    sheet.write("pairs.csv", pairs_csv(result));
}

Impossibility impossibility(const KinematicsStudy&, std::string_view failure) {
    if (failure == word_of(KinematicsCheck::too_many_joint_sets)) {
        return {{"joint_set"}, "at most " + std::to_string(most_joint_sets) + " joint sets"};
    }
    if (failure == word_of(KinematicsCheck::too_many_poles)) {
        return {{"poles"}, "there may be at most " + std::to_string(most_poles) + " poles"};
    }
    return stated_impossibility(KinematicsStudy::kind, failure);
}

}  // namespace delabole
