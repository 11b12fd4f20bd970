#include "limit_equilibrium/stepped_path/stepped_path.hpp"

#include "geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace delabole {

namespace {

// A smaller difference of displacements across a joint, as a share of the greatest displacement, is no visible crack.
constexpr double least_difference = 0.05;

void add_point(Polyline& line, const Point& point) {
    if (line.empty() || (point - line.back()).norm() > 1e-9 * (1 + point.norm())) {
        line.push_back(point);
    }
}

// The straight ground from one point to another passes no corner behind the crest; the crest itself may lie between
// them.
void add_ground(Polyline& line, const PathLattice& lattice, const Point& to) {
    if (lattice.crest_between(line.back(), to)) {
        add_point(line, lattice.crest);
    }
    add_point(line, to);
}

// First displacement of a rigid part: a translation, or a rotation about a corner (positive anticlockwise, out of the
// slope).
struct PartMotion {
    Point translation = Point(0, 0);
    Point corner = Point(0, 0);
    double turn = 0;

    Point at(const Point& point) const {
        const Point arm = point - corner;
        return translation + turn * Point(-arm.y(), arm.x());
    }
    PartMotion times(double factor) const { return {factor * translation, corner, factor * turn}; }
};

// Parts of a mechanism from the toe up, with the joints between them and behind the last.
struct Motion {
    std::vector<PartMotion> part = {};
    struct Outcrop {
        Point point;
        Point out;  // normal to the joint, out of the slope
    };
    std::vector<Outcrop> outcrop = {};  // of the joint above each part
};

void add_crest_movements(const Motion& motion, const PathLattice& lattice, SteppedPathResult& result) {
    double greatest = 0;
    for (std::size_t index = 0; index < motion.part.size(); ++index) {
        greatest = std::max(greatest, motion.part[index].at(motion.outcrop[index].point).norm());
    }
    if (!(greatest > 0)) {
        return;
    }
    for (std::size_t index = 0; index < motion.part.size(); ++index) {
        const Motion::Outcrop& outcrop = motion.outcrop[index];
        if (!(outcrop.point.x() > lattice.crest.x())) {
            continue;
        }
        Point across = motion.part[index].at(outcrop.point);
        if (index + 1 < motion.part.size()) {
            across -= motion.part[index + 1].at(outcrop.point);
        }
        // Between parts that slip past each other any opening is rounding.
        const double opening = across.dot(outcrop.out) / greatest;
        result.crest_opening = opening > 1e-12 ? std::max(result.crest_opening, opening) : result.crest_opening;
        result.crest_cracks += across.norm() >= least_difference * greatest ? 1 : 0;
    }
    const PartMotion& last = motion.part.back();
    result.crest_sinking = -last.at(motion.outcrop.back().point).y() / greatest;
    const Polyline& outline = result.parts.back().outline;
    const auto [low, high] = std::ranges::minmax_element(outline, {}, [](const Point& point) { return point.y(); });
    result.crest_turning = 0 - last.turn * (high->y() - low->y()) / greatest;
}

// Weight drives the parts that sink. Parts that rise are driven by the others or by water, so that they are left out:
// shares of the net work would exceed 1.
void add_work_shares(const Motion& motion, SteppedPathResult& result) {
    double all = 0;
    for (std::size_t index = 0; index < motion.part.size(); ++index) {
        const SteppedPathResult::Part& part = result.parts[index];
        const AreaProperties<> area = area_properties(part.outline);
        const double work = -area.area * motion.part[index].at(area.centroid).y();
        if (work > 0) {
            (part.wedge                         ? result.slide_head_work_share
             : part.mode == ColumnMode::topples ? result.toppling_work_share
                                                : result.sliding_work_share) += work;
            all += work;
        }
    }
    if (all > 0) {
        result.toppling_work_share /= all;
        result.sliding_work_share /= all;
        result.slide_head_work_share /= all;
    }
}

Point unit(double dip) {
    return {std::cos(dip), std::sin(dip)};
}

double area_of(const Polyline& outline) {
    double twice = 0;
    for (std::size_t index = 0; index < outline.size(); ++index) {
        const Point& a = outline[index];
        const Point& b = outline[(index + 1) % outline.size()];
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return twice / 2;
}

void set_sliding(const SteppedPath& problem, const PathLattice& lattice, const LatticePath& path,
                 SteppedPathResult& result) {
    add_point(result.surface, *lattice.face_point(path.level.front()));
    const std::size_t risers = path.level.size() - (path.ends_on_step ? 1 : 0);
    for (std::size_t index = 0; index < risers; ++index) {
        const auto& nodes = lattice.riser_node[path.first + index];
        if (path.ends_on_step && path.level[index] == path.level.back()) {
            break;  // the step that comes out behind the crest is one part, whatever risers it crosses
        }
        add_point(result.surface, *nodes[path.level[index]]);
        if (index + 1 < path.level.size()) {
            add_point(result.surface, *nodes[path.level[index + 1]]);
        }
    }
    add_point(result.surface, path.ends_on_step ? *lattice.step_outcrop[path.level.back()]
                                                : lattice.riser_outcrop[path.first + risers - 1]);
    Polyline outline = result.surface;
    add_point(outline, lattice.crest);
    result.parts.push_back({outline, ColumnMode::slides, false});
    result.sliding_share = 1;
    const Point along = unit(path.ends_on_step ? problem.steps.dip : problem.risers->dip);
    const Point out(-along.y(), along.x());
    const Motion motion{{{-unit(problem.steps.dip), Point(0, 0), 0}}, {{result.surface.back(), out}}};
    add_crest_movements(motion, lattice, result);
    add_work_shares(motion, result);
}

void set_columns(const SteppedPath& problem, const PathLattice& lattice, const CriticalPath& critical,
                 SteppedPathResult& result) {
    const LatticePath& path = critical.path;
    const std::vector<MovingColumn> columns = moving_columns(problem, lattice, path, critical.factor_of_safety);
    const Point up = -unit(problem.columns->dip);  // along the joints between columns
    const Point out(-up.y(), up.x());
    const Point step = unit(problem.steps.dip);
    Motion motion;
    double area = 0;
    for (std::size_t index = 0; index < columns.size(); ++index) {
        const std::size_t column = path.first + index;
        const PathCell& cell = lattice.cells[column - 1][path.level[index]];
        const Point& top = lattice.column_outcrop[column - 1];
        add_point(result.surface, cell.base_from);
        add_point(result.surface, cell.base_to);
        Polyline outline{cell.base_from, cell.base_to, top};
        add_ground(outline, lattice, cell.at_face ? cell.base_from : lattice.column_outcrop[column - 2]);
        if (outline.back() == outline.front()) {
            outline.pop_back();
        }
        const bool turns = columns[index].mode == ColumnMode::topples;
        result.parts.push_back({outline, columns[index].mode, false});
        PartMotion moves = turns ? PartMotion{Point(0, 0), cell.base_from, 1} : PartMotion{-step, Point(0, 0), 0};
        if (index > 0) {
            // The column follows the one below at their contact, at the ground end of the joint between them.
            const Point& contact = lattice.column_outcrop[column - 2];
            const double own = moves.at(contact).dot(out);
            moves = moves.times(own > 0 ? motion.part.back().at(contact).dot(out) / own : 0);
        }
        motion.part.push_back(moves);
        motion.outcrop.push_back({top, out});
        area += cell.area;
        result.toppling_count += turns ? 1 : 0;
        (turns ? result.toppling_share : result.sliding_share) += cell.area;
    }
    const std::size_t last = path.first + columns.size() - 1;
    if (path.wedge) {
        const PathWedge& wedge = lattice.wedges[last - 1][*path.wedge];
        const Point& top = lattice.column_outcrop[last - 1];
        add_point(result.surface, wedge.corner);
        add_point(result.surface, wedge.outcrop);
        Polyline outline{wedge.corner, wedge.outcrop};
        add_ground(outline, lattice, top);
        result.parts.push_back({outline, ColumnMode::slides, true});
        const Point riser = unit(problem.risers->dip);
        PartMotion moves{-riser, Point(0, 0), 0};
        const Point contact = top - columns.back().depth * up;
        moves = moves.times(motion.part.back().at(contact).dot(out) / moves.at(contact).dot(out));
        motion.part.push_back(moves);
        motion.outcrop.push_back({wedge.outcrop, Point(-riser.y(), riser.x())});
        area += wedge.area;
        result.slide_head_share = wedge.area;
    } else {
        add_point(result.surface, lattice.column_outcrop[last - 1]);
    }
    result.column_count = static_cast<double>(columns.size());
    for (double* share : {&result.toppling_share, &result.sliding_share, &result.slide_head_share}) {
        *share /= area;
    }
    add_crest_movements(motion, lattice, result);
    add_work_shares(motion, result);
}

// The upper surface is the last straight part of the surface, along one joint.
void describe_surface(const PathLattice& lattice, SteppedPathResult& result) {
    const Polyline& surface = result.surface;
    const Point& foot = surface.front();
    const Point& top = surface.back();
    const Point& knee = surface[surface.size() - 2];
    for (const SteppedPathResult::Part& part : result.parts) {
        result.failed_area += area_of(part.outline);
    }
    result.retreat = lattice.retreat(top);
    result.foot_height = foot.y();
    result.knee_distance = knee.x();
    result.knee_height = knee.y();
    result.upper_height = top.y() - knee.y();
    result.upper_angle = std::atan2(top.y() - knee.y(), top.x() - knee.x());
    const bool is_plane = surface.size() == 2;
    const Point line = is_plane ? top - foot : Point(knee - foot);
    result.lower_angle = std::atan2(line.y(), line.x());
    result.lower_roughness = is_plane ? 0 : rms_distance(std::span(surface).first(surface.size() - 1), foot, knee);
    for (std::size_t index = 1; index + 1 < surface.size(); ++index) {
        const Point edge = surface[index] - surface[index - 1];
        result.lower_steps += std::abs(edge.y()) > std::abs(edge.x()) ? 1 : 0;
    }
}

// A surface is at a limit of the search if the next joint would lie beyond it.
void set_extent(const SteppedPath& problem, const PathLattice& lattice, const LatticePath& path,
                SteppedPathResult& result) {
    const bool on_riser = problem.search.mechanism == SteppedPathMechanism::sliding || path.wedge;
    const auto between_outcrops = [&](double spacing, double dip) {
        return spacing / std::abs(std::sin(dip) - std::cos(dip) * std::tan(problem.slope.upper_surface_dip));
    };
    const double next = path.ends_on_step ? between_outcrops(problem.steps.spacing, problem.steps.dip)
                        : on_riser        ? between_outcrops(problem.risers->spacing, problem.risers->dip)
                                          : between_outcrops(problem.columns->spacing, problem.columns->dip);
    const bool is_deepest = path.ends_on_step && path.level.back() == 0;
    if (result.retreat + next > lattice.greatest_retreat && !is_deepest) {
        result.extent = PathExtent::greatest;
    } else if (result.retreat - next < lattice.least_width) {
        result.extent = PathExtent::least;
    }
}

}  // namespace

SteppedPathResult analyse(const SteppedPath& problem) {
    SteppedPathResult result;
    const PathLattice lattice(problem);
    result.check = lattice.check;
    if (lattice.check != SteppedPathCheck::valid) {
        return result;
    }
    const CriticalPath critical = least_stable_path(problem, lattice);
    result.limit = critical.limit;
    result.factor_of_safety = critical.factor_of_safety;
    result.searches = critical.searches;
    result.factor_on_riser = least_stable_on_riser(problem, lattice).value;
    result.toe_fails_before = critical.limit == LimitState::abrupt ? 1 : 0;
    result.factor_of_toe = least_stable_toe(problem, lattice).value;
    if (critical.path.level.empty()) {
        return result;
    }
    if (problem.search.mechanism == SteppedPathMechanism::sliding) {
        set_sliding(problem, lattice, critical.path, result);
    } else if (critical.factor_of_safety > 0) {
        set_columns(problem, lattice, critical, result);
    } else {
        return result;
    }
    describe_surface(lattice, result);
    set_extent(problem, lattice, critical.path, result);
    return result;
}

Polyline profile_after_failure(const SteppedPath& problem, const SteppedPathResult& result) {
    if (result.surface.empty()) {
        return {};
    }
    Polyline profile{Point(0, 0)};
    for (const Point& point : result.surface) {
        add_point(profile, point);
    }
    const double further = problem.slope.height / 3;
    profile.push_back(profile.back() + further * Point(1, std::tan(problem.slope.upper_surface_dip)));
    return profile;
}

Polyline water_surface(const SteppedPath& problem) {
    return PathLattice(problem).water_surface();
}

ModelInterface model_interface(const SteppedPath& problem) {
    const auto predict = [](const SteppedPath& varied) -> Prediction {
        const SteppedPathResult result = analyse(varied);
        Prediction prediction = prediction_of(result);
        if (prediction.failure.empty()) {
            if (result.surface.empty() || !(result.factor_of_safety > 0)) {
                return {word_of(result.limit), {}, {}};
            }
            prediction.profile = profile_after_failure(varied, result);
        }
        return prediction;
    };
    ModelInterface model = interface_of_function(problem, SteppedPathResult{}, predict);
    model.bounded_outputs = {
        {place_of(model.outputs, "factor_of_safety").value(), place_of(model.outputs, "toe_fails_before"), {}}};
    return model;
}

}  // namespace delabole
