// The thesis's limiting equilibrium of columns on a stepped base: 4.4, Appendix A and what 5.3.4.2 says of it.
#include "cases/program/thesis/appendix_a.hpp"
#include "cases/program/thesis/reproduction.hpp"
#include "cases/program/thesis/thesis_tables.hpp"
#include "fitting/work/words.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

// The thesis gives bare numbers: in the case 1 stands for 1 m and 1 kN/m3.
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

// Program CAL of Appendix A, line by line where that matters: from the toe up, P is the push that a column can bear
// from above, the smaller of those that topple and slide it; friction is changed in ever smaller steps until P is zero
// at the tension crack.
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
    // Returns P at the last column, or at the first at which it is not positive.
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
            // If the same friction occurs again, the step is too large.
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

Reproduction reproduce_thesis_program(const Sheet& sheet) {
    const ThesisProgram program = run_thesis_program();
    const double angle = std::atan(program.friction);
    const BlockColumns<> columns = appendix_a_columns();
    const double toppling_height = std::tan(columns.joint_dip);
    const auto crack = static_cast<std::size_t>(program.last_column);
    const double below = columns.block[crack - 1].height;
    const double above = columns.block[crack].height;
    Reproduction reproduction;
    reproduction.add(
        {"friction angle for limiting equilibrium by the algorithm of program CAL", "41.14 deg",
         in_six_digits(angle, Dimension::angle), difference_in_words(angle / degrees(1) - 41.14) + " deg",
         program.converged ? std::to_string(program.iterations) + " values of friction tried" : "did not converge"});
    reproduction.add("heights beside the crack against dx cot(alpha)", "y* < dx cot(alpha) < y**",
                     number_in_words(above) + " < " + number_in_words(toppling_height) + " < " + number_in_words(below),
                     statement(above < toppling_height && toppling_height < below));
    sheet.add(Heading{"Appendix A: program CAL"});
    sheet.add(printed_table("Printed in Appendix A, and computed by its algorithm", reproduction.rows));
    sheet.add(Paragraph{
        "Equation (20) cannot be used as it stands, as far as the copy at hand can be read: its terms form a chain "
        "of equalities with quotient bars in the wrong places, and the weight has an exponent 2 where a "
        "factor 1/2 belongs. Moments about the toe corner of the base, P(n) being the force of column n + 1 "
        "on column n, at height Z(n), and P(n-1) that on column n - 1, at height Z'(n) above the base of "
        "column n, give P(n) [Z(n) - mu dx] = P(n-1) Z'(n) + W(n) (dx cos(alpha) - Y(n) sin(alpha)) / 2, "
        "which is what program CAL computes. Equation (21) agrees with the derivation."});
    sheet.add(
        Paragraph{"The program goes up from the toe and takes the lesser of both forces; the analysis here goes down "
                  "from the top and takes the greater of what each column needs. In limiting equilibrium both are the "
                  "same set of forces. The program presumes where the tension crack is (the first column behind the "
                  "crest that would not topple by itself); going down, the crack is found."});
    return reproduction;
}

}  // namespace

ReproductionChapter appendix_a_chapter() {
    return {"appendixA",
            "columns on a stepped base, 4.4, Appendix A and 5.3.4.2",
            "Thesis, Appendix A: printed and computed",
            {
                data_item("limiting_friction", "4.4, Appendix A, 5.3.4.2",
                          "friction for limiting equilibrium, modes and forces of Appendix A, and which friction holds",
                          "stepped_base", {"appendix_a"}),
                {"program_cal", "Appendix A", "the same by the algorithm of the thesis's program CAL",
                 reproduce_thesis_program},
            }};
}

}  // namespace delabole
