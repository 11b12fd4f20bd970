#include "cases/program/models/kinematics/slope_of_sets.hpp"

#include "cases/program/case/starting_cases.hpp"
#include "cases/program/reader/document.hpp"
#include "plots/drawing/text.hpp"

#include <cmath>
#include <stdexcept>
#include <string_view>

namespace delabole {

namespace {

// Replaces everything from the line that begins with `first` to the next one that ends with `last`.
void replace_lines(std::string& text, const std::string& first, std::string_view last, const std::string& lines) {
    const std::size_t line_before = text.find("\n" + first);
    const std::size_t last_line = text.find(std::string(last) + "\n", line_before);
    if (line_before == std::string::npos || last_line == std::string::npos) {
        throw std::logic_error("the starting case of a jointed slope has no lines from " + first);
    }
    text.replace(line_before + 1, last_line + last.size() - line_before - 1, lines);
}

std::string corner(double x, double y) {
    return "    { x = \"" + human_number(x, 3) + " m\", y = \"" + human_number(y, 3) + " m\" },\n";
}

// Angles are rounded to a tenth of a degree.
std::string written_angle(double angle) {
    return human_number(std::round(angle / degrees(0.1)) / 10, 4) + " deg";
}

}  // namespace

std::string jointed_slope_of(const KinematicsStudy& study, const std::string& title, const KinematicsResult& result) {
    constexpr double near_the_section = degrees(30);
    constexpr double height = 12;  // m, as in the starting case
    constexpr double bench = 14;
    const SlopeOrientation& face = study.model.slope;
    std::string cuts;
    std::string left_out;
    for (const JointSetFeasibility& set : result.joint_set) {
        if (std::abs(std::cos(set.mean.dip_direction - face.face_dip_direction)) < std::sin(near_the_section)) {
            left_out += (left_out.empty() ? "" : ", ") + in_quotes(set.name);
            continue;
        }
        cuts += "    { name = " + in_quotes(set.name) + ", joint = \"joints\", trace = { kind = \"set\", dip = \"" +
                written_angle(set.apparent_dip) + "\", spacing = \"3 m\" } },  # scatters by " +
                written_angle(set.angular_standard_deviation) +
                (set.measured ? "; its mean is known to " + written_angle(set.measured->confidence_cone) + " with 95 %"
                              : "") +
                "\n";
    }
    if (cuts.empty()) {
        throw std::invalid_argument("no joint set crosses the section across the face: all strike within 30 deg of it");
    }
    const double crest = height / std::tan(face.face_dip);
    std::string text = starting_case("jointed_slope");
    replace_lines(text, "title = ", "\"",
                  "title = " + in_quotes(title + (title.empty() ? "A" : ": a") + " slope cut by its joint sets"));
    replace_lines(text, "outline = [", "\n]",
                  "outline = [\n" + corner(0, 0) + corner(crest + bench, 0) + corner(crest + bench, height) +
                      corner(crest, height) + "]");
    replace_lines(text, "joint = [", "]",
                  "joint = [{ name = \"joints\", friction_angle = \"" +
                      written_angle(study.model.strength.friction_angle) + "\" }]");
    replace_lines(text, "cut = [", "\n]",
                  "# Dips in the section across the face; the spacings are examples: replace them by measured ones.\n" +
                      (left_out.empty() ? "" : "# Without sets that strike within 30 deg of it: " + left_out + ".\n") +
                      "cut = [\n" + cuts + "]");
    return text;
}

}  // namespace delabole
