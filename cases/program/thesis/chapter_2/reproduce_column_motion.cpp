// Groundwater on one column in motion, 2.3.5 of the thesis: runs the tests of groundwater_tests.csv on a belt, and
// compares them with observations 1 to 4.
#include "cases/program/models/relaxation/figures.hpp"
#include "cases/program/thesis/chapter_2/chapter_2.hpp"
#include "cases/program/thesis/chapter_5/relaxation_drawing.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace delabole {

namespace {

// Tests are compared when the column has moved by this mean displacement.
constexpr double compared_displacement = 0.003;  // m
// Rotations that differ by less are taken to be alike, a judgement.
constexpr double alike = degrees(0.1);

struct ColumnMotion {
    GroundwaterTest test;
    SlopeRun run;
    std::optional<double> time = {};  // s, to the mean movement compared; absent: the column does not get there
    double rotation = 0;              // rad, mean out of the slope at that time, or at the end
    double leaves = 0;                // rad, from joint A out of the slope to the direction of its mean movement
};

struct Means {
    double displacement = 0;
    double rotation = 0;
    Point movement = Point::Zero();
};

Means means_of(const Bodies& bodies, const MotionFrame& frame) {
    Means means;
    double mass = 0;
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        if (bodies.fixed[block] == 0) {
            mass += bodies.mass[block];
            means.displacement += bodies.mass[block] * frame.outcome[block].displacement;
            means.rotation += bodies.mass[block] * frame.outcome[block].rotation;
            means.movement += bodies.mass[block] * Point(frame.motion[block].x, frame.motion[block].y);
        }
    }
    return {means.displacement / mass, means.rotation / mass, means.movement / mass};
}

// Returns the mean rotation out of the slope at a time of the run.
double rotation_at(const ColumnMotion& motion, double time) {
    const Bodies bodies = make_bodies(motion.run.run.scene);
    double rotation = 0;
    for (const MotionFrame& frame : motion.run.run.frames) {
        if (frame.time > time) {
            break;
        }
        rotation = means_of(bodies, frame).rotation;
    }
    return rotation;
}

RelaxationStudy study_of(const GroundwaterTest& test) {
    RelaxationStudy study = slope_model("groundwater_column");
    auto& slope = std::get<RelaxationSlope>(study.model.scene);
    slope.tilt = test.rotation;
    slope.rock.front().density = test.density;
    for (SlopeJoint& joint : slope.joint) {
        joint.strength.friction_angle = test.friction();
    }
    return study;
}

ColumnMotion move(const GroundwaterTest& test) {
    ColumnMotion motion{test, run_slope(study_of(test))};
    const Bodies bodies = make_bodies(motion.run.run.scene);
    Means before;
    double time_before = 0;
    for (const MotionFrame& frame : motion.run.run.frames) {
        const Means now = means_of(bodies, frame);
        if (now.displacement >= compared_displacement) {
            const double share =
                (compared_displacement - before.displacement) / (now.displacement - before.displacement);
            motion.time = time_before + share * (frame.time - time_before);
            motion.rotation = before.rotation + share * (now.rotation - before.rotation);
            motion.leaves = joint_a_dip - std::atan2(-now.movement.y(), -now.movement.x());
            return motion;
        }
        before = now;
        time_before = frame.time;
        motion.rotation = now.rotation;
    }
    return motion;
}

// Finds the test of that material and rotation whose friction is near enough.
const ColumnMotion& find(const std::vector<ColumnMotion>& motions, std::string_view material, double friction,
                         double rotation) {
    return *std::ranges::find_if(motions, [&](const ColumnMotion& motion) {
        return motion.test.material == material && std::abs(motion.test.friction() - friction) < degrees(0.6) &&
               std::abs(motion.test.rotation - rotation) < degrees(0.1);
    });
}

std::string time_in_words(const ColumnMotion& motion) {
    return motion.time ? human_number(*motion.time, 3) + " s" : "rests";
}

std::string rotation_in_words(const ColumnMotion& motion) {
    return motion.time ? human_number(motion.rotation / degrees(1), 2) + "°" : "rests";
}

bool quicker(const ColumnMotion& one, const ColumnMotion& other) {
    constexpr double never = 1e9;
    return one.time.value_or(never) < other.time.value_or(never);
}

// `needed` are the tests that must reach the compared displacement; otherwise there is nothing to compare.
void compare(Reproduction& result, const std::string& what, const std::string& printed, const std::string& computed,
             const std::vector<const ColumnMotion*>& needed, bool met) {
    const bool comparable =
        std::ranges::all_of(needed, [](const ColumnMotion* motion) { return motion->time.has_value(); });
    result.add(what, printed, computed, comparable ? statement(met) : Remark("not compared: it comes to rest"));
}

// At one movement, where the last is said to topple most.
void compare_rotations(Reproduction& result, const std::string& what, const std::string& printed,
                       const std::vector<const ColumnMotion*>& motions) {
    std::vector<std::string> words;
    std::ranges::transform(motions, std::back_inserter(words), [](const auto* one) { return rotation_in_words(*one); });
    const double more = motions.back()->rotation - motions.front()->rotation;
    compare(result, what, printed, list_in_words(words), motions, more > 0);
    if (std::abs(more) < alike && result.rows.back().remark.verdict != RowVerdict::none) {
        result.rows.back().remark =
            "not compared: they differ by less than " + human_number(alike / degrees(1), 2) + "°";
    }
}

}  // namespace

Reproduction reproduce_column_motion(const Sheet& sheet) {
    const std::vector<GroundwaterTest> tests = rows_of<GroundwaterTest>();
    std::vector<ColumnMotion> motions(tests.size());
    run_part(sheet.folder, {"columns", 0, 1}, tests.size(),
             [&](std::size_t index) { motions[index] = move(tests[index]); });
    constexpr double plain = degrees(43);
    constexpr double once = degrees(29.5);
    constexpr double twice = degrees(19);
    constexpr double half = degrees(12);
    constexpr double full = degrees(47.5);
    const auto at = [&](std::string_view material, double friction, double rotation) -> const ColumnMotion& {
        return find(motions, material, friction, rotation);
    };
    Reproduction result;
    const auto times = [&](const ColumnMotion& one, const ColumnMotion& other) {
        return time_in_words(one) + " against " + time_in_words(other);
    };
    for (const double rotation : {0.0, half}) {
        const std::string water = rotation > 0 ? "half saturated" : "dry";
        const ColumnMotion& heavy = at("mixture", mixture_friction, rotation);
        const ColumnMotion& light = at("cork", plain, rotation);
        compare(result, "1: mixture against cork, " + water + ": time", "mixture quicker", times(heavy, light),
                {&heavy, &light}, quicker(heavy, light));
        compare_rotations(result, "1: mixture against cork, " + water + ": rotation", "cork topples more",
                          {&heavy, &light});
    }
    for (const auto& [material, friction] : {std::pair{"mixture", mixture_friction}, std::pair{"cork", plain}}) {
        compare(result, std::string("2: ") + material + ", half saturated against dry: time", "half saturated quicker",
                times(at(material, friction, half), at(material, friction, 0)), {&at(material, friction, half)},
                quicker(at(material, friction, half), at(material, friction, 0)));
        const ColumnMotion& wet = at(material, friction, full);
        compare(result, std::string("2: ") + material + ", fully saturated: movement out of the joint",
                "another picture: it hangs over",
                human_number(wet.leaves / degrees(1), 2) + "°, half saturated " +
                    human_number(at(material, friction, half).leaves / degrees(1), 2) + "°",
                {&wet}, wet.leaves > at(material, friction, half).leaves + degrees(10));
    }
    const ColumnMotion& wet_cork = at("cork", plain, half);
    const ColumnMotion& dry_cork = at("cork", plain, 0);
    // The photographs were taken at regular intervals of time.
    const double dry_then = rotation_at(dry_cork, wet_cork.time.value_or(0));
    compare(result, "2: cork, half saturated against dry: rotation at one time", "topples more",
            rotation_in_words(wet_cork) + " against " + human_number(dry_then / degrees(1), 2) + "°", {&wet_cork},
            wet_cork.rotation > dry_then + alike);
    for (const double rotation : {0.0, half}) {
        const std::string water = rotation > 0 ? "half saturated" : "dry";
        const std::array by_friction{&at("cork", twice, rotation), &at("cork", once, rotation),
                                     &at("cork", plain, rotation)};
        compare(result, "3: cork, " + water + ", friction 19, 29.5 and 43°: time", "less friction, faster",
                list_in_words(
                    {time_in_words(*by_friction[0]), time_in_words(*by_friction[1]), time_in_words(*by_friction[2])}),
                {by_friction[0], by_friction[1]},
                std::ranges::is_sorted(by_friction, [](const ColumnMotion* one, const ColumnMotion* other) {
                    return quicker(*one, *other);
                }));
        compare_rotations(result, "4: likewise: rotation", "more friction, more toppling",
                          {by_friction.begin(), by_friction.end()});
    }
    sheet.add(Heading{"Groundwater on one column in motion (2.3.5)"});
    sheet.add(
        Paragraph{"One column of joint A, cut by joint B and the cleavage, on a belt whose direction is turned for the "
                  "water. The shape of the thesis's column is not printed. Compared at a mean movement of 3 mm."});
    sheet.add(printed_table("Observations 1 to 4", result.rows));
    std::vector<Figure> figures;
    std::vector<std::string> files;
    for (const ColumnMotion& motion : motions) {
        const std::string friction = human_number(motion.test.friction() / degrees(1), 3);
        const double turned = motion.test.rotation / degrees(1);
        figures.push_back(
            moved_slope_figure(motion.run.run, motion.run.run.frames[motion.run.early_frame], motion.run.end,
                               "Plate " + motion.test.plate + ": " + motion.test.material + ", friction " + friction +
                                   "°, turned by " + human_number(turned, 3) + "°"));
        files.push_back("column_" + motion.test.material + "_" +
                        std::to_string(std::lround(motion.test.friction() / degrees(1))) + "_" +
                        std::to_string(static_cast<int>(turned)));
    }
    set_one_scale(figures);
    for (std::size_t index = 0; index < figures.size(); ++index) {
        sheet.draw(figures[index], files[index],
                   "When half of what fails in the end has begun to. Moved by 3 mm after " +
                       time_in_words(motions[index]) + ", turned by " + rotation_in_words(motions[index]) + ".");
    }
    return result;
}

}  // namespace delabole
