#include "cases/program/thesis/chapter_2/chapter_2.hpp"

#include "cases/program/thesis/thesis_tables.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace delabole {

namespace {

std::string in_degrees(double angle) {
    return human_number(angle / degrees(1), 3) + "°";
}

std::string in_millimetres(double length) {
    return human_number(length * 1e3, 2) + " mm";
}

// 2.2.3: the lower surface dips 40 to 45 deg up to level 425 ft, a third of the way from 350 to 575 ft, the upper one
// 70 to 75. The rough survey allows 5 deg either way, and 0.1 of the height. `partly`: the lower surface rises into the
// slope, 15 deg gentler than the upper one. A failure of under a hundredth of the height's square is none.
void score_profile(const PostFailure& end, FieldScore& score) {
    constexpr double tolerance = degrees(5);
    constexpr double third = 1.0 / 3;
    const double height = slope_height(end);
    const PostFailureAnswer& answer = end.answer;
    const double knee = answer.knee_level / height;
    if (answer.failed_area < 0.01 * height * height) {
        score.profile = FieldVerdict::no;
        score.profile_in_words = "nothing failed";
        return;
    }
    const bool lower = answer.lower_angle > degrees(40) - tolerance && answer.lower_angle < degrees(45) + tolerance;
    const bool upper = answer.upper_angle > degrees(70) - tolerance && answer.upper_angle < degrees(75) + tolerance;
    const bool level = std::abs(knee - third) < 0.1;
    const bool two_surfaces = answer.lower_angle > 0 && answer.lower_angle < answer.upper_angle - degrees(15);
    score.profile = lower && upper && level ? FieldVerdict::yes
                    : two_surfaces          ? FieldVerdict::partly
                                            : FieldVerdict::no;
    score.profile_in_words = in_degrees(answer.lower_angle) + " up to " + human_number(knee, 2) + " of the height, " +
                             in_degrees(answer.upper_angle) + " above";
}

// Counts the cracks along toppling joints, which dip steeply into the slope.
std::ptrdiff_t toppling_cracks(const PostFailure& early) {
    return std::ranges::count_if(early.crack, [](const CrestCrack& crack) { return crack.dip < -degrees(45); });
}

// 2.2.3 and 2.4.1 describe several open cracks, parallel to the toppling joints.
void score_cracks(const PostFailure& early, FieldScore& score) {
    const std::ptrdiff_t open = toppling_cracks(early);
    const auto others = static_cast<std::ptrdiff_t>(early.crack.size()) - open;
    score.cracks = open >= 2 ? FieldVerdict::yes : open == 1 ? FieldVerdict::partly : FieldVerdict::no;
    score.cracks_in_words = std::to_string(open) + " steeply into the slope, " + std::to_string(others) + " others";
}

// 2.2.3.4: rock near the face moves to the pit; the wedge between the cracks tilts the other way and subsides.
void score_movements(const PostFailure& early, FieldScore& score) {
    if (toppling_cracks(early) < 2) {
        score.movements = FieldVerdict::no;
        score.movements_in_words = "no two such cracks with a wedge between";
        return;
    }
    const PostFailureAnswer& answer = early.answer;
    const int met = (answer.near_face.horizontal < 0 ? 1 : 0) + (answer.between_cracks.rotation < 0 ? 1 : 0) +
                    (answer.between_cracks.vertical < 0 ? 1 : 0);
    score.movements = met == 3 ? FieldVerdict::yes : met > 0 ? FieldVerdict::partly : FieldVerdict::no;
    score.movements_in_words = "near the face " + in_millimetres(-answer.near_face.horizontal) +
                               " to the pit; between the cracks " + in_millimetres(-answer.between_cracks.vertical) +
                               " down, turned " + in_degrees(-answer.between_cracks.rotation) + " into the slope";
}

}  // namespace

RelaxationStudy slope_model(std::string_view name, const std::vector<Setting>& settings) {
    return std::get<RelaxationStudy>(built_in_case("thesis/chapter_2", name, settings).model);
}

SlopeRun run_slope(RelaxationStudy study) {
    SlopeRun made{std::move(study), {}, {}, 0, {}};
    StudyWork work;
    work.frames = KeepFrames::yes;
    made.run = run(made.study, work);
    made.end = made.run.post_failure.value_or(PostFailure{});
    made.early = made.run.early_failure.value_or(made.end);
    const auto& frames = made.run.frames;
    const auto later =
        std::ranges::find_if(frames, [&](const MotionFrame& frame) { return frame.time > made.run.early_time; });
    made.early_frame = later == frames.begin() ? 0 : static_cast<std::size_t>(later - frames.begin()) - 1;
    return made;
}

double slope_height(const PostFailure& failure) {
    double lowest = failure.crest.y();
    for (const Point& point : failure.ground) {
        lowest = std::min(lowest, point.y());
    }
    return failure.crest.y() - lowest;
}

FieldScore score_of(const SlopeRun& run) {
    FieldScore score{};
    score_profile(run.end, score);
    score_cracks(run.early, score);
    score_movements(run.early, score);
    return score;
}

}  // namespace delabole
