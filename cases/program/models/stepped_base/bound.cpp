#include "cases/program/models/stepped_base/bound.hpp"

#include "cases/program/models/stepped_base/drawing.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/answers.hpp"
#include "cases/program/results/result_folder.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "fitting/work/words.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace delabole {

namespace {

constexpr std::size_t most_contact_arrows = 120;
constexpr std::size_t most_drawn_blocks = 300;
constexpr std::size_t most_bracketed_columns = 100;

std::string why_not(const BoundResult& result, const std::string& what) {
    switch (result.status) {
    case LpStatus::infeasible:
        return "no friction, however large, admits forces that keep " + what + " in equilibrium";
    case LpStatus::invalid_assembly:
        switch (result.check) {
        case AssemblyCheck::loads_beyond_weight:
            return "loads_beyond_weight: " + what +
                   " are not bounded: cross joints cut only rectangular columns that carry nothing but their own "
                   "weight";
        case AssemblyCheck::weights_too_different:
            return "weights_too_different: " + what + " are not bounded: the heaviest of them weighs more than " +
                   number_in_words(greatest_weight_ratio) +
                   " times the lightest, beyond what linear programming resolves";
        default:
            return what + " are not bounded: " + std::string(word_of(result.check));
        }
    case LpStatus::optimal:
        return {};
    case LpStatus::unbounded:
    case LpStatus::not_converged:
    case LpStatus::interrupted:
        break;
    }
    return "the linear programme of " + what + " did not converge: there is no bound";
}

// The programme of a few hundred bodies takes seconds, so it can be interrupted.
BoundState columns_or_stop(const SteppedBaseAnswer& answer, double upper_part) {
    BoundState state = bound_of_columns(answer.slope, answer.resolved.problem, upper_part, &interrupt_flag());
    stop_if_interrupted();
    return state;
}

void append_no_bound(Analysis& analysis, std::string_view prefix, const std::string& reason) {
    append_outputs(analysis, BoundResult{}, std::string(prefix));
    mark_none(analysis, std::string(prefix) + ".");
    analysis.warnings.push_back(reason);
}

void append_result(Analysis& analysis, const BoundResult& result, std::string_view prefix, const std::string& what) {
    append_outputs(analysis, result, std::string(prefix));
    // An infeasible programme is an answer: a factor of safety of 0.
    if (result.status != LpStatus::optimal && result.status != LpStatus::infeasible) {
        for (const std::string_view number : {".factor_of_safety", ".duality_gap", ".imbalance"}) {
            mark_none(analysis, std::string(prefix) + std::string(number));
        }
    }
    if (const std::string reason = why_not(result, what); !reason.empty()) {
        analysis.warnings.push_back(reason);
    }
}

// The point after the motion of the mechanism; a displacement of 1 is drawn as `enlargement` metres.
Point moved(const Point& point, const Body& body, const VirtualMotion& motion, double enlargement) {
    const Point arm = point - body.centroid;
    return point + enlargement * (motion.displacement + motion.rotation * Point(-arm.y(), arm.x()));
}

void add_mechanism(BlockDrawing& drawing, const BoundState& state, double enlargement) {
    if (state.programme.mechanism.size() != drawing.blocks.size()) {
        return;
    }
    for (std::size_t index = 0; index < drawing.blocks.size(); ++index) {
        DrawnBlock& block = drawing.blocks[index];
        for (const Point& point : block.outline) {
            block.displaced.push_back(
                moved(point, state.assembly.bodies[index], state.programme.mechanism[index], enlargement));
        }
    }
    drawing.displaced_legend = "displaced by the mechanism, enlarged";
}

void add_contact_forces(BlockDrawing& drawing, const BoundState& state) {
    const std::vector<Contact>& contacts = state.assembly.contacts;
    const std::size_t step = 1 + contacts.size() / (most_contact_arrows + 1);
    for (std::size_t index = 0; index < contacts.size(); index += step) {
        const Contact& contact = contacts[index];
        const BoundContactForce& force = state.programme.forces[index];
        drawing.forces.push_back({contact.start + force.position * contact.along(),
                                  force.normal() * contact.normal() + force.shear() * contact.along(),
                                  contact.other ? ForceKind::interblock : ForceKind::base_reaction});
    }
}

// Blocks are rectangles; each is listed with the face below it.
std::vector<DrawnBlock> block_outlines(const Assembly& assembly) {
    std::vector<DrawnBlock> blocks(assembly.bodies.size());
    for (const Contact& contact : assembly.contacts) {
        if (!contact.other || *contact.other < contact.body) {
            const Point twice = 2 * assembly.bodies[contact.body].centroid;
            blocks[contact.body].outline = {contact.start, contact.end, twice - contact.start, twice - contact.end};
        }
    }
    return blocks;
}

void append_state(const SteppedBaseAnswer& answer, const BoundState& state, bool cut, const std::string& name,
                  const Sheet& sheet) {
    if (state.result.status != LpStatus::optimal || state.assembly.bodies.size() > most_drawn_blocks) {
        return;
    }
    const std::string what = cut ? "Blocks" : "Columns";
    BlockDrawing drawing = column_drawing(answer.resolved.problem, answer.slope, answer.as_given.columns, 1,
                                          what + ": forces and mechanism of the linear programme");
    drawing.forces.clear();
    if (cut) {
        drawing.blocks = block_outlines(state.assembly);
    }
    for (DrawnBlock& block : drawing.blocks) {
        block.mode = DrawnMode::plain;
    }
    add_contact_forces(drawing, state);
    add_mechanism(drawing, state, 0.3 * answer.slope.columns.front().width);
    sheet.draw(block_figure(drawing), name,
               what +
                   " with the least strength for which forces exist that keep them in equilibrium, one choice of such "
                   "forces, and the mechanism that proves it the least. Faces that slip open in it, as dilatant joints "
                   "would; real ones need not. If there are more than 120 forces, only some of them are drawn.");
}

double reduced_friction(const SteppedBase<>& problem, double factor) {
    return std::atan(std::tan(problem.joints.friction_angle) / factor);
}

void append_bracket(const SteppedBaseAnswer& answer, double bound_upper_part, const Sheet& sheet) {
    const SteppedBase<>& problem = answer.resolved.problem;
    const SteppedBaseResult& recursion = answer.result;
    if (recursion.limit != LimitState::found || !(problem.joints.friction_angle > 0) ||
        answer.slope.columns.size() > most_bracketed_columns) {
        return;
    }
    constexpr int decades = 4;
    constexpr int steps = 8;  // steps per decade
    const auto shown = [&](double factor) {
        return in_display_unit(reduced_friction(problem, factor), Dimension::angle);
    };
    Line line{.legend = "linear programming", .colour = Colour::blue, .width = 4};
    for (int index = 0; index <= decades * steps; ++index) {
        const double exponent = -static_cast<double>(index) / steps;
        const double upper_part = std::pow(10, exponent);
        const BoundResult result =
            upper_part == bound_upper_part ? answer.bound->result : columns_or_stop(answer, upper_part).result;
        line.points.emplace_back(exponent, result.status == LpStatus::optimal && result.factor_of_safety > 0
                                               ? shown(result.factor_of_safety)
                                               : std::nan(""));
    }
    Line limit{
        .points = {Point(-decades, shown(recursion.factor_of_safety)), Point(0, shown(recursion.factor_of_safety))},
        .legend = "recursion: forces on the tops of the joints",
        .colour = Colour::vermilion,
        .dash = Dash::dashed};
    Figure figure{.title = "Friction in limiting equilibrium against the part of the joints in contact",
                  .x = {.title = "upper part of each joint in contact",
                        .ticks = {{-4, "0.0001"}, {-3, "0.001"}, {-2, "0.01"}, {-1, "0.1"}, {0, "1"}}},
                  .y = {.title = "friction angle of the joints", .unit = "deg"},
                  .series = {line, limit}};
    sheet.draw(
        figure, "bound_bracket",
        "All strength divided by one factor. The linear programme may choose where forces act and puts them low on the "
        "joints; held to the tops, where toppling columns press, it needs the strength of the recursion.");
}

}  // namespace

std::string announcement(const SteppedBaseStudy<>& study) {
    constexpr double seconds_for_460 = 10;  // on one core of a processor of 2020
    constexpr double worth_telling = 2;
    if (!study.linear_programming_bound) {
        return {};
    }
    const ColumnSlope<> slope = make_columns(study.model.scene);
    if (slope.check != ColumnCheck::valid || !can_bound(slope)) {
        return {};
    }
    const auto columns = static_cast<double>(slope.columns.size());
    const double seconds = seconds_for_460 * std::pow(columns / 460, 2.2);
    return seconds < worth_telling
               ? ""
               : "the bound of " + number_in_words(columns) + " columns by linear programming takes about " +
                     number_in_words(seconds) + " s; Ctrl-C ends it";
}

void find_bounds(SteppedBaseAnswer& answer, const LinearProgrammingBound& request) {
    if (can_bound(answer.slope)) {
        answer.bound = columns_or_stop(answer, request.upper_part);
    }
    if (request.cross_joints && can_bound(answer.slope, *request.cross_joints)) {
        answer.bound_of_blocks =
            bound_of_blocks(answer.slope, answer.resolved.problem, *request.cross_joints, &interrupt_flag());
        stop_if_interrupted();
    }
}

void append_bounds(Analysis& analysis, const SteppedBaseAnswer& answer, const LinearProgrammingBound& request) {
    if (answer.bound) {
        append_result(analysis, answer.bound->result, bound_prefix, "the columns");
    } else {
        append_no_bound(analysis, bound_prefix,
                        "too many columns for the linear programme, at most " + number_in_words(most_bound_columns) +
                            ": there is no bound");
    }
    if (answer.bound_of_blocks) {
        append_result(analysis, answer.bound_of_blocks->result, bound_of_blocks_prefix,
                      "the blocks between cross joints");
    } else if (request.cross_joints) {
        append_no_bound(analysis, bound_of_blocks_prefix,
                        "too many blocks for the linear programme, at most " + number_in_words(most_bound_blocks) +
                            ": the cut columns have no bound");
    }
}

void append_bound_figures(const SteppedBaseAnswer& answer, const LinearProgrammingBound& request, const Sheet& sheet) {
    if (!answer.bound) {
        return;
    }
    sheet.add(Heading{"Bound by linear programming"});
    sheet.add(Paragraph{
        "The factor of safety of the linear programme is a bound from the unsafe side: no strength below its limit can "
        "keep the slope, but with real joints, which slip without opening, the slope may fail with more. Forces that "
        "would hold it exist; nothing makes them arise." +
        std::string(request.upper_part < 1 ? " Here joints touch over an upper part of their length alone: the factor "
                                             "lies between this bound and the recursion."
                                           : "")});
    append_state(answer, *answer.bound, false, "bound", sheet);
    if (answer.bound_of_blocks) {
        append_state(answer, *answer.bound_of_blocks, true, "bound_blocks", sheet);
    }
    append_bracket(answer, request.upper_part, sheet);
}

}  // namespace delabole
