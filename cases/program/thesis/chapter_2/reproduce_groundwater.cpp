// Groundwater on one column, 2.3.5 of the thesis: what statics says of its tests and observations 1 to 4.
//
// A column lies on joint A, dip d. The model is turned by t, so that its weight W has the direction of the resultant of
// weight and water. Normal and tangential force on the joint are then W cos(d + t) and W sin(d + t); what drives the
// column, over its weight, is sin(d + t) - cos(d + t) tan(phi). On the belt velocities stand for accelerations. From
// d + t = 90 deg on the joint presses no longer: the column leaves it and hangs over.
#include "cases/program/thesis/chapter_2/chapter_2.hpp"
#include "cases/program/thesis/physical_models.hpp"
#include "fitting/work/words.hpp"
#include "limit_equilibrium/block_row/single_block.hpp"
#include "plots/drawing/text.hpp"
#include "water/column_tilt.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace delabole {

namespace {

constexpr double gravity = 9.81;

bool leaves_joint(double rotation) {
    return joint_a_dip + rotation >= degrees(90);
}

double driving_force(double rotation, double friction) {
    const double dip = joint_a_dip + rotation;
    return std::sin(dip) - std::cos(dip) * std::tan(friction);
}

double driving_force(const GroundwaterTest& test) {
    return driving_force(test.rotation, test.friction());
}

std::vector<GroundwaterTest> tests_with(std::string_view material, double rotation) {
    std::vector<GroundwaterTest> found;
    for (const GroundwaterTest& test : rows_of<GroundwaterTest>()) {
        if (test.material == material && std::abs(test.rotation - rotation) < degrees(0.1)) {
            found.push_back(test);
        }
    }
    return found;
}

Table tests_table(const std::vector<GroundwaterTest>& tests) {
    Table table{"Forces on joint A over the weight of the column",
                {"material", "friction, deg"_number, "rotation, deg"_number, "normal force"_number,
                 "driving force"_number, "plate"}};
    for (const GroundwaterTest& test : tests) {
        const bool leaves = leaves_joint(test.rotation);
        table.rows.push_back({test.material,
                              number_in_words(test.friction_least / degrees(1)) + " to " +
                                  number_in_words(test.friction_most / degrees(1)),
                              number_in_words(test.rotation / degrees(1)),
                              leaves ? "none" : human_number(std::cos(joint_a_dip + test.rotation), 3),
                              leaves ? "leaves the joint" : human_number(driving_force(test), 3), test.plate});
    }
    return table;
}

Figure driving_figure(const std::vector<GroundwaterTest>& tests) {
    constexpr std::array colours{Colour::blue, Colour::vermilion, Colour::green, Colour::purple};
    Figure figure{.title = "2.3.5: what drives a joint-A column",
                  .x = {.title = "rotation of the model", .unit = "deg"},
                  .y = {.title = "driving force over weight"}};
    std::vector<double> frictions;
    Points points{.legend = "tests"};
    for (const GroundwaterTest& test : tests) {
        const double friction = test.friction();
        if (std::ranges::find(frictions, friction) == frictions.end()) {
            Line line{.legend = test.material + ", friction " + human_number(friction / degrees(1), 3) + "°",
                      .colour = colours[frictions.size() % colours.size()]};
            for (int step = 0; step <= 100; ++step) {
                const double rotation = (degrees(90) - joint_a_dip) * step / 100;
                line.points.emplace_back(rotation / degrees(1), driving_force(rotation, friction));
            }
            figure.series.emplace_back(line);
            frictions.push_back(friction);
        }
        if (!leaves_joint(test.rotation)) {
            points.points.emplace_back(test.rotation / degrees(1), driving_force(test));
        }
    }
    figure.series.emplace_back(points);
    return figure;
}

SingleBlock column_on_plane(double inclination, double slenderness, double friction, double density) {
    SingleBlock block{};
    block.block = {.height = 1, .width = std::tan(slenderness), .unit_weight = density * gravity};
    block.base = {inclination, friction, 0};
    return block;
}

int toppling_rank(BlockMotion motion) {
    return motion == BlockMotion::slides ? 0 : motion == BlockMotion::slides_and_topples ? 1 : 2;
}

struct TopplingOrder {
    int examined = 0;  // shapes and inclinations at which the block moves at every friction
    int changes = 0;   // of these, with more toppling at more friction
    int exceptions = 0;
};

// Computes the onset of motion of single blocks of all shapes on all inclinations, at increasing friction.
TopplingOrder toppling_order(const std::vector<double>& frictions) {
    TopplingOrder order;
    for (int inclination = 4; inclination < 90; inclination += 2) {
        for (int slenderness = 2; slenderness < 90; slenderness += 2) {
            std::vector<int> ranks;
            for (const double friction : frictions) {
                const BlockMotion motion =
                    analyse(column_on_plane(degrees(inclination), degrees(slenderness), friction, 300)).onset_mode;
                if (motion != BlockMotion::stable) {
                    ranks.push_back(toppling_rank(motion));
                }
            }
            if (ranks.size() == frictions.size()) {
                ++order.examined;
                order.changes += ranks.back() > ranks.front() ? 1 : 0;
                order.exceptions += std::ranges::is_sorted(ranks) ? 0 : 1;
            }
        }
    }
    return order;
}

void add_observation_1(const GroundwaterTest& mixture, const GroundwaterTest& cork, Reproduction& result) {
    const double quicker = driving_force(mixture) / driving_force(cork) - 1;
    result.add("1: friction 40 to 41 against 42 to 44 deg, dry", "mixture fails quicker",
               human_number(100 * quicker, 2) + " % more driving force",
               statement(quicker > 0) + " in sense by the friction, as is cork's toppling by 4");
    result.json["mixture_over_cork"] = quicker;
}

void add_observation_2(const ColumnTilt& full, Reproduction& result) {
    for (const std::string_view material : {"mixture", "cork"}) {
        const GroundwaterTest dry = tests_with(material, 0).front();
        const GroundwaterTest half = tests_with(material, degrees(12)).front();
        const double dry_force = driving_force(dry);
        const double half_force = driving_force(half);
        result.add("2: " + std::string(material) + ", half saturated", "fails quicker than dry",
                   human_number(dry_force, 3) + " dry, " + human_number(half_force, 3) + " half saturated",
                   statement(half_force > dry_force) + " (driving force over weight)");
        result.json["driving_force"][std::string(material)] = {{"dry", dry_force}, {"half_saturated", half_force}};
    }
    // Water force U on the joint takes the place of its reaction where U = W cos d; U grows with the square of the
    // depth.
    const double leaving = std::sqrt(std::cos(joint_a_dip) / full.water_force_over_weight);
    result.add("2: fully saturated", "column hangs over",
               "U / W = " + human_number(full.water_force_over_weight, 3) +
                   ", cos 70 deg = " + human_number(std::cos(joint_a_dip), 3),
               statement(full.water_force_over_weight > std::cos(joint_a_dip)) +
                   ": water lifts the column off the joint once it is filled to " + human_number(100 * leaving, 3) +
                   " %");
    result.json["water_force_over_weight"] = full.water_force_over_weight;
    result.json["leaves_joint_at_filled_ratio"] = leaving;
}

void add_observation_3(Reproduction& result) {
    for (const double rotation : {0.0, 12.0}) {
        std::vector<GroundwaterTest> tests = tests_with("cork", degrees(rotation));
        std::ranges::sort(tests, std::ranges::greater{}, &GroundwaterTest::friction);
        std::vector<std::string> words;
        std::vector<double> forces;
        for (const GroundwaterTest& test : tests) {
            forces.push_back(driving_force(test));
            words.push_back(human_number(forces.back(), 3) + " at " + human_number(test.friction() / degrees(1), 3) +
                            " deg");
        }
        result.add("3: cork, " + number_in_words(rotation) + " deg of rotation", "less friction, faster",
                   list_in_words(words), statement(std::ranges::is_sorted(forces)));
    }
}

void add_observation_4(Reproduction& result) {
    std::vector<double> frictions;
    for (const GroundwaterTest& test : tests_with("cork", 0)) {
        frictions.push_back(test.friction());
    }
    std::ranges::sort(frictions);
    const TopplingOrder order = toppling_order(frictions);
    result.add("4: single blocks of any shape on any plane", "more friction, more toppling",
               "more in " + std::to_string(order.changes) + ", less in " + std::to_string(order.exceptions) + " of " +
                   std::to_string(order.examined),
               statement(order.exceptions == 0 && order.changes > 0) +
                   ": onset of motion at frictions of 19, 29.5 and 43 deg");
    result.json["toppling_order"] = {
        {"examined", order.examined}, {"changes", order.changes}, {"exceptions", order.exceptions}};
}

}  // namespace

Reproduction reproduce_groundwater(const Sheet& sheet) {
    const std::vector<GroundwaterTest> tests = rows_of<GroundwaterTest>();
    const ColumnTilt full = analyse(TiltedColumn<>{joint_a_dip, degrees(47.5), 1.0});
    Reproduction result;
    add_observation_1(tests_with("mixture", 0).front(), tests_with("cork", 0).front(), result);
    add_observation_2(full, result);
    add_observation_3(result);
    add_observation_4(result);
    sheet.add(Heading{"Groundwater on one column (2.3.5)"});
    sheet.add(Paragraph{
        "The column lies on joint A and the model is turned by the angle that stands for the water. Observations 1 to "
        "3 are of speed; velocities on the belt stand for accelerations, hence for the driving force. How much of a "
        "movement is toppling depends on the blocks that the column is cut into, which are not printed: observation 4 "
        "is held against single blocks of every shape."});
    sheet.add(printed_table("Observations 1 to 4", result.rows));
    sheet.add(tests_table(tests));
    sheet.draw(driving_figure(tests), "groundwater_driving_force",
               "Driving force over weight; at 20 deg of rotation the column leaves the joint.");
    return result;
}

}  // namespace delabole
