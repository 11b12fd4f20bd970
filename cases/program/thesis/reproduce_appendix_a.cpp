// The thesis's limiting equilibrium of columns on a stepped base: 4.4, Appendix A and what 5.3.4.2 says of it.
#include "cases/program/models/stepped_base/drawing.hpp"
#include "cases/program/thesis/appendix_a.hpp"
#include "cases/program/thesis/reproduction.hpp"
#include "cases/program/thesis/thesis_tables.hpp"
#include "fitting/work/words.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace delabole {

// The thesis gives bare numbers: in the case 1 is 1 m and 1 kN/m3.
SteppedBase<> appendix_a(double friction_angle) {
    SteppedBase<> problem = std::get<SteppedBaseStudy<>>(built_in_case("stepped_base", "appendix_a").model).model;
    problem.joints.friction_angle = friction_angle;
    problem.bases.friction_angle = friction_angle;
    return problem;
}

BlockColumns<> appendix_a_columns() {
    return std::get<BlockColumns<>>(appendix_a(0).scene.columns);
}

namespace {

constexpr int crest_column = 4;

// Program CAL of Appendix A, line by line where that matters: from the toe up, P is what the column above may push
// with, the lesser of what topples and what slides it; friction is changed in smaller and smaller steps until nothing
// is left at the tension crack.
struct ThesisProgram {
    double friction = 0.8;
    int last_column = 0;  // below the tension crack
    int iterations = 0;
    bool converged = false;
};

ThesisProgram run_thesis_program() {
    constexpr int most_iterations = 10000;
    const BlockColumns<> columns = appendix_a_columns();
    const double sine = std::sin(degrees(90) - columns.joint_dip);
    const double cosine = std::cos(degrees(90) - columns.joint_dip);
    const std::vector<ColumnBlock<>>& blocks = columns.block;
    const auto height = [&](int column) { return blocks[static_cast<std::size_t>(column) - 1].height; };
    ThesisProgram program;
    program.last_column = crest_column;
    while (program.last_column < static_cast<int>(blocks.size()) && height(program.last_column + 1) > cosine / sine) {
        ++program.last_column;
    }
    const double fall_of_tops = 0.4;  // TD
    const double rise_of_tops = 1.5;  // TI
    // P at the last column, or at the first that nothing need push.
    const auto last_force = [&](double friction, bool& reached_crack) {
        double force = 0;
        for (int column = 1; column <= program.last_column; ++column) {
            const double y = height(column);
            const double upper_contact = column < crest_column ? y : y - fall_of_tops;
            const double lower_contact = column == 1 ? 0 : column <= crest_column ? y - rise_of_tops : y;
            const double topples = (force * lower_contact + y / 2 * (cosine - y * sine)) / (upper_contact - friction);
            const double slides = force + y * (friction * cosine - sine) / (1 - friction * friction);
            force = std::min(topples, slides);
            reached_crack = column == program.last_column;
            if (force <= 0) {
                return force;
            }
        }
        return force;
    };
    double change = 0.1;
    double last_lowered = 0;
    double last_complete = program.friction;
    while (program.iterations < most_iterations) {
        ++program.iterations;
        bool reached_crack = false;
        const double force = last_force(program.friction, reached_crack);
        if (force <= 0) {
            program.friction += change;
        } else {
            last_complete = program.friction;
            if (std::abs(force) <= 1e-5) {
                program.converged = true;
                return program;
            }
            // The same friction once more: the step is too large.
            change /= std::abs(program.friction - last_lowered) < change / 100 ? 10 : 1;
            last_lowered = program.friction;
            program.friction -= change;
        }
        if (program.friction <= 0 || program.friction >= 1) {
            change /= 10;
            program.friction = last_complete;
        }
    }
    return program;
}

std::string degrees_in_words(double angle, int decimals) {
    const double scale = std::pow(10, decimals);
    std::string text = std::to_string(std::round(angle / degrees(1) * scale) / scale);
    return text.substr(0, text.find('.') + 1 + static_cast<std::size_t>(decimals)) + " deg";
}

Reproduction reproduce_limiting_friction(const ResultFolder& folder, Report& report) {
    const Limit limit = limiting_friction_angle(make_columns(appendix_a(degrees(40)).scene), 0);
    const SteppedBase<> problem = appendix_a(limit.value);
    const ColumnSlope<> slope = make_columns(problem.scene);
    const std::vector<ColumnResult> columns = column_results(slope, strength_of(problem));
    const ThesisProgram program = run_thesis_program();
    const SteppedBaseResult result = analyse(problem);
    std::vector<std::string_view> does;
    std::ranges::transform(columns, std::back_inserter(does),
                           [](const ColumnResult& column) { return word_of(column.mode); });
    const std::string modes = columns_in_words(does, " to ");
    const auto crack = static_cast<int>(result.uppermost_moving);
    const auto above = static_cast<std::size_t>(crack);

    Reproduction reproduction;
    const auto angle_row = [&](const std::string& what, double angle, const Remark& remark) {
        reproduction.rows.push_back({what, "41.14 deg", degrees_in_words(angle, 4),
                                     difference_in_words(angle / degrees(1) - 41.14) + " deg", remark});
    };
    angle_row("friction angle for limiting equilibrium", limit.value,
              statement(std::abs(limit.value - degrees(41.14)) < degrees(0.005)));
    angle_row(
        "the same by the algorithm of program CAL", std::atan(program.friction),
        program.converged ? std::to_string(program.iterations) + " values of friction tried" : "did not converge");
    reproduction.rows.push_back({"modes in limiting equilibrium", "1 slides, 2 to 5 topple, 6 to 8 stay", modes, "",
                                 statement(modes == "1 slides, 2 to 5 topple and 6 to 8 stay")});
    reproduction.rows.push_back({"tension crack above column", "5", std::to_string(crack), "", statement(crack == 5)});
    const std::vector<ColumnBlock<>> blocks = appendix_a_columns().block;
    const double toppling_height = std::tan(appendix_a_columns().joint_dip);
    reproduction.rows.push_back(
        {"heights beside the crack against dx cot(alpha)", "y* < dx cot(alpha) < y**",
         number_in_words(blocks[above].height) + " < " + number_in_words(toppling_height) + " < " +
             number_in_words(blocks[above - 1].height),
         "", statement(blocks[above].height < toppling_height && toppling_height < blocks[above - 1].height)});

    report.blocks.emplace_back(Heading{"Appendix A: columns on a stepped base"});
    report.blocks.emplace_back(Paragraph{
        "Eight columns 1 thick on bases that dip 21.8 deg, stepped by 0.5; tops rise by 1.5 a column up to the "
        "fourth and fall by 0.4 behind it. Unit weight 1. One friction angle on joints and bases."});
    report.blocks.emplace_back(printed_table("Printed in 4.4 and 5.3.4.2, and computed", reproduction.rows));
    report.blocks.emplace_back(Paragraph{
        "Equation (20) cannot be used as it stands, as far as the copy at hand can be read: its terms form a chain "
        "of equalities with quotient bars in the wrong places, and the weight has an exponent 2 where a "
        "factor 1/2 belongs. Moments about the toe corner of the base, P(n) being the force of column n + 1 "
        "on column n, at height Z(n), and P(n-1) that on column n - 1, at height Z'(n) above the base of "
        "column n, give P(n) [Z(n) - mu dx] = P(n-1) Z'(n) + W(n) (dx cos(alpha) - Y(n) sin(alpha)) / 2, "
        "which is what program CAL computes. Equation (21) agrees with the derivation."});
    report.blocks.emplace_back(
        Paragraph{"The program goes up from the toe and takes the lesser of both forces; the analysis here goes down "
                  "from the top and takes the greater of what each column needs. In limiting equilibrium both are the "
                  "same set of forces. The program presumes where the tension crack is (the first column behind the "
                  "crest that would not topple by itself); going down, the crack is found."});
    report.blocks.emplace_back(folder.draw(
        block_figure(column_drawing(problem, slope, columns, 1, "Appendix A in limiting equilibrium, 41.14 deg")),
        "appendix_a_section", "Modes and forces, to be compared with the thesis's Figs 4.11 and 5.17."));
    report.blocks.emplace_back(
        folder.draw(force_along_slope_figure(force_along_columns(columns, "Forces between columns, 41.14 deg")),
                    "appendix_a_forces", "Normal force that each column needs from the one below it."));
    report.blocks.emplace_back(column_table("Forces on each column (Fig 4.12) in limiting equilibrium.", columns));
    folder.write("appendix_a_columns.csv", columns_csv(columns, {}));
    reproduction.json["limiting_friction_angle_deg"] = limit.value / degrees(1);
    reproduction.json["program_cal_friction_coefficient"] = program.friction;
    reproduction.json["program_cal_iterations"] = program.iterations;
    return reproduction;
}

Reproduction reproduce_friction_angles(const ResultFolder&, Report& report) {
    Reproduction reproduction;
    for (const double angle : {38.0, 40.0, 42.0, 44.0, 46.0}) {
        const SteppedBase<> problem = appendix_a(degrees(angle));
        const SteppedBaseResult result = analyse(problem);
        const bool printed_stands = angle > 43;
        const bool stands = result.factor_of_safety >= 1;
        reproduction.rows.push_back(
            {"friction angle " + number_in_words(angle) + " deg", printed_stands ? "stands" : "fails",
             std::string(stands ? "stands" : "fails") + ", FS " + number_in_words(result.factor_of_safety), "",
             printed_stands == stands ? statement(true)
                                      : statement(false) + ": within a degree of the limit, where the numerical model "
                                                           "lets through what limiting equilibrium holds"});
        reproduction.json["factor_of_safety_at_" + number_in_words(angle) + "_deg"] = result.factor_of_safety;
    }
    report.blocks.emplace_back(Heading{"The same columns by dynamic relaxation (5.3.4.2)"});
    report.blocks.emplace_back(
        Paragraph{"Printed are the outcomes of the thesis's dynamic relaxation; computed is limiting equilibrium."});
    report.blocks.emplace_back(printed_table("Which friction angles hold", reproduction.rows));
    return reproduction;
}

}  // namespace

ReproductionChapter appendix_a_chapter() {
    return {
        "appendixA",
        "columns on a stepped base, 4.4, Appendix A and 5.3.4.2",
        "Thesis, Appendix A: printed and computed",
        {
            {"limiting_friction", "4.4, Appendix A",
             "friction for limiting equilibrium, modes and forces of Appendix A", reproduce_limiting_friction},
            {"friction_angles", "5.3.4.2", "which of the friction angles of 5.3.4.2 hold", reproduce_friction_angles},
        }};
}

}  // namespace delabole
