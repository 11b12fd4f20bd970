#include "cases/program/models/block_row/drawing.hpp"

#include "limit_equilibrium/block_row/block_row.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

constexpr std::size_t most_displaced = 30;

struct Plane {
    Point along;
    Point up;

    explicit Plane(double tilt) : along(std::cos(tilt), std::sin(tilt)), up(-std::sin(tilt), std::cos(tilt)) {}
    Point at(double u, double v) const { return u * along + v * up; }
};

// The position of each block's toe along the plane before the motion.
std::vector<double> toes_of(const BlockRow& row) {
    std::vector<double> toes;
    double u = 0;
    for (const RowBlock& block : row.block) {
        toes.push_back(u);
        u += block.width;
    }
    return toes;
}

bool turns(char role) {
    return role == row_role::forward || role == row_role::pivot || role == row_role::backward ||
           role == row_role::adheres;
}

// Corners of every block after the motion, in the plane's axes; empty for blocks that stay, and for all if nothing
// moves.
class RowMotion {
  public:
    RowMotion(const BlockRow& row, std::string_view roles, double turn)
        : row_(row), roles_(roles), turn_(turn), toes_(toes_of(row)) {
        outlines_.resize(row.block.size());
        const std::size_t pivot = roles.find_first_of("PB");
        const bool any_turns = std::ranges::any_of(roles, turns);
        if (any_turns && pivot == std::string_view::npos) {
            return;
        }
        double slide = row.block.front().width / 5;
        if (any_turns) {
            slide = turn_blocks(pivot);
        }
        for (std::size_t index = 0; index < roles.size(); ++index) {
            if (roles[index] == row_role::slides) {
                upright(index, -slide);
            } else if (roles[index] == row_role::retreats) {
                upright(index, retreat_);
            }
        }
    }

    const std::vector<Polyline>& outlines() const { return outlines_; }

  private:
    void upright(std::size_t index, double shift) {
        const RowBlock& block = row_.block[index];
        const double u = toes_[index] + shift;
        outlines_[index] = {Point(u, 0), Point(u + block.width, 0), Point(u + block.width, block.height),
                            Point(u, block.height)};
    }

    // Faces stay in contact, so the toes of blocks of width b move apart to b / cos(turn). Returns the distance by
    // which this pushes the sliding blocks.
    double turn_blocks(std::size_t pivot) {
        const double cosine = std::cos(turn_);
        const double sine = std::sin(turn_);
        const auto first = static_cast<std::size_t>(std::ranges::find_if(roles_, turns) - roles_.begin());
        // Position after the motion of a toe that was at `toe` before it.
        const auto moved = [&](double toe) { return toes_[pivot] + (toe - toes_[pivot]) / cosine; };
        double unit_toe = toes_[first];
        for (std::size_t index = first; index < roles_.size() && turns(roles_[index]); ++index) {
            if (roles_[index] != row_role::adheres) {
                unit_toe = toes_[index];
            }
            const RowBlock& block = row_.block[index];
            const double from = toes_[index] - unit_toe;
            const auto corner = [&](double u, double v) {
                return Point(moved(unit_toe) + u * cosine - v * sine, u * sine + v * cosine);
            };
            outlines_[index] = {corner(from, 0), corner(from + block.width, 0),
                                corner(from + block.width, block.height), corner(from, block.height)};
            retreat_ = std::max(0.0, outlines_[index][1].x() - toes_[index] - block.width);
        }
        if (first == 0) {
            return 0;
        }
        const double contact = std::min(row_.block[first - 1].height, row_.block[first].height);
        return toes_[first] - moved(toes_[first]) + contact * sine / cosine;
    }

    const BlockRow& row_;
    std::string_view roles_;
    double turn_;
    std::vector<double> toes_;
    std::vector<Polyline> outlines_;
    double retreat_ = 0;
};

}  // namespace

DrawnMode drawn_role(char role) {
    switch (role) {
    case row_role::slides:
    case row_role::retreats:
        return DrawnMode::slides;
    case row_role::forward:
    case row_role::backward:
        return DrawnMode::slides_and_topples;
    case row_role::pivot:
    case row_role::adheres:
        return DrawnMode::topples;
    default:
        return DrawnMode::stays;
    }
}

BlockDrawing row_drawing(const BlockRow& row, std::string_view roles, double tilt,
                         const std::vector<RowBlockForces>& forces, const std::string& title, double turn) {
    BlockDrawing drawing{.title = title, .displaced_legend = "mechanism, displacement enlarged"};
    const Plane plane(tilt);
    const std::vector<double> toes = toes_of(row);
    const RowMotion motion(row, roles, turn);
    for (std::size_t index = 0; index < row.block.size(); ++index) {
        const RowBlock& block = row.block[index];
        DrawnBlock drawn;
        const double u = toes[index];
        for (const Point& corner :
             {Point(u, 0), Point(u + block.width, 0), Point(u + block.width, block.height), Point(u, block.height)}) {
            drawn.outline.push_back(plane.at(corner.x(), corner.y()));
        }
        if (row.block.size() <= most_displaced) {
            for (const Point& corner : motion.outlines()[index]) {
                drawn.displaced.push_back(plane.at(corner.x(), corner.y()));
            }
        }
        drawn.label = std::to_string(index + 1);
        drawn.mode = drawn_role(roles[index]);
        drawing.blocks.push_back(std::move(drawn));
    }
    const double length = toes.back() + row.block.back().width;
    drawing.base = {plane.at(-0.25 * length, 0), plane.at(1.15 * length, 0)};
    const std::size_t step = 1 + forces.size() / (most_displaced + 1);
    for (std::size_t index = 0; index < forces.size(); index += step) {
        const RowBlockForces& force = forces[index];
        if (force.thrust > 0) {
            drawing.forces.push_back({plane.at(toes[index] + row.block[index].width, force.thrust_height),
                                      -force.thrust * plane.along - force.shear * plane.up, ForceKind::interblock});
        }
        drawing.forces.push_back({plane.at(toes[index] + force.base_position, 0),
                                  force.normal_force * plane.up + force.base_shear * plane.along,
                                  ForceKind::base_reaction});
    }
    return drawing;
}

}  // namespace delabole
