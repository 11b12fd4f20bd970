#include "cases/program/models/relaxation/jointed_slope_case.hpp"

#include "cases/program/reader/names.hpp"
#include "cases/program/reader/outline_file.hpp"
#include "dynamic_relaxation/scene/slope_scene.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "fitting/work/words.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace delabole {

namespace {

template <class List>
void check_names(Checker& checker, const std::string& key, const List& list) {
    std::set<std::string> names;
    for (std::size_t index = 0; index < list.size(); ++index) {
        if (!names.insert(list[index].name).second) {
            checker.complain(indexed(key, index) + ".name", "is the name of another one already");
        }
    }
}

template <class List>
std::string names_in_words(const List& list) {
    const std::string words = separated(list, ", ", [](const auto& entry) { return entry.name; });
    return words.empty() ? "none" : words;
}

std::string area_key(const RelaxationSlope& slope, std::size_t index) {
    return index < slope.fixed.size() ? indexed("scene.fixed", index)
                                      : indexed("scene.stage", index - slope.fixed.size());
}

template <class List>
bool known(const List& list, const std::string& name) {
    return std::ranges::any_of(list, [&](const auto& entry) { return entry.name == name; });
}

// The key that names an unknown joint.
std::string unknown_joint_key(const RelaxationSlope& slope) {
    for (std::size_t index = 0; index < slope.geometry.cut.size(); ++index) {
        if (!known(slope.joint, slope.geometry.cut[index].joint)) {
            return indexed("scene.cut", index) + ".joint";
        }
    }
    if (slope.geometry.intact_joint && !known(slope.joint, *slope.geometry.intact_joint)) {
        return "scene.intact_joint";
    }
    return "scene.frame.joint";
}

std::string unknown_rock_key(const RelaxationSlope& slope, const std::string& trace, std::size_t index) {
    const auto& cut = slope.geometry.cut[index].trace;
    const auto wrong = [&](const std::optional<std::string>& name) { return name && !known(slope.rock, *name); };
    if (const auto* line = std::get_if<LineCut>(&cut)) {
        return trace + (wrong(line->gouge) ? ".gouge" : wrong(line->rock_above) ? ".rock_above" : ".rock_below");
    }
    return trace + ".rock";
}

// Asks about an outline that is larger than any slope: a drawing without a unit may be in millimetres.
std::string size_in_doubt(const RelaxationSlope& slope) {
    constexpr double largest = 5000;  // m
    const auto [left, right] = std::ranges::minmax(slope.geometry.outline, {}, &SectionPoint::x);
    const double width = right.x - left.x;
    return width > largest ? "; the outline is " + value_in_words(width, Dimension::length) +
                                 " wide: is its drawing in millimetres? Its unit is read from its header ($INSUNITS); "
                                 "without one it is metres"
                           : "";
}

// Values that nothing reads are refused: they seem to have been meant.
void check_set(Checker& checker, const std::string& trace, const JointSetCut& set) {
    check_whole(checker, trace + ".seed", set.seed);
    if (set.trace_length && !set.persistence) {
        checker.complain(trace + ".trace_length",
                         "has no effect without persistence beside it: these joints go through");
    }
    if (set.seed && !set.scatter && !set.persistence) {
        checker.complain(trace + ".seed", "has no effect without scatter or persistence: nothing of the set is random");
    }
}

}  // namespace

std::optional<SlopeComplaint> complaint_of(const RelaxationSlope& slope) {
    const SlopeScene made = slope_scene(slope);
    const std::string cut = indexed("scene.cut", made.index_at_fault);
    const std::string trace = cut + ".trace";
    switch (made.check) {
    case SlopeCheck::valid:
        break;
    case SlopeCheck::number_out_of_range:
        return SlopeComplaint{"scene", "has a number out of its range"};
    case SlopeCheck::outline_too_short:
        return SlopeComplaint{"scene.outline", "needs at least three corners apart from each other"};
    case SlopeCheck::outline_crosses_itself:
        return SlopeComplaint{
            indexed("scene.outline", made.index_at_fault),
            "is the end of an edge that crosses or touches another one, or is shorter than snap_distance: "
            "list the outline's corners in their order, without those that it does not need"};
    case SlopeCheck::snap_distance_out_of_range:
        return SlopeComplaint{"scene.snap_distance",
                              "must be at least 4e-6 of the section's size and at most a quarter of the least spacing"};
    case SlopeCheck::too_many_blocks:
        return SlopeComplaint{trace + ".spacing", "must be larger: it would make more than " +
                                                      std::to_string(most_slope_blocks) + " blocks" +
                                                      size_in_doubt(slope)};
    case SlopeCheck::line_too_short:
        return SlopeComplaint{trace + ".vertex", "needs at least two points apart from each other"};
    case SlopeCheck::line_folds_back:
        return SlopeComplaint{trace + ".vertex", "turns back on itself by more than 150 deg"};
    case SlopeCheck::region_too_short:
        return SlopeComplaint{trace + ".region", "needs at least three corners"};
    case SlopeCheck::region_crosses_itself:
        return SlopeComplaint{trace + ".region", "has edges that cross: list its corners in their order"};
    case SlopeCheck::persistence_without_trace_length:
        return SlopeComplaint{trace + ".persistence", "below 1 needs trace_length beside it"};
    case SlopeCheck::gouge_and_thickness:
        return SlopeComplaint{trace + ".thickness", "and gouge, the rock between the faces, go together"};
    case SlopeCheck::feature_and_side:
        return SlopeComplaint{trace + ".ends_on", "and side, above or below, go together"};
    case SlopeCheck::stagger_without_set:
        return SlopeComplaint{trace + ".stagger_share", "and staggered_by, a set, go together"};
    case SlopeCheck::unknown_rock:
        return slope.rock.empty()
                   ? SlopeComplaint{"scene.rock", "is required: at least one [[scene.rock]]"}
                   : SlopeComplaint{unknown_rock_key(slope, trace, made.index_at_fault),
                                    "must be the name of a [[scene.rock]]: " + names_in_words(slope.rock)};
    case SlopeCheck::unknown_joint:
        return slope.joint.empty()
                   ? SlopeComplaint{"scene.joint", "is required: at least one [[scene.joint]]"}
                   : SlopeComplaint{unknown_joint_key(slope),
                                    "must be the name of a [[scene.joint]]: " + names_in_words(slope.joint)};
    case SlopeCheck::unknown_line:
        return SlopeComplaint{trace + ".ends_on", "must be the name of a line cut before"};
    case SlopeCheck::unknown_set:
        return SlopeComplaint{trace + ".staggered_by", "must be the name of a set cut before"};
    case SlopeCheck::intact_joint_missing:
        return SlopeComplaint{
            "scene.intact_joint",
            "is required: some rock between joints is not convex and has to be divided. Name the [[scene.joint]] along "
            "which it is, as intact_joint = \"joints\", or one as strong as the rock"};
    case SlopeCheck::frame_without_edge:
        return SlopeComplaint{"scene.frame.sides",
                              "needs level edges of the outline at its foot, upright ones behind it, at its greatest "
                              "x, and in front: a slope faces left, towards -x; mirror one that faces right"};
    case SlopeCheck::water_table_too_short:
        return SlopeComplaint{"scene.water.vertex", "needs at least two points"};
    case SlopeCheck::water_table_not_increasing:
        return SlopeComplaint{"scene.water.vertex", "must have x increasing"};
    case SlopeCheck::area_too_short:
        return SlopeComplaint{area_key(slope, made.index_at_fault) + ".vertex", "needs at least three corners"};
    case SlopeCheck::area_crosses_itself:
        return SlopeComplaint{area_key(slope, made.index_at_fault) + ".vertex",
                              "has edges that cross: list the corners in their order"};
    case SlopeCheck::area_without_block:
        return SlopeComplaint{area_key(slope, made.index_at_fault), "holds the centre of no block"};
    }
    return std::nullopt;
}

void check_slope(Checker& checker, const RelaxationSlope& slope) {
    check_names(checker, "scene.rock", slope.rock);
    check_names(checker, "scene.joint", slope.joint);
    check_names(checker, "scene.cut", slope.geometry.cut);
    for (std::size_t index = 0; index < slope.geometry.cut.size(); ++index) {
        if (const auto* set = std::get_if<JointSetCut>(&slope.geometry.cut[index].trace)) {
            check_set(checker, indexed("scene.cut", index) + ".trace", *set);
        }
    }
    if (const std::optional<SlopeComplaint> complaint = complaint_of(slope)) {
        checker.complain(complaint->key, complaint->message);
    }
}

void take_outline_file(Reading& reading, RelaxationStudy& study, const std::filesystem::path& folder,
                       const std::string& prefix) {
    auto* slope = std::get_if<RelaxationSlope>(&study.model.scene);
    if (slope == nullptr || !slope->geometry.outline_file) {
        if (slope != nullptr && slope->geometry.outline_layer) {
            reading.complain_at(prefix + "scene.outline_layer", "is a layer of scene.outline_file, which is absent");
        }
        return;
    }
    const std::string key = prefix + "scene.outline_file";
    if (!slope->geometry.outline.empty()) {
        reading.complain_at(key, "and scene.outline exclude each other");
        return;
    }
    const std::filesystem::path path = folder / *slope->geometry.outline_file;
    OutlineFile file = read_outline_file(path, slope->geometry.outline_layer);
    if (!file.problem.empty()) {
        reading.complain_at(key, path.string() + " " + file.problem);
        return;
    }
    slope->geometry.outline = std::move(file.outline);
    slope->geometry.outline_file.reset();
    slope->geometry.outline_layer.reset();
}

}  // namespace delabole
