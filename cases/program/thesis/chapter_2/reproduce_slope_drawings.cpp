// Figs 2.1, 2.4 to 2.7, 2.10 and 2.15 of the thesis drawn again from printed numbers and from the models' scenes.
#include "cases/program/models/relaxation/figures.hpp"
#include "cases/program/reader/units.hpp"
#include "cases/program/thesis/chapter_2/chapter_2.hpp"
#include "cases/program/thesis/thesis_tables.hpp"
#include "dynamic_relaxation/scene/slope_scene.hpp"
#include "kinematics/kinematics.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/block_figures.hpp"
#include "plots/figures/stereonet.hpp"
#include "water/column_tilt.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <tuple>
#include <utility>

namespace delabole {

namespace {

// Levels of section 2.2.3, in feet.
constexpr double foot_level = 350;
constexpr double knee_level = 425;
constexpr double top_level = 575;

// Returns the line from the foot of the failure up the lower surface and then the upper one.
Polyline surface(double lower, double upper) {
    const double knee = (knee_level - foot_level) / std::tan(lower);
    return {Point(0, foot_level), Point(knee, knee_level),
            Point(knee + (top_level - knee_level) / std::tan(upper), top_level)};
}

// Figs 2.4 and 2.5 show what the survey leaves open, between the gentlest and the steepest surfaces.
Figure profile_figure() {
    constexpr double left = -30;
    constexpr double right = 240;
    const double boundary_x = surface(degrees(40), degrees(70))[1].x() - 5;
    Figure figure{.title = "Figs 2.4 and 2.5: the failure of 1967",
                  .x = {.title = "distance from the foot", .unit = "ft", .range = std::pair(left, right)},
                  .y = {.title = "level", .unit = "ft", .range = std::pair(340, 640)},
                  .equal_scales = true,
                  .height = 720};
    for (const auto& [level, what] :
         {std::pair{617.3, "617.3 ft: bench 1, cracks"}, std::pair{top_level, "575 ft: third bench"},
          std::pair{475.0, "475 ft: some seepage"}, std::pair{knee_level, "425 ft: seepage"},
          std::pair{foot_level, "350 ft: foot"}}) {
        figure.series.emplace_back(
            Line{.points = {Point(left, level), Point(right, level)}, .colour = Colour::grey, .dash = Dash::dotted});
        figure.labels.push_back({.at = Point(right - 3, level),
                                 .text = what,
                                 .align = Label::Align::right,
                                 .raise = 0.6,
                                 .boxed = false,
                                 .size = 0.8});
    }
    const auto face = [](double angle) {
        return Polyline{Point(0, foot_level), Point((top_level - foot_level) / std::tan(angle), top_level)};
    };
    figure.series.emplace_back(Line{
        .points = surface(degrees(40), degrees(70)), .legend = "failure surface, 40° and 70°", .colour = Colour::blue});
    figure.series.emplace_back(Line{.points = surface(degrees(45), degrees(75)),
                                    .legend = "failure surface, 45° and 75°",
                                    .colour = Colour::vermilion});
    figure.series.emplace_back(
        Line{.points = face(degrees(60)), .legend = "face of the models, 60°", .dash = Dash::dashed});
    figure.series.emplace_back(
        Line{.points = face(degrees(70)), .legend = "face of Fig 2.8, 70°", .dash = Dash::dotted});
    // The boundary was traced north of the fall at 420 ft; that it is the fault at the knee is speculation.
    figure.series.emplace_back(Line{.points = {Point(boundary_x - 60, 360), Point(boundary_x + 50, 470)},
                                    .legend = "green over grey slate, perhaps a fault: 420 ft, 45° to the pit",
                                    .colour = Colour::green});
    return figure;
}

// Fig 2.6 is a plan, with the pit in front: it shows cracks and movements of the crest in their order behind the face,
// which is all that the text tells of their places.
Figure plan_figure() {
    constexpr double right = 10;
    Figure figure{.title = "Fig 2.6: plan of the crest, not to scale", .frame = false, .height = 480};
    figure.x.range = {-0.2, right + 0.2};
    figure.y.range = {-1.2, 10.6};
    const auto along = [&](double from, double to, double at, Colour colour, Dash dash, double width,
                           const std::string& legend) {
        Line line{.legend = legend, .colour = colour, .dash = dash, .width = width};
        constexpr int pieces = 12;
        for (int piece = 0; piece <= pieces; ++piece) {
            line.points.emplace_back(from + (to - from) * piece / pieces,
                                     at + (colour == Colour::vermilion ? 0.12 * (piece % 2) : 0));
        }
        figure.series.emplace_back(line);
    };
    along(0, right, 9.8, Colour::black, Dash::solid, 5, "rear wall");
    along(0, right, 3.6, Colour::black, Dash::dashed, 2.5, "edge of a bench");
    along(0, right, 0.4, Colour::black, Dash::dashed, 2.5, "");
    along(0.4, 9.6, 6.2, Colour::vermilion, Dash::solid, 5, "large tension crack");
    along(1.5, 4.2, 8.8, Colour::vermilion, Dash::solid, 2, "small tension crack");
    along(5.4, 8.6, 8.3, Colour::vermilion, Dash::solid, 2, "");
    along(3.6, 6.4, 1.8, Colour::vermilion, Dash::solid, 2, "");
    for (const auto& [x, y, text] :
         {std::tuple{0.1, 4.2, "bench 1, 617.3 ft"}, {0.1, 1.0, "bench 2"}, {4.8, -0.7, "pit"}, {9.3, 2.3, "N"}}) {
        figure.labels.push_back({.at = Point(x, y), .text = text, .boxed = false, .size = 0.85});
    }
    figure.series.emplace_back(Arrows{.shafts = {{Point(5, 5.6), Point(5, 4.4)}, {Point(7, 5.6), Point(7, 4.4)}},
                                      .legend = "pegs of set 2 near the face: to the pit",
                                      .colour = Colour::blue});
    figure.series.emplace_back(Arrows{.shafts = {{Point(5, 6.8), Point(5, 7.7)}, {Point(7, 6.8), Point(7, 7.7)}},
                                      .legend = "between the cracks: tilts the other way, subsides",
                                      .colour = Colour::green});
    figure.arrows.push_back({.from = Point(8.9, 1.8), .to = Point(9.9, 1.8)});
    return figure;
}

struct CutDirection {
    double dip;  // rad, to the pit
    std::string words;
};

CutDirection direction_of(const SlopeCut& cut) {
    CutDirection direction{0, cut.joint + ", "};
    std::string gouge;
    if (const auto* line = std::get_if<LineCut>(&cut.trace)) {
        const SectionPoint& from = line->vertex.front();
        const SectionPoint& to = line->vertex.back();
        direction.dip = std::atan2(to.y - from.y, to.x - from.x);
        gouge = line->thickness ? ", gouge " + human_number(*line->thickness * 1e3, 2) + " mm" : "";
    } else {
        direction.dip = std::get<JointSetCut>(cut.trace).dip;
    }
    direction.words += human_number(std::abs(direction.dip) / degrees(1), 3) + "°" + gouge;
    return direction;
}

}  // namespace

void add_directions(const RelaxationSlope& slope, Figure& figure) {
    constexpr double half = 0.025;     // m, of a line
    constexpr double between = 0.065;  // m
    std::vector<std::string> named;
    for (const SlopeCut& cut : slope.geometry.cut) {
        if (std::ranges::find(named, cut.joint) != named.end()) {
            continue;
        }
        const CutDirection direction = direction_of(cut);
        const Point middle(-0.175, 0.3 - between * static_cast<double>(named.size()));
        const Point along = half * Point(std::cos(direction.dip), std::sin(direction.dip));
        figure.series.emplace_back(Line{.points = {middle - along, middle + along}, .colour = Colour::vermilion});
        figure.labels.push_back({.at = middle + Point(half + 0.01, 0), .text = direction.words, .size = 0.8});
        named.push_back(cut.joint);
    }
}

namespace {

Figure scene_figure(std::string_view name, const std::string& title) {
    const RelaxationStudy study = slope_model(name);
    const auto& slope = std::get<RelaxationSlope>(study.model.scene);
    const SlopeScene scene = slope_scene(slope);
    BlockDrawing drawing{.title = title};
    for (const SlopeRock& rock : slope.rock) {
        drawing.rocks.push_back(rock.name);
    }
    for (std::size_t block = 0; block < scene.block.size(); ++block) {
        DrawnBlock shown;
        for (const PlanePoint<>& corner : scene.block[block].outline) {
            shown.outline.push_back(corner);
        }
        shown.mode = scene.block[block].fixed ? DrawnMode::fixed : DrawnMode::plain;
        if (!scene.block[block].fixed) {
            shown.rock = scene.rock[block];
        }
        drawing.blocks.push_back(std::move(shown));
    }
    Figure figure = block_figure(drawing);
    add_directions(slope, figure);
    return figure;
}

// Fig 2.7: the column above pushes along joint A, and the rock below the fault pops out along cleavage and joint A.
void add_undercutting(Figure& figure) {
    const auto arrow = [&](const Point& from, const Point& to, const Label& label) {
        figure.arrows.push_back({.from = from, .to = to, .colour = Colour::vermilion});
        figure.labels.push_back(label);
    };
    const Point above(0.176, 0.365);
    arrow(above, above - 0.2 * Point(std::cos(degrees(70)), std::sin(degrees(70))),
          {.at = above, .text = " pushes along joint A", .boxed = false, .size = 0.8});
    const Point head(-0.035, 0.045);
    arrow(Point(0.075, 0.055), head,
          {.at = head, .text = "pops out ", .align = Label::Align::right, .boxed = false, .size = 0.8});
}

// Draws the modelled faults: those into the slope from one point of the face, those to the pit from one of the bottom.
Figure fault_figure() {
    constexpr double height = 343;  // mm, of the models
    constexpr double length = 180;  // of a fault
    const double crest = height / std::tan(degrees(60));
    Figure figure{.title = "Fig 2.10 (b): dips of the faults modelled",
                  .x = {.title = "distance from the toe", .unit = "mm", .range = std::pair(-60, 480)},
                  .y = {.title = "height above the toe", .unit = "mm", .range = std::pair(-20, 380)},
                  .equal_scales = true};
    figure.series.emplace_back(Line{.points = {Point(-60, 0), Point(0, 0), Point(crest, height), Point(480, height)}});
    const auto fault = [&](double dip, const Point& from, double sense, Colour colour) {
        const Point end = from + length * Point(std::cos(degrees(dip)), sense * std::sin(degrees(dip)));
        figure.series.emplace_back(Line{.points = {from, end}, .colour = colour});
        figure.labels.push_back({.at = from + 1.1 * (end - from),
                                 .text = human_number(dip, 2) + "°",
                                 .align = Label::Align::centre,
                                 .boxed = false,
                                 .size = 0.8});
    };
    for (const double dip : {0, 30, 45, 60, 90}) {
        fault(dip, Point(crest * 0.55, height * 0.55), -1, Colour::vermilion);
    }
    for (const double dip : {45, 70}) {
        fault(dip, Point(300, 0), 1, Colour::blue);
    }
    return figure;
}

// Fig 2.15 shows one column of joint A with the water in the joint, and the resultant of water and weight.
Figure water_figure() {
    Figure figure{.title = "Fig 2.15: water in joint A, half and fully saturated",
                  .equal_scales = true,
                  .frame = false,
                  .height = 330};
    auto column = std::get<TiltedColumn<>>(built_in_case("plane_failure", "groundwater_by_tilting").model);
    const Point up(std::cos(column.joint_dip), std::sin(column.joint_dip));  // along the joint
    const Point to_column(-up.y(), up.x());
    const double length = 1 / up.y();
    constexpr double width = 0.24;   // of the column, whose height is 1
    constexpr double weight = 0.55;  // length of its arrow
    Arrows weights{.legend = "weight W"};
    Arrows water{.legend = "water force U", .colour = Colour::blue};
    Arrows resultants{.legend = "their resultant", .colour = Colour::vermilion};
    for (const auto& [filled, left, words] :
         {std::tuple{0.5, 0.0, "half saturated"}, std::tuple{1.0, 1.5, "fully saturated"}}) {
        column.filled_ratio = filled;
        const ColumnTilt answer = analyse(column);
        const Point foot(left, 0);
        const Point across(-width, 0);
        figure.series.emplace_back(Region{
            .outline = {foot, foot + length * up, foot + length * up + across, foot + across}, .colour = Colour::rock});
        figure.series.emplace_back(Line{.points = {foot + length * up, foot}, .width = 3.5});
        // The pressure is drawn on the side of the rock behind the joint.
        figure.series.emplace_back(
            Region{.outline = {foot, foot + filled * length * up, foot - 0.35 * filled * to_column},
                   .legend = left > 0 ? "pressure of the water in joint A" : "",
                   .colour = Colour::sky});
        const Point middle = foot + length / 2 * up + across / 2;
        const Point down(0, -weight);
        const Point push = answer.water_force_over_weight * weight * to_column;
        weights.shafts.push_back({middle, middle + down});
        water.shafts.push_back({middle + down, middle + down + push});
        resultants.shafts.push_back({middle, middle + down + push});
        figure.labels.push_back({.at = foot + Point(0.1, -0.28),
                                 .text = std::string(words) + ": " + human_number(answer.tilt / degrees(1), 3) + "°",
                                 .align = Label::Align::centre,
                                 .boxed = false});
        figure.labels.push_back(
            {.at = foot + length * up + Point(0.03, 0), .text = "joint A, 70°", .raise = -0.6, .boxed = false});
    }
    figure.series.emplace_back(weights);
    figure.series.emplace_back(water);
    figure.series.emplace_back(resultants);
    figure.x.range = {-0.7, 2.4};
    figure.y.range = {-0.4, 1.1};
    return figure;
}

std::string model_name(const std::string& set) {
    std::string name = human_name(set);
    constexpr std::string_view prefix = "joint set ";
    if (name.starts_with(prefix)) {
        name = "joint " + std::string(1, static_cast<char>(std::toupper(name.back())));
    }
    return name;
}

// Fig 2.1 is drawn from the ranges that the text prints, because the poles themselves are not available.
Figure stereonet_figure(const Kinematics& model, const KinematicsResult& sets) {
    StereonetDrawing drawing{.title = "Fig 2.1: joint sets of the west face",
                             .slope = model.slope,
                             .friction_angle = model.strength.friction_angle,
                             .lateral_limit = model.lateral_limit};
    for (std::size_t set = 0; set < sets.joint_set.size(); ++set) {
        const JointSetFeasibility& own = sets.joint_set[set];
        drawing.joint_set.push_back({model_name(own.name), own.mean, sets.sampled[set], sets.sampled_weights[set]});
    }
    return pole_figure(drawing);
}

// Draws the mean planes of the sets in the section across the face, through one point.
Figure traces_figure(const KinematicsResult& sets) {
    Figure figure{.title = "Fig 2.1: mean planes in the section",
                  .x = {.title = "out of the slope to the left", .range = std::pair(-1.6, 1.6)},
                  .y = {.title = "up", .range = std::pair(-1.25, 1.25)},
                  .equal_scales = true};
    constexpr std::array colours{Colour::blue, Colour::vermilion, Colour::green, Colour::orange, Colour::purple};
    std::size_t number = 0;
    for (const JointSetFeasibility& set : sets.joint_set) {
        // A plane that dips to the pit falls to the left.
        const Point along(std::cos(set.apparent_dip), std::sin(set.apparent_dip));
        figure.series.emplace_back(
            Line{.points = {-along, along},
                 .legend = model_name(set.name) + ", " + human_number(set.apparent_dip / degrees(1), 3) + "°",
                 .colour = colours[number % colours.size()],
                 .dash = number < colours.size() - 1 ? Dash::solid : Dash::dashed});
        ++number;
    }
    return figure;
}

// Compares apparent dips of the sets with those of the models; negative dips are into the slope.
void add_traces(const KinematicsResult& sets, double face_dip_direction, const Sheet& sheet, Reproduction& result) {
    struct Printed {
        std::string_view dip;
        std::string remark;
    };
    constexpr std::size_t cleavage = 3;
    const double north_of_the_fall =
        apparent_dip({degrees(10), sets.joint_set[cleavage].mean.dip_direction}, face_dip_direction);
    // The case's sets are joint_set_a, b, c, cleavage and faults, in this order.
    const std::array<Printed, 5> printed{
        {{"70 deg (models)", "the model has the flattest of 70 to 90, that of the upper surface"},
         {"-85 deg (models)", ""},
         {"50 deg (models)", "40 of the field and 10 more for the friction of the mixture"},
         {"-5, -10, -15 deg (models)",
          "as measured throughout the quarry; the 10 deg measured north of the fall give " +
              human_number(north_of_the_fall / degrees(1), 2) + " deg"},
         {"70 to 90 deg", "they go with joint A"}}};
    for (std::size_t set = 0; set < sets.joint_set.size() && set < printed.size(); ++set) {
        const double apparent = sets.joint_set[set].apparent_dip / degrees(1);
        result.add("Fig 2.1: mean of " + model_name(sets.joint_set[set].name) + " in the section",
                   std::string(printed[set].dip), human_number(apparent, 3) + " deg", printed[set].remark);
    }
    sheet.draw(traces_figure(sets), "fig_2_1_traces", "Apparent dips across the face; the pit is to the left.");
}

}  // namespace

Reproduction reproduce_slope_drawings(const Sheet& sheet) {
    Reproduction result;
    const auto study = std::get<KinematicsStudy>(built_in_case("delabole_1967", "delabole_joint_sets").model);
    const KinematicsResult sets = analyse(study);
    sheet.add(Heading{"Figs 2.1, 2.4 to 2.7, 2.10 and 2.15, drawn again"});
    sheet.add(Paragraph{"Fig 2.1 is drawn with poles spread evenly over the ranges of the text."});
    sheet.draw(stereonet_figure(study.model, sets), "fig_2_1", "Poles sampled from the printed ranges.");
    add_traces(sets, study.model.slope.face_dip_direction, sheet, result);
    sheet.draw(profile_figure(), "fig_2_4", "Failure surfaces between the inclinations surveyed.");
    sheet.draw(plan_figure(), "fig_2_6",
               "Which cracks lie on which bench, and how pegs moved, is told by the text "
               "(2.2.3, 2.2.3.4); where along the crest is not printed.");
    struct Drawing {
        std::string_view model;
        std::string title;
        std::string file;
        std::string caption;
    };
    const std::array drawings{
        Drawing{"plate_2_ii", "Figs 2.7 and 2.10 (b): undercutting", "fig_2_7",
                "A fault with gouge, joint A, cleavage."},
        Drawing{"plate_2_iii", "Fig 2.10 (a): joints A, B and cleavage", "fig_2_10_a", "The model of Plate 2.III."},
        Drawing{"plate_2_i", "Fig 2.10 (a): joints A, C and cleavage", "fig_2_10_c", "The model of Plate 2.I."},
        Drawing{"plate_2_vi", "Fig 2.10 (b): joint B ends at a discontinuity", "fig_2_10_b",
                "The model of Plate 2.VI."}};
    for (const Drawing& drawing : drawings) {
        Figure figure = scene_figure(drawing.model, drawing.title);
        if (drawing.file == "fig_2_7") {
            add_undercutting(figure);
        }
        sheet.draw(figure, drawing.file, drawing.caption);
    }
    sheet.draw(fault_figure(), "fig_2_10_faults",
               "Two groups are printed, 0, 30, 45, 60, 90 and 45, 70 deg; of the bars that mark dips into the slope "
               "no more than that of the 45 deg of Plate 2.II is sure. Drawn with the first group into the slope, the "
               "second, as joint A and the boundary of the slates, to the pit.");
    sheet.draw(water_figure(), "fig_2_15",
               "Angles are those of the resultant from the vertical. Forces to scale: U from the tilt of 47.5° when "
               "the joint is full.");
    // The knee lies a third of the way up; between the gentlest and the steepest surfaces the top moves by this much.
    const double wide = surface(degrees(40), degrees(70)).back().x() - surface(degrees(45), degrees(75)).back().x();
    result.add({"top of the failure behind its foot", "40 to 45° and 70 to 75°",
                human_number(surface(degrees(45), degrees(75)).back().x(), 3) + " to " +
                    human_number(surface(degrees(40), degrees(70)).back().x(), 3) + " ft",
                human_number(wide, 2) + " ft", "what the inclinations leave open"});
    sheet.add(printed_table("The printed inclinations", result.rows));
    return result;
}

}  // namespace delabole
