#include "dynamic_relaxation/study/post_failure.hpp"

#include "dynamic_relaxation/blocks/shared_faces.hpp"
#include "dynamic_relaxation/step/rotation_share.hpp"
#include "numerics/constants.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace delabole {

namespace {

constexpr std::size_t stations = 1000;

double share_of(double moved_by, double limit) {
    const double ratio = (moved_by / limit) * (moved_by / limit);
    // This form does not overflow for a block that has fallen far.
    return ratio > 1 ? 1 / (1 + 1 / (ratio * ratio)) : ratio * ratio / (1 + ratio * ratio);
}

PlanePoint<> drawn_corner(const Bodies& bodies, std::size_t corner) {
    return bodies.centroid[bodies.block_of[corner]] + bodies.corner[corner];
}

// The part of a vertical line that runs through a block.
struct Chord {
    double bottom = infinity;
    double top = -infinity;
    bool there() const { return top > bottom; }
};

Chord chord_at(const Bodies& bodies, std::size_t block, double x) {
    Chord chord;
    const CornerRange& range = bodies.range[block];
    for (std::size_t corner = range.begin; corner < range.end; ++corner) {
        const PlanePoint<> from = drawn_corner(bodies, corner);
        const PlanePoint<> to = drawn_corner(bodies, range.after(corner));
        if ((from.x() <= x) != (to.x() <= x)) {
            const double y = from.y() + (to.y() - from.y()) * (x - from.x()) / (to.x() - from.x());
            chord.bottom = std::min(chord.bottom, y);
            chord.top = std::max(chord.top, y);
        }
    }
    return chord;
}

// Blocks and ground along one vertical line.
struct Station {
    double x = 0;
    double ground = -infinity;
    std::size_t top_block = 0;
    double failed = 0;  // m of height
};

// Height over the line from one point to another farther into the slope, normal to it; positive above.
double height_over(const Point& from, const Point& to, const Point& point) {
    const Point along = (to - from).normalized();
    return along.x() * (point.y() - from.y()) - along.y() * (point.x() - from.x());
}

double inclination(const Point& from, const Point& to) {
    return std::atan2(to.y() - from.y(), to.x() - from.x());
}

class Survey {
  public:
    Survey(const MovedSlope& slope, const PostFailureRequest& request)
        : slope_(slope), bodies_(slope.bodies), area_(areas()), size_(std::sqrt(*median_of_free(bodies_, area_))) {
        moved_limit_ = request.moved_share.value_or(PostFailureRequest::standard_moved_share) * size_;
        crack_limit_ = request.crack_share.value_or(PostFailureRequest::standard_crack_share) * size_;
    }

    PostFailure make() {
        weigh_blocks();
        walk_over_ground();
        if (line_.size() < 2) {
            return std::move(result_);  // everything was excavated
        }
        find_crest();
        find_surface();
        find_cracks();
        follow_crest_blocks();
        return std::move(result_);
    }

  private:
    std::vector<double> areas() const {
        std::vector<double> made;
        for (std::size_t block = 0; block < bodies_.size(); ++block) {
            made.push_back(area_of(bodies_, block));
        }
        return made;
    }

    CrestMovement movement_of(std::size_t block) const {
        const Motion& start = slope_.start[block];
        const Motion& now = slope_.now[block];
        return {now.x - start.x, now.y - start.y, now.angle - start.angle};
    }

    bool has_failed(std::size_t block) const { return !slope_.failed.empty() && slope_.failed[block] != 0; }
    bool is_there(std::size_t block) const { return slope_.removed[block] == 0 && !has_failed(block); }

    void weigh_blocks() {
        result_.share.assign(bodies_.size(), 0);
        RotationShare rotation;
        for (std::size_t block = 0; block < bodies_.size(); ++block) {
            if (bodies_.fixed[block] != 0 || slope_.removed[block] != 0) {
                continue;
            }
            const CrestMovement moved = movement_of(block);
            const double moved_by =
                std::hypot(moved.horizontal, moved.vertical, moved.rotation * bodies_.radius[block]);
            result_.share[block] = has_failed(block) ? 1 : share_of(moved_by, moved_limit_);
            result_.answer.failed_area += result_.share[block] * area_[block];
            if (!has_failed(block)) {
                rotation.add(bodies_, block, slope_.start[block], slope_.now[block]);
            }
        }
        result_.answer.rotation_share = rotation.value();
    }

    void walk_over_ground() {
        double left = infinity;
        double right = -infinity;
        for (std::size_t corner = 0; corner < bodies_.corner.size(); ++corner) {
            if (bodies_.fixed[bodies_.block_of[corner]] == 0) {
                left = std::min(left, drawn_corner(bodies_, corner).x());
                right = std::max(right, drawn_corner(bodies_, corner).x());
            }
        }
        spacing_ = (right - left) / static_cast<double>(stations);
        line_.resize(stations);
        for (std::size_t index = 0; index < stations; ++index) {
            line_[index].x = left + (static_cast<double>(index) + 0.5) * spacing_;
        }
        for (std::size_t block = 0; block < bodies_.size(); ++block) {
            if (slope_.removed[block] == 0) {
                stand_on_lines(block, left);
            }
        }
        // Where all blocks were removed the ground is unknown.
        std::erase_if(line_, [](const Station& station) { return !std::isfinite(station.ground); });
        for (const Station& station : line_) {
            result_.ground.emplace_back(station.x, station.ground);
            result_.left_standing.emplace_back(station.x, station.ground - station.failed);
        }
    }

    void stand_on_lines(std::size_t block, double left) {
        double first = infinity;
        double last = -infinity;
        for (std::size_t corner = bodies_.range[block].begin; corner < bodies_.range[block].end; ++corner) {
            first = std::min(first, drawn_corner(bodies_, corner).x());
            last = std::max(last, drawn_corner(bodies_, corner).x());
        }
        const double greatest = static_cast<double>(stations);
        const auto begin = static_cast<std::size_t>(std::clamp((first - left) / spacing_ - 1, 0.0, greatest));
        const auto end = static_cast<std::size_t>(std::clamp((last - left) / spacing_ + 1, 0.0, greatest));
        for (std::size_t index = begin; index < end; ++index) {
            Station& station = line_[index];
            const Chord chord = chord_at(bodies_, block, station.x);
            if (!chord.there()) {
                continue;
            }
            station.failed += result_.share[block] * (chord.top - chord.bottom);
            if (chord.top > station.ground) {
                station.ground = chord.top;
                station.top_block = block;
            }
        }
    }

    // Finds the corner farthest above the straight line between the ends of the ground; of several, the one in front.
    void find_crest() {
        const Point front = result_.ground.front();
        const Point rear = result_.ground.back();
        const double rounding = 1e-9 * size_;
        double highest = -infinity;
        for (const Point& point : result_.ground) {
            const double height = height_over(front, rear, point);
            if (height > highest + rounding) {
                highest = height;
                result_.crest = point;
            }
        }
        // Stations do not coincide with corners, so that the corners are searched as well.
        for (std::size_t corner = 0; corner < bodies_.corner.size(); ++corner) {
            const std::size_t block = bodies_.block_of[corner];
            const PlanePoint<> point = drawn_corner(bodies_, corner);
            if (slope_.removed[block] != 0 || std::abs(point.x() - result_.crest.x()) > 2 * spacing_) {
                continue;
            }
            const double above = height_over(front, rear, point) - highest;
            if (above > rounding || (above > -rounding && point.x() < result_.crest.x())) {
                highest = std::max(highest, highest + above);
                result_.crest = point;
            }
        }
        const auto [least, greatest] =
            std::minmax_element(line_.begin(), line_.end(),
                                [](const Station& one, const Station& other) { return one.ground < other.ground; });
        lowest_ = least->ground;
        relief_ = greatest->ground - lowest_;
        for (const Station& station : line_) {
            if (station.x > result_.crest.x()) {
                result_.answer.failed_width += result_.share[station.top_block] * spacing_;
            }
        }
    }

    // Stations from the foot to the top, including the last unfailed one on either side.
    std::pair<std::size_t, std::size_t> failed_stations() const {
        constexpr double noticed = 0.01;
        std::size_t first = line_.size();
        std::size_t last = 0;
        for (std::size_t index = 0; index < line_.size(); ++index) {
            if (line_[index].failed > noticed * relief_) {
                first = std::min(first, index);
                last = index;
            }
        }
        if (first < line_.size()) {
            return {first > 0 ? first - 1 : 0, std::min(last + 1, line_.size() - 1)};
        }
        const auto foot = std::find_if(line_.begin(), line_.end(), [&](const Station& station) {
            return station.ground > lowest_ + noticed * relief_;
        });
        const auto top =
            std::find_if(foot, line_.end(), [&](const Station& station) { return station.x >= result_.crest.x(); });
        return {static_cast<std::size_t>(foot - line_.begin()),
                std::min(static_cast<std::size_t>(top - line_.begin()), line_.size() - 1)};
    }

    void find_surface() {
        const auto [first, last] = failed_stations();
        const Polyline& left = result_.left_standing;
        const Point foot = left[std::min(first, line_.size() - 1)];
        const Point top = left[last];
        // Without a point below the line from foot to top the knee lies halfway along that line.
        Point knee = (foot + top) / 2;
        std::size_t knee_index = (first + last) / 2;
        double deepest = 0;
        for (std::size_t index = first + 1; index < last; ++index) {
            const double depth = -height_over(foot, top, left[index]);
            if (depth > deepest) {
                deepest = depth;
                knee = left[index];
                knee_index = index;
            }
        }
        result_.surface = {foot, knee, top};
        result_.answer.foot_level = foot.y();
        result_.answer.knee_level = knee.y();
        result_.answer.top_level = top.y();
        result_.answer.lower_angle = inclination(foot, knee);
        result_.answer.upper_angle = inclination(knee, top);
        if (first < knee_index && knee_index < last) {
            const std::span<const Point> ground(left);
            result_.answer.lower_roughness = rms_distance(ground.subspan(first, knee_index - first + 1), foot, knee);
            result_.answer.upper_roughness = rms_distance(ground.subspan(knee_index, last - knee_index + 1), knee, top);
        }
    }

    double ground_at(double x) const {
        const auto after = std::lower_bound(line_.begin(), line_.end(), x,
                                            [](const Station& station, double at) { return station.x < at; });
        return after == line_.end() ? line_.back().ground : after->ground;
    }

    double behind_crest(double x) const { return x - result_.crest.x(); }

    void find_cracks() {
        for (const std::string& joint : slope_.joints) {
            result_.answer.joint.push_back({joint, 0, 0, 0});
        }
        for (const SharedFace& face : find_shared_faces(bodies_)) {
            if (is_there(face.block) && is_there(face.other)) {
                add_face(face);
            }
        }
        std::sort(result_.crack.begin(), result_.crack.end(),
                  [](const CrestCrack& one, const CrestCrack& other) { return one.position < other.position; });
    }

    void add_face(const SharedFace& face) {
        const double upwards = face.along.y() < 0 ? -1 : 1;
        const PlanePoint<> to_top = upwards * face.length / 2 * face.along;
        const PlanePoint<> top = bodies_.centroid[face.other] + face.other_arm + to_top;
        const double near = std::min(bodies_.shortest_edge[face.block], bodies_.shortest_edge[face.other]) / 4;
        if (behind_crest(top.x()) < -near || std::abs(ground_at(top.x()) - top.y()) > near) {
            return;
        }
        const auto moved_by = [&](std::size_t block, const PlanePoint<>& arm) -> PlanePoint<> {
            const Motion& now = slope_.now[block];
            return PlanePoint<>(now.x, now.y) + now.turned_by(arm);
        };
        const PlanePoint<> parted =
            moved_by(face.block, face.arm + to_top) - moved_by(face.other, face.other_arm + to_top);
        const PlanePoint<> normal = slope_.now[face.other].turned(PlanePoint<>(face.along.y(), -face.along.x()));
        const double opening = normal.dot(parted);
        const std::size_t material = bodies_.material[face.edge];
        if (!(opening > 0) || material >= result_.answer.joint.size()) {
            return;
        }
        CrestJoint& joint = result_.answer.joint[material];
        joint.open += share_of(opening, crack_limit_);
        joint.opening += std::min(opening, size_);
        if (opening > crack_limit_) {
            joint.farthest = std::max(joint.farthest, behind_crest(top.x()));
            // A joint that rises into the slope dips out of it.
            const PlanePoint<> rise = upwards * face.along;
            const double dip = std::atan2(rise.y(), std::abs(rise.x()));
            result_.crack.push_back({behind_crest(top.x()), opening, rise.x() < 0 ? -dip : dip, material});
        }
    }

    void follow_crest_blocks() {
        for (const Station& station : line_) {
            if (station.x <= result_.crest.x() || !is_there(station.top_block)) {
                continue;
            }
            if (result_.block.empty() || result_.block.back().block != station.top_block) {
                result_.block.push_back({station.top_block, 0, 0, movement_of(station.top_block)});
            }
            CrestBlock& block = result_.block.back();
            block.width += spacing_;
            block.position = behind_crest(station.x) - (block.width - spacing_) / 2;
        }
        const double first = result_.crack.empty() ? infinity : result_.crack.front().position;
        const double last = result_.crack.empty() ? infinity : result_.crack.back().position;
        result_.answer.near_face = mean_movement(0, first);
        result_.answer.between_cracks = mean_movement(first, last);
        for (const CrestBlock& block : result_.block) {
            result_.answer.backward_rotation = std::max(result_.answer.backward_rotation, -block.movement.rotation);
        }
    }

    CrestMovement mean_movement(double from, double to) const {
        CrestMovement mean{0, 0, 0};
        double width = 0;
        for (const CrestBlock& block : result_.block) {
            if (block.position > from && block.position < to) {
                width += block.width;
                mean.horizontal += block.width * block.movement.horizontal;
                mean.vertical += block.width * block.movement.vertical;
                mean.rotation += block.width * block.movement.rotation;
            }
        }
        if (width > 0) {
            mean.horizontal /= width;
            mean.vertical /= width;
            mean.rotation /= width;
        }
        return mean;
    }

    const MovedSlope& slope_;
    const Bodies& bodies_;
    std::vector<double> area_;
    double size_;
    double moved_limit_ = 0;
    double crack_limit_ = 0;
    double spacing_ = 0;
    double lowest_ = 0;
    double relief_ = 0;
    std::vector<Station> line_ = {};
    PostFailure result_ = {};
};

}  // namespace

PostFailure post_failure(const MovedSlope& slope, const PostFailureRequest& request) {
    return Survey(slope, request).make();
}

}  // namespace delabole
