#include "cases/program/thesis/chapter_3/base_friction.hpp"

#include "cases/program/thesis/imperial.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace delabole {

namespace {

constexpr double pascals_of_unit_strength = 1e3;

// The golden section: no two of many neighbouring columns are shifted alike.
constexpr double column_shift = 0.381966;

SlopeCut line(const std::string& name, const std::string& joint, std::vector<SectionPoint> points) {
    LineCut cut{};
    cut.vertex = std::move(points);
    return {name, joint, cut};
}

struct Corners {
    double toe_y;  // of the upright cut's foot, or of the slope
    double crest_x;
    double crest_y;
    double right;
    double bottom;
    double left;
};

// The origin is the foot of the inclined face.
Corners corners_of(const BaseFrictionGeometry& geometry) {
    Corners at{};
    at.toe_y = -geometry.vertical_cut;
    at.crest_y = geometry.slope_height - geometry.vertical_cut;
    at.crest_x = at.crest_y / std::tan(geometry.slope_angle);
    at.right = at.crest_x + geometry.slope_surface;
    at.bottom = at.toe_y - geometry.depth;
    at.left = -geometry.front;
    return at;
}

std::vector<SectionPoint> outline_of(const BaseFrictionGeometry& geometry) {
    const Corners at = corners_of(geometry);
    std::vector<SectionPoint> outline;
    if (geometry.depth > 0) {
        outline = {{at.left, at.bottom}, {at.right, at.bottom}};
    } else {
        outline = {{0, at.toe_y}, {at.right, at.toe_y}};
    }
    outline.push_back({at.right, at.crest_y});
    outline.push_back({at.crest_x, at.crest_y});
    outline.push_back({0, 0});
    if (geometry.depth > 0) {
        if (geometry.vertical_cut > 0) {
            outline.push_back({0, at.toe_y});
        }
        outline.push_back({at.left, at.toe_y});
    }
    return outline;
}

JointSetCut set_of(double dip, double spacing) {
    JointSetCut set{};
    set.dip = dip;
    set.spacing = spacing;
    return set;
}

std::vector<SlopeCut> faces_of(const BaseFrictionGeometry& geometry, const ModelMixture& mixture) {
    const double across = degrees(90) - geometry.joint_dip;
    std::vector<SlopeCut> cuts;
    if (geometry.cross_joint_spacing) {
        JointSetCut open = set_of(across, *geometry.cross_joint_spacing);
        open.staggered_by = "columns";
        open.stagger_share = 0.5;
        JointSetCut middle = open;
        middle.offset = *geometry.cross_joint_spacing / 2;
        cuts = {{"cross joints", "joint", open}, {"middles of blocks", "intact", middle}};
    } else {
        JointSetCut faces = set_of(across, mixture.face_spacing * geometry.joint_spacing);
        faces.staggered_by = "columns";
        faces.stagger_share = column_shift;
        cuts = {{"faces", "intact", faces}};
    }
    const double height = geometry.slope_height;
    if (geometry.slope_surface < 2 * height) {
        return cuts;
    }
    // Far from the slope columns are only divided so that they can bend: below a line that rises less than any crack
    // path of the tests, and where no crack opened.
    const Corners at = corners_of(geometry);
    const double beyond = 4 * height;
    const double left = -0.1 * height;
    const double right = at.crest_x + 1.2 * height;
    const double low = at.toe_y - 0.15 * height;
    const double high = at.toe_y + 0.25 * height;
    for (SlopeCut& cut : cuts) {
        std::get<JointSetCut>(cut.trace).region = {{left, low}, {right, high}, {right, beyond}, {left, beyond}};
    }
    JointSetCut coarse = set_of(across, 4 * geometry.joint_spacing);
    coarse.staggered_by = "columns";
    coarse.stagger_share = column_shift;
    using Region = std::vector<SectionPoint>;
    const std::array<std::pair<std::string, Region>, 3> far{
        {{"faces in front", {{-beyond, -beyond}, {left, -beyond}, {left, beyond}, {-beyond, beyond}}},
         {"faces behind", {{right, -beyond}, {2 * beyond, -beyond}, {2 * beyond, beyond}, {right, beyond}}},
         {"faces below", {{left, -beyond}, {right, -beyond}, {right, high}, {left, low}}}}};
    for (const auto& [name, region] : far) {
        coarse.region = region;
        cuts.push_back({name, "intact", coarse});
    }
    return cuts;
}

std::vector<SlopeCut> cuts_of(const BaseFrictionGeometry& geometry, const ModelMixture& mixture) {
    const Corners at = corners_of(geometry);
    std::vector<SlopeCut> cuts;
    if (geometry.cut_friction) {
        cuts.push_back(line("horizontal cut", "cut", {{0, at.toe_y}, {at.right, at.toe_y}}));
    }
    if (geometry.saw_tooth) {
        const double run = (at.crest_y - at.bottom) / std::tan(geometry.joint_dip);
        cuts.push_back(line("saw-tooth joint", "saw tooth", {{at.crest_x, at.crest_y}, {at.crest_x + run, at.bottom}}));
    }
    JointSetCut columns = set_of(-geometry.joint_dip, geometry.joint_spacing);
    columns.through = geometry.saw_tooth ? SectionPoint{at.crest_x, at.crest_y} : SectionPoint{0, at.toe_y};
    cuts.push_back({"columns", "joint", columns});
    for (SlopeCut& cut : faces_of(geometry, mixture)) {
        cuts.push_back(std::move(cut));
    }
    return cuts;
}

// The toe, where the columns-th joint meets the ground and where it meets the face.
std::vector<SectionPoint> toe_area(const BaseFrictionGeometry& geometry) {
    const double dip = geometry.joint_dip;
    const double foot = static_cast<double>(geometry.columns_removed) * geometry.joint_spacing / std::sin(dip);
    const double steep = std::tan(geometry.slope_angle);
    const double along = foot * steep / (std::sin(dip) + std::cos(dip) * steep);
    return {{0, 0}, {foot, 0}, {foot - along * std::cos(dip), along * std::sin(dip)}};
}

RelaxationJoint open_joint(double friction, double stiffness) {
    RelaxationJoint joint{};
    joint.friction_angle = friction;
    joint.normal_stiffness = joint.shear_stiffness = stiffness;
    return joint;
}

std::size_t columns_removed(ToeChange toe) {
    switch (toe) {
    case ToeChange::triangle_removed:
        return 1;
    case ToeChange::blocks_removed:  // the triangle and the block beside it
        return 2;
    default:
        return 0;
    }
}

constexpr double ramp_time = 0.1;   // s, in which the belt takes hold
constexpr double belt_speed = 0.5;  // m/s

}  // namespace

ModelMixture model_mixture() {
    ModelMixture mixture{};
    mixture.friction = mixture_friction;
    // Not printed. Oily mixtures slip on smooth steel at about two thirds of their own friction.
    mixture.frame_friction = degrees(27);
    mixture.tin_friction = degrees(18);  // of plaster, 17 to 19 deg (3.3.2.1)
    mixture.saw_tooth = degrees(30);     // not printed
    mixture.density = 1330;              // 2.3.3.1
    mixture.cohesion = 3;                // not printed; 2 to 4 is customary
    // Columns that can only break into pieces as long as they are wide lock where they bend; at half of that they
    // topple.
    mixture.face_spacing = 0.5;
    // Not printed. A free column of 12 in would lean by a twentieth of its height. Of models ten times as stiff most
    // stand on their rigid blocks, whatever their strength: they wedge, as the models of chapter 2 do
    // (cases/thesis/chapter_2/plate_2_iii.toml).
    mixture.young_modulus = 3e6;
    return mixture;
}

BaseFrictionGeometry geometry_of(const BaseFrictionState& state, const ModelMixture& mixture) {
    const double height = state.slope_height();
    const bool free = state.surroundings == ModelSurroundings::boundary_free;
    const bool repeated = state.test.find("_R") != std::string::npos;
    BaseFrictionGeometry geometry{};
    geometry.slope_angle = state.slope_angle;
    geometry.slope_height = height;
    geometry.joint_dip = state.joint_dip;
    geometry.joint_spacing = state.joint_spacing;
    geometry.cross_joint_spacing = state.cross_joint_spacing;
    // Three heights where no boundary was to be felt (3.2.2, 2'); 12(R): 22 columns; 10 in, as of models 6 to 11, where
    // nothing is printed.
    const double near_surface = state.test == "12(R)" ? 15 * inch : 10 * inch;
    geometry.slope_surface = free ? 3 * height : state.slope_surface.value_or(near_surface);
    if (free) {
        geometry.depth = repeated ? height / 2 : height;
        geometry.front = height;
    } else if (state.foundation != SlopeFoundation::steel_frame) {
        // A toe cut of 3 in reached down to the frame (3.2.2, model 1). How far the ground went is not printed.
        geometry.depth = 3 * inch;
        geometry.front = 6 * inch;
    }
    geometry.vertical_cut = state.toe == ToeChange::vertical_cut ? 3 * inch : 0;
    // Slopes 3(R) and 4(L) stood on model material without the restraint of the toe: on a cut of their own.
    const bool stands_on_cut = state.test == "3(R)" || state.test == "4(L)";
    if (state.foundation == SlopeFoundation::tin_strip) {
        geometry.cut_friction = mixture.tin_friction;
    } else if (state.toe == ToeChange::horizontal_cut || stands_on_cut) {
        geometry.cut_friction = mixture.friction;
    }
    geometry.columns_removed = columns_removed(state.toe);
    geometry.saw_tooth = state.columns == ColumnKind::saw_tooth;
    return geometry;
}

RelaxationStudy base_friction_study(const BaseFrictionGeometry& geometry, const ModelMixture& mixture) {
    const double young = mixture.young_modulus;
    // A corner stands for half of a face, backed by a column's width of rock: a quarter of the modulus for faces of
    // half a spacing, twice the modulus for the long ones far from the slope. With the quarter these settle by
    // centimetres.
    const double stiffness = young / 2;
    RelaxationSlope slope{};
    slope.geometry.outline = outline_of(geometry);
    slope.geometry.cut = cuts_of(geometry, mixture);
    slope.geometry.intact_joint = "intact";
    slope.geometry.sliver_share = 0.15;
    // No joint is cut truer by hand; shorter edges would only cost time.
    slope.geometry.snap_distance = 0.03 * geometry.joint_spacing;
    slope.rock = {{"mixture", mixture.density}};
    RelaxationJoint intact = open_joint(mixture.friction, stiffness);
    intact.bond = RelaxationBond{young,
                                 0.4 * young,  // Poisson's ratio of 0.25
                                 pascals_of_unit_strength,
                                 mixture.cohesion * pascals_of_unit_strength,
                                 mixture.friction,
                                 {}};
    slope.joint = {{"joint", {}, open_joint(mixture.friction, stiffness)},
                   {"intact", {}, intact},
                   {"frame", {}, open_joint(mixture.frame_friction, stiffness)}};
    if (geometry.cut_friction) {
        slope.joint.push_back({"cut", {}, open_joint(*geometry.cut_friction, stiffness)});
    }
    if (geometry.saw_tooth) {
        slope.joint.push_back({"saw tooth", {}, open_joint(mixture.friction + mixture.saw_tooth, stiffness)});
    }
    SlopeFrame frame{};
    frame.sides = geometry.depth > 0 ? FrameSides::all_around : FrameSides::below_and_behind;
    frame.thickness = 2 * inch;
    if (geometry.depth == 0) {
        frame.reach = geometry.slope_height / 2;
    }
    frame.joint = "frame";
    slope.frame = frame;
    if (geometry.columns_removed > 0) {
        slope.stage = {{ramp_time, toe_area(geometry)}};
    }
    RelaxationStudy study{};
    study.model.scene = slope;
    // On sandpaper at 45 deg the belt drives as gravity would. It moves more slowly than what falls by the width of a
    // column, 0.7 m/s; its friction and the local damping leave inertia little to do.
    study.model.base_friction = BaseFriction{belt_speed, degrees(45)};
    RelaxationNumerics settings{};
    settings.step_fraction = 0.8;
    settings.local_damping = 0.5;
    settings.viscous_damping = 0.02;
    settings.mass_scaling = OffOn::on;
    settings.start = RelaxationStart::ramped;
    settings.ramp_time = ramp_time;
    settings.equilibrium_ratio = 3e-3;
    settings.onset_slide = 0.5;
    settings.overlap_limit = 0.5;
    settings.duration = 1;
    study.settings = settings;
    return study;
}

StrengthReduction strength_reduction_of(const BaseFrictionGeometry& geometry) {
    const double height = geometry.slope_height;
    const double spacing = geometry.joint_spacing;
    // Stresses are of the order of the slope's weight, 4 to 8 kPa at its foot. A slope rests that is slower than
    // half a thousandth of the belt, and has failed if it does not while the belt runs by thirty columns' widths.
    return {1e4, 0.3, 0.65, 0.4 * spacing, 0.1 * height * height, 1.2 * spacing, 5e-4 * belt_speed, 1.5};
}

}  // namespace delabole
