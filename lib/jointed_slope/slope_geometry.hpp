// A section through a jointed slope in a case file: its outline and the cuts that divide it into blocks, in their
// order.
//
// Section axes: x into the slope, y up, origin at the toe, metres. The dip of a joint set is positive towards -x, out
// of the slope, and negative into it: joint A of Delabole dips 70 deg, joint B -85 deg. Rocks and joints have names.
#pragma once

#include "parameters/fields.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace delabole {

struct SectionPoint {
    double x;
    double y;
    static constexpr auto fields() {
        // Within this range areas and their quotients do not overflow, and the section does not vanish beside its
        // distance.
        constexpr Interval range = within(-1e12, 1e12);
        return FieldTable{number<&SectionPoint::x>(Dimension::length, range, "in the section"),
                          number<&SectionPoint::y>(Dimension::length, range, "in the section")};
    }
    bool operator==(const SectionPoint&) const = default;
};

enum class SideOfLine { above, below };

// Parallel joints. A spacing is uniformly distributed between (1 - scatter) and (1 + scatter) times the mean. With a
// persistence below 1 each joint is a row of traces of equal length with gaps between them, which begins at random.
// Whatever bounds a joint (trace, region, feature, rock), it divides only blocks that it crosses from side to side, as
// a line does (LineCut): blocks stay convex.
struct JointSetCut {
    double dip;
    double spacing;
    std::optional<double> scatter;
    std::optional<double> offset;
    std::optional<SectionPoint> through;
    std::optional<double> persistence;
    std::optional<double> trace_length;
    std::optional<double> seed;
    std::optional<std::string> rock;
    std::optional<std::string> ends_on;
    std::optional<SideOfLine> side;
    std::optional<std::string> staggered_by;
    std::optional<double> stagger_share;
    std::vector<SectionPoint> region;

    static constexpr std::string_view kind = "set";
    static constexpr auto fields() {
        using S = JointSetCut;
        return FieldTable{
            number<&S::dip>(Dimension::angle, within(degrees(-90), degrees(90)),
                            "positive out of the slope, towards -x"),
            number<&S::spacing>(Dimension::length, more_than(0), "mean, normal to the joints"),
            number<&S::scatter>(right_open(0, 1), "of the spacing, greatest share more or less; absent: none"),
            number<&S::offset>(Dimension::length, within(-1e12, 1e12),
                               "of one joint from the point, downwards and normal to the joints; absent: 0"),
            section<&S::through>("point from which the offset is measured; absent: (0, 0), or the toe of a section "
                                 "that does not reach there"),
            number<&S::persistence>(left_open(0, 1), "length of traces over that of traces and gaps; absent: 1"),
            number<&S::trace_length>(Dimension::length, more_than(0),
                                     "of each trace; needed where the persistence is below 1"),
            number<&S::seed>(within(0, 1e15), "of scatter and traces; absent: the number of the cut"),
            section<&S::rock>("the only rock that is cut; absent: all"),
            section<&S::ends_on>("name of an earlier line that bounds the set"),
            section<&S::side>(
                "of that line, on which there are joints; of a line that stands upright, above is towards -x"),
            section<&S::staggered_by>(
                "name of an earlier set, from one column of which to the next the joints are shifted"),
            number<&S::stagger_share>(within(0, 1), "shift as share of the spacing"),
            section<&S::region>("corners of the polygon outside which there are no joints; absent: everywhere")};
    }
    bool operator==(const JointSetCut&) const = default;
};

// A single joint, a fault or a boundary between rocks. A fault with a thickness has two faces at that distance, half of
// it on either side of the line, with gouge between them.
// A line divides the blocks that it crosses from side to side, also as far as a point inside a block where it meets or
// crosses another line, or a joint of a set, if they lie within the snap distance; a fault that ends inside a block
// runs on for that by its thickness. A part that ends elsewhere inside a block does not divide it. The order of cuts
// does not matter, unless sets name rocks or other cuts.
struct LineCut {
    std::optional<double> thickness;
    std::optional<std::string> gouge;
    std::optional<std::string> rock_above;
    std::optional<std::string> rock_below;
    std::vector<SectionPoint> vertex;

    static constexpr std::string_view kind = "line";
    static constexpr auto fields() {
        return FieldTable{number<&LineCut::thickness>(Dimension::length, more_than(0), "of the gouge; absent: none"),
                          section<&LineCut::gouge>("name of the rock between the faces"),
                          section<&LineCut::rock_above>("name of the rock above the line; absent: as before"),
                          section<&LineCut::rock_below>("name of the rock below the line; absent: as before"),
                          section<&LineCut::vertex>("points of the line, which may run out of the section")};
    }
    bool operator==(const LineCut&) const = default;
};

struct SlopeCut {
    std::string name;
    std::string joint;
    std::variant<JointSetCut, LineCut> trace;
    static constexpr auto fields() {
        using C = SlopeCut;
        return FieldTable{section<&C::name>("by which others refer to it"),
                          section<&C::joint>("name of the properties along it"), section<&C::trace>("where it runs")};
    }
    bool operator==(const SlopeCut&) const = default;
};

struct SlopeGeometry {
    std::optional<std::string> outline_file;
    std::optional<std::string> outline_layer;
    std::optional<std::string> intact_joint;
    std::optional<double> snap_distance;
    std::optional<double> sliver_share;
    static constexpr double standard_sliver_share = 0.02;
    std::vector<SectionPoint> outline;
    std::vector<SlopeCut> cut;
    static constexpr auto fields() {
        using G = SlopeGeometry;
        return FieldTable{
            section<&G::outline_file>("DXF or CSV file with the outline, beside the case; or outline"),
            section<&G::outline_layer>(
                "layer of outline_file, a DXF, that has the outline; absent: there is nothing else in the drawing"),
            section<&G::intact_joint>("name of the properties where rock is divided only because blocks are convex"),
            number<&G::snap_distance>(
                Dimension::length, more_than(0),
                "a cut this near to a corner runs through it; absent: 1/500 of the least spacing"),
            absent_is(standard_sliver_share,
                      number<&G::sliver_share>(
                          right_open(0, 1),
                          "of the median block's area, at most a thirtieth of the section, or of the size of such a "
                          "block in width: less is a sliver, merged where that leaves a convex block and locks no "
                          "joint, else taken away where it is below the share that holds without this key")),
            section<&G::outline>("corners of the section, either way round"),
            section<&G::cut>("joints, faults and boundaries in the order of cutting")};
    }
    bool operator==(const SlopeGeometry&) const = default;
};

}  // namespace delabole
