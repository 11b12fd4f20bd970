#include "cases/program/thesis/hocking/hocking_program.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace delabole {

namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double smallest_length = 1e-5;  // m, and the cosine below which a face counts as vertical
constexpr int slots_per_block = 12;       // four corners, three neighbours each

// The listing's arrays, by block.
struct Body {
    double half_major = 0;  // AA = ANN: half the longer side
    double half_minor = 0;  // BB = BNN
    double mass = 0;
    double moment_of_inertia = 0;
    double diagonal = 0;  // rad, BETA1 = BETA2: from the major axis to a corner
    double angle = 0;     // ANT, of the major axis
    double cosine = 1;
    double sine = 0;
    double dashpot = 0;  // DAMPN = DAMPS, N per metre of displacement in one cycle
    double x = 0, y = 0;
    double vx = 0, vy = 0, omega = 0;
    double fx = 0, fy = 0, moment = 0;
    double start_angle = 0;
    bool along_base = false;  // the major axis (IAXIS = 1)
    bool fixed = false;
    std::array<int, slots_per_block> neighbour{};  // by slot: the order in which the listing visits them
};

struct Slot {
    double normal = 0;                              // OVLN; 0 says that there was no contact
    double shear = 0;                               // OVLS
    double force = 0;                               // SF
    HockingFace face = HockingFace::positive_side;  // for the record only: the listing has no such memory
};

// Corners 1 to 4 are (+,+), (+,-), (-,-), (-,+) along the major and minor axes, the minor axis being the major one
// turned by +90 deg; odd neighbours touch two corners, even ones one.
std::array<int, slots_per_block> slot_neighbours(const HockingNeighbours& n, bool major_along_base) {
    // NEIGH(1) to NEIGH(8).
    const std::array<int, 8> around = major_along_base
                                          ? std::array{n.above, n.above_uphill,   n.uphill,   n.below_uphill,
                                                       n.below, n.below_downhill, n.downhill, n.above_downhill}
                                          : std::array{n.downhill, n.above_downhill, n.above, n.above_uphill,
                                                       n.uphill,   n.below_uphill,   n.below, n.below_downhill};
    // Corner IL has the neighbours NEIGH(2 IL - 1), NEIGH(2 IL + 1), NEIGH(2 IL).
    std::array<int, slots_per_block> slots{};
    for (std::size_t corner = 0; corner < 4; ++corner) {
        slots[3 * corner] = around[2 * corner];
        slots[3 * corner + 1] = around[(2 * corner + 2) % 8];
        slots[3 * corner + 2] = around[2 * corner + 1];
    }
    return slots;
}

bool major_along_base(const HockingBlock& block) {
    return !(block.height > block.width);
}

bool possible(const std::vector<HockingBlock>& blocks, const HockingSettings& settings) {
    const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
    if (!positive(settings.time_step) || !positive(settings.stiffness) || !positive(settings.density) ||
        !(settings.damping >= 0) || !std::isfinite(settings.damping) || !std::isfinite(settings.gravity) ||
        settings.print_interval < 1 || settings.significand_bits < 1 || settings.significand_bits > 53 ||
        !(settings.crossing_guard >= 0) || settings.cycles < 0 || (settings.tilting && settings.tilting->every < 1)) {
        return false;
    }
    const auto count = static_cast<int>(blocks.size());
    return std::ranges::all_of(blocks, [&](const HockingBlock& block) {
        const auto slots = slot_neighbours(block.neighbours, false);
        return positive(block.width) && positive(block.height) && block.centroid.allFinite() &&
               std::isfinite(block.dip) &&
               std::ranges::all_of(slots, [&](int index) { return index >= no_block && index < count; });
    });
}

Body body_of(const HockingBlock& block, const HockingSettings& settings) {
    Body body;
    const bool along = major_along_base(block);
    body.half_major = std::max(block.width, block.height) / 2;
    body.half_minor = std::min(block.width, block.height) / 2;
    body.mass = block.width * block.height * settings.density;
    body.moment_of_inertia = body.mass * (block.width * block.width + block.height * block.height) / 12;
    body.diagonal = std::atan(body.half_minor / body.half_major);
    body.angle = along ? block.dip : std::numbers::pi / 2 + block.dip;
    body.start_angle = body.angle;
    body.dashpot = settings.damping * 2 * std::sqrt(settings.stiffness * body.mass) / settings.time_step;
    body.x = block.centroid.x();
    body.y = block.centroid.y();
    body.fixed = block.fixed;
    body.along_base = along;
    body.neighbour = slot_neighbours(block.neighbours, along);
    return body;
}

class Program {
  public:
    Program(const std::vector<HockingBlock>& blocks, const HockingSettings& settings) : settings_(settings) {
        for (const HockingBlock& block : blocks) {
            bodies_.push_back(body_of(block, settings));
            free_weight_ += block.fixed ? 0 : bodies_.back().mass * std::abs(settings.gravity);
        }
        slots_.resize(slots_per_block * bodies_.size());
        sliding_.resize(bodies_.size());
        joints_ = {std::tan(settings.joints.peak), std::tan(settings.joints.residual)};
        bases_ = {std::tan(settings.bases.peak), std::tan(settings.bases.residual)};
    }

    HockingResult run() {
        result_.outcome = HockingOutcome::undecided;
        print();
        int last_cycle = settings_.cycles;
        while (cycle_ < last_cycle) {
            ++cycle_;
            printing_ = cycle_ % settings_.print_interval == 0;
            contacts();
            move();
            tilt();
            if (printing_) {
                print();
                const double rotation = largest_rotation();
                if (!result_.blow_out_cycle && rotation > settings_.failure_rotation) {
                    result_.outcome = HockingOutcome::fails;
                    last_cycle = rotation > settings_.stop_rotation ? cycle_ : last_cycle;
                }
            }
            if (result_.blow_out_cycle == cycle_) {
                result_.outcome = HockingOutcome::blows_out;
                last_cycle = std::min(last_cycle, cycle_ + settings_.cycles_after_blow_out);
            }
        }
        if (!printing_ && cycle_ > 0) {
            print();
        }
        if (result_.outcome == HockingOutcome::undecided && at_rest()) {
            result_.outcome = HockingOutcome::stands;
        }
        return std::move(result_);
    }

  private:
    struct Coefficients {
        double peak = 0;
        double residual = 0;
    };

    // A corner of one block against one neighbour; distances from both centroids.
    struct Touch {
        int block, neighbour;
        std::size_t corner;
        double xo, yo;  // from the corner's own centroid
        double xd, yd;  // from the neighbour's
        double xc, yc;  // from the neighbour's centroid to the corner's own
    };

    void contacts() {
        for (Body& body : bodies_) {
            body.fx = body.fy = body.moment = 0;
            body.cosine = std::cos(body.angle);
            body.sine = std::sin(body.angle);
        }
        std::ranges::fill(sliding_, BaseSliding::none);
        for (std::size_t index = 0; index < bodies_.size(); ++index) {
            const Body& own = bodies_[index];
            const double ua = own.half_major * own.cosine;
            const double va = own.half_major * own.sine;
            const double ub = -own.half_minor * own.sine;
            const double vb = own.half_minor * own.cosine;
            const std::array<double, 4> dx = {ua + ub, ua - ub, -ua - ub, -ua + ub};
            const std::array<double, 4> dy = {va + vb, va - vb, -va - vb, -va + vb};
            for (std::size_t number = 0; number < slots_per_block; ++number) {
                const int other = own.neighbour[number];
                if (other == no_block) {
                    continue;
                }
                const std::size_t corner = number / 3;
                const Body& neighbour = bodies_[static_cast<std::size_t>(other)];
                Slot& slot = slots_[slots_per_block * index + number];
                const Touch touch{static_cast<int>(index),
                                  other,
                                  corner,
                                  dx[corner],
                                  dy[corner],
                                  own.x + dx[corner] - neighbour.x,
                                  own.y + dy[corner] - neighbour.y,
                                  own.x - neighbour.x,
                                  own.y - neighbour.y};
                if (!interact(touch, slot)) {
                    slot = Slot{};
                }
            }
        }
    }

    // False where there is no contact.
    bool interact(Touch touch, Slot& slot) {
        const Body& neighbour = bodies_[static_cast<std::size_t>(touch.neighbour)];
        const double across = -touch.xd * neighbour.sine + touch.yd * neighbour.cosine;  // AJJ
        const double along = touch.xd * neighbour.cosine + touch.yd * neighbour.sine;    // TJJ = AII; TII = -AJJ
        if (std::abs(along) > neighbour.half_major || std::abs(across) > neighbour.half_minor) {
            return false;
        }
        if (std::abs(touch.xo) <= smallest_length) {
            touch.xo = smallest_length;
        }
        const std::optional<HockingFace> face = crossed_face(touch, neighbour);
        if (!face) {
            return false;  // the listing's "ERROR IN BLOCK INTERACTION"
        }
        const bool side = *face == HockingFace::positive_side || *face == HockingFace::negative_side;
        const double sign = *face == HockingFace::positive_side || *face == HockingFace::positive_end ? 1 : -1;
        if (side) {
            respond(touch, *face, neighbour.half_minor, std::abs(across), along,
                    {-neighbour.sine * sign, neighbour.cosine * sign}, {neighbour.cosine, neighbour.sine}, slot);
        } else {
            respond(touch, *face, neighbour.half_major, std::abs(along), -across,
                    {neighbour.cosine * sign, neighbour.sine * sign}, {neighbour.sine, -neighbour.cosine}, slot);
        }
        return true;
    }

    // The search KF = 1 to 4: where the line through the own centroid and the corner cuts the line of a face, within
    // the angles of its two corners seen from the neighbour's centroid.
    std::optional<HockingFace> crossed_face(const Touch& touch, const Body& neighbour) const {
        const double slope = touch.yo / touch.xo;
        const double intercept = touch.yd - touch.xd * slope;
        double heading = neighbour.angle;
        if (heading > turn) {
            heading -= turn * std::trunc(heading / turn);
        }
        double first_corner = heading + neighbour.diagonal;
        if (first_corner > turn) {
            first_corner -= turn;
        }
        const double fourth = std::numbers::pi - 2 * neighbour.diagonal;
        const double second = std::numbers::pi + fourth;
        const double uc = neighbour.half_major * neighbour.cosine;
        const double vc = neighbour.half_major * neighbour.sine;
        const double ud = -neighbour.half_minor * neighbour.sine;
        const double vd = neighbour.half_minor * neighbour.cosine;
        struct FaceLine {
            double x, y;    // of a corner on it
            double dx, dy;  // its direction
            double from, to;
        };
        const std::array<FaceLine, 4> faces = {{
            {uc + ud, vc + vd, neighbour.cosine, neighbour.sine, 0, fourth},
            {uc - ud, vc - vd, neighbour.cosine, neighbour.sine, std::numbers::pi, second},
            {uc - ud, vc - vd, -neighbour.sine, neighbour.cosine, second, turn},
            {-uc - ud, -vc - vd, -neighbour.sine, neighbour.cosine, fourth, std::numbers::pi},
        }};
        std::optional<HockingFace> found;
        double found_distance = 0;
        for (std::size_t number = 0; number < faces.size(); ++number) {
            const FaceLine& face = faces[number];
            double x = face.x;
            double y = 0;
            if (std::abs(face.dx) <= smallest_length) {
                y = intercept + x * slope;
            } else {
                const double face_slope = face.dy / face.dx;
                const double face_intercept = face.y - face.x * face_slope;
                x = (intercept - face_intercept) / (face_slope - slope);
                y = face_intercept + x * face_slope;
            }
            if (std::abs(x) <= settings_.crossing_guard) {
                x = settings_.crossing_guard;
            }
            double bearing = std::atan2(y, x);
            bearing += bearing < 0 ? turn : 0;
            bearing -= first_corner;
            bearing += bearing < 0 ? turn : 0;
            if (!(bearing <= face.to && bearing >= face.from)) {
                continue;
            }
            const double distance = std::hypot(x - touch.xc, y - touch.yc);
            if (!found) {
                found = static_cast<HockingFace>(number);
                found_distance = distance;
            } else {
                return found_distance > distance ? static_cast<HockingFace>(number) : found;
            }
        }
        return found;
    }

    void respond(const Touch& touch, HockingFace face, double half_width, double normal, double shear,
                 const std::array<double, 2>& outward, const std::array<double, 2>& tangent, Slot& slot) {
        Body& own = bodies_[static_cast<std::size_t>(touch.block)];
        Body& neighbour = bodies_[static_cast<std::size_t>(touch.neighbour)];
        const HockingFace old_face = slot.face;
        const double stored = slot.normal;
        if (settings_.slot_memory == HockingSlotMemory::per_face && face != old_face) {
            slot = Slot{};
        }
        const double old_normal = slot.normal == 0 ? normal : slot.normal;
        const double old_shear = slot.shear == 0 ? shear : slot.shear;
        const double spring_force = settings_.stiffness * (half_width - normal);
        const double dashpot_force = own.dashpot * (old_normal - normal);
        const double normal_force = spring_force + dashpot_force;
        const double shear_displacement = shear - old_shear;
        double shear_spring = slot.force + shear_displacement * settings_.stiffness;
        double shear_force = shear_spring + shear_displacement * own.dashpot;
        const bool at_base = own.fixed != neighbour.fixed;
        const Coefficients& friction = at_base ? bases_ : joints_;
        const double most = spring_force * friction.peak;
        const double magnitude = std::abs(shear_spring);
        if (printing_ && at_base && magnitude >= most && magnitude > 0) {
            record_sliding(touch, shear_spring, tangent);
        }
        if (magnitude > most) {
            shear_spring = friction.residual * spring_force * magnitude / shear_spring;
            shear_force = shear_spring;
        }
        record(touch, {stored, old_face}, {normal, face}, spring_force, dashpot_force);
        slot = {kept(normal), kept(shear), kept(shear_force), face};
        const double horizontal = normal_force * outward[0] - shear_force * tangent[0];
        const double vertical = normal_force * outward[1] - shear_force * tangent[1];
        own.fx += horizontal;
        own.fy += vertical;
        neighbour.fx -= horizontal;
        neighbour.fy -= vertical;
        neighbour.moment += horizontal * touch.yd - vertical * touch.xd;
        own.moment += -horizontal * touch.yo + vertical * touch.xo;
    }

    // The free block slides against the friction force that acts on it.
    void record_sliding(const Touch& touch, double shear_force, const std::array<double, 2>& tangent) {
        const bool own_free = !bodies_[static_cast<std::size_t>(touch.block)].fixed;
        const auto free_block = static_cast<std::size_t>(own_free ? touch.block : touch.neighbour);
        const Body& body = bodies_[free_block];
        const double base_direction = body.start_angle - (body.along_base ? 0 : std::numbers::pi / 2);
        const double along_base = tangent[0] * std::cos(base_direction) + tangent[1] * std::sin(base_direction);
        const double motion = shear_force * along_base * (own_free ? 1 : -1);
        const BaseSliding sense = motion < 0 ? BaseSliding::forward : BaseSliding::backward;
        BaseSliding& recorded = sliding_[free_block];
        recorded = recorded == BaseSliding::none || recorded == sense ? sense : BaseSliding::both;
    }

    struct Position {
        double normal;
        HockingFace face;
    };

    void record(const Touch& touch, const Position& old, const Position& now, double spring_force,
                double dashpot_force) {
        const double force = std::abs(spring_force + dashpot_force);
        largest_force_ = std::max(largest_force_, force);
        const bool blows_out = !result_.blow_out_cycle && force > settings_.blow_out_force * free_weight_;
        if (blows_out) {
            result_.blow_out_cycle = cycle_;
        }
        if (old.normal == 0 || old.face == now.face) {
            return;
        }
        ++result_.face_change_count;
        if (blows_out) {
            result_.blow_out = HockingFaceChange{cycle_,          touch.block, static_cast<int>(touch.corner),
                                                 touch.neighbour, old.face,    now.face,
                                                 old.normal,      now.normal,  spring_force,
                                                 dashpot_force};
        }
    }

    double kept(double value) const {
        const std::uint64_t beyond = (std::uint64_t{1} << static_cast<unsigned>(53 - settings_.significand_bits)) - 1;
        return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) & ~beyond);
    }

    void move() {
        const double step = settings_.time_step;
        const double weight_x = settings_.gravity * std::sin(-gravity_turn_);
        const double weight_y = settings_.gravity * std::cos(gravity_turn_);
        for (Body& body : bodies_) {
            body.fx += body.mass * weight_x;
            body.fy -= body.mass * weight_y;
            body.vx = kept(body.vx + body.fx * (step / body.mass));
            body.vy = kept(body.vy + body.fy * (step / body.mass));
            body.omega = kept(body.omega + body.moment * (step / body.moment_of_inertia));
            if (body.fixed) {
                body.vx = body.vy = body.omega = 0;
            }
            body.x = kept(body.x + body.vx * step);
            body.y = kept(body.y + body.vy * step);
            body.angle = kept(body.angle + body.omega * step);
        }
    }

    void tilt() {
        if (!settings_.tilting || cycle_ < settings_.tilting->begin || cycle_ % settings_.tilting->every != 0) {
            return;
        }
        const HockingTilting& tilting = *settings_.tilting;
        const double before = tilt_;
        tilt_ = std::min(tilting.total, tilt_ + tilting.increment);
        const double change = tilt_ - before;
        if (tilting.part == TiltedPart::gravity) {
            gravity_turn_ = tilt_;
            return;
        }
        for (Body& body : bodies_) {
            body.angle += body.fixed ? change : 0;
        }
    }

    void print() {
        HockingPrint edit;
        edit.cycle = cycle_;
        edit.tilt = tilt_;
        edit.largest_force = largest_force_;
        largest_force_ = 0;
        for (std::size_t index = 0; index < bodies_.size(); ++index) {
            const Body& body = bodies_[index];
            edit.blocks.push_back({Point(body.x, body.y), body.angle - body.start_angle, Point(body.vx, body.vy),
                                   body.omega, sliding_[index]});
        }
        result_.prints.push_back(std::move(edit));
    }

    double largest_rotation() const {
        // Blocks at rest turn with their base.
        const double turned = settings_.tilting && settings_.tilting->part == TiltedPart::base ? tilt_ : 0;
        double largest = 0;
        for (const Body& body : bodies_) {
            largest = std::max(largest, body.fixed ? 0 : std::abs(body.angle - body.start_angle - turned));
        }
        return largest;
    }

    bool at_rest() const {
        return std::ranges::all_of(bodies_, [&](const Body& body) {
            const double corner_speed = std::abs(body.omega) * std::hypot(body.half_major, body.half_minor);
            return body.fixed || std::hypot(body.vx, body.vy) + corner_speed <= settings_.settled_speed;
        });
    }

    const HockingSettings& settings_;
    std::vector<Body> bodies_;
    std::vector<Slot> slots_;
    std::vector<BaseSliding> sliding_;
    Coefficients joints_;
    Coefficients bases_;
    double free_weight_ = 0;
    double largest_force_ = 0;
    double tilt_ = 0;
    double gravity_turn_ = 0;
    int cycle_ = 0;
    bool printing_ = false;
    HockingResult result_;
};

}  // namespace

HockingResult run_hocking(const std::vector<HockingBlock>& blocks, const HockingSettings& settings) {
    return possible(blocks, settings) ? Program(blocks, settings).run() : HockingResult{};
}

std::vector<HockingBlock> blocks_at(const std::vector<HockingBlock>& blocks, const HockingPrint& print) {
    std::vector<HockingBlock> moved = blocks;
    for (std::size_t index = 0; index < moved.size() && index < print.blocks.size(); ++index) {
        moved[index].centroid = print.blocks[index].centroid;
        moved[index].dip += print.blocks[index].angle;
    }
    return moved;
}

std::array<Point, 4> corners_of(const HockingBlock& block, const HockingBlockState& state) {
    const double angle = block.dip + state.angle;
    const Point half_base = Point(std::cos(angle), std::sin(angle)) * (block.width / 2);
    const Point half_height = Point(-std::sin(angle), std::cos(angle)) * (block.height / 2);
    return {state.centroid + half_height - half_base, state.centroid + half_height + half_base,
            state.centroid - half_height + half_base, state.centroid - half_height - half_base};
}

}  // namespace delabole
