// Slide-head toppling: a wedge above and behind the columns, sliding on a joint, pushes the uppermost column.
//
// The wedge lies between that joint (rising from the end of the stepped base), the upper face of the last column and
// the ground. It is shown in Figs 1.6(a) and 2.9 of the thesis, which prints no equations for it; they are derived
// here. Let d = dip of the wedge's joint - base dip, F the divisor of all strength, m_A = tan(friction of the wedge's
// joint) / F, m = friction of the columns' joints / F, c_A its cohesion / F, l_A its length, A and B the parts of the
// load resultant down along the joint and into it (for weight alone A = W sin(dip), B = W cos(dip)), and U the water on
// the joint. The thrust Q normal to the columns' face with shear m Q (the wedge moves down past the column and drags it
// down) and the joint's normal force R then satisfy
//   along the joint   A = m_A R + c_A l_A + Q (cos d + m sin d)
//   normal to it      R = B - U + Q (sin d - m cos d)
//   Q [cos d (1 - m_A m) + sin d (m_A + m)] = A - m_A (B - U) - c_A l_A.
// The right side is the force that the wedge lacks to stand by itself. The bracket is
// cos(d - phi_A - phi) / (cos phi_A cos phi): positive unless phi_A + phi >= 90 deg + d, where the wedge jams.
//
// Cohesion also holds the wedge where water takes its weight off the joint, B < U, as in plane failure. Where it does
// not and R would be negative, water or the columns' friction lifts the wedge off: it rests on the last column alone
// and still pushes it. With R = 0 and a shear force S on the joint
//   Q = (A - S) cos d - (B - U) sin d,   on the column's face T = (A - S) sin d + (B - U) cos d, at most m Q,
// where S is all of the cohesion, or as much of it as keeps the wedge from dragging the column upwards.
//
// No cohesion acts between wedge and column: the crack between them opens first. The unknowns (Q, R and their two
// places) exceed the wedge's three equations by one, so one assumption is needed: the joint's reaction acts where the
// resultant of the loads meets it, which is exact when Q = 0. Equilibrium of moments then puts Q on the line through
// that point: its height above the lower end of the joint is r (sin d - m cos d), r the distance of that point, limited
// to the contact.
#pragma once

#include "limit_equilibrium/columns/column_loads.hpp"

#include <limits>

namespace delabole {

enum class SlideHeadState { stands, pushes, jams, lifts_off };

template <class T = double>
struct SlideHeadThrust {
    SlideHeadState state;
    T force;         // on the last column, towards the toe along its base; 0 if the wedge stands or jams
    T shear;         // on its upper face, downwards; negative if it holds the wedge down
    T height;        // above the base of the last column
    T normal_force;  // effective, on the wedge's joint; 0 if the wedge is lifted off, negative if cohesion holds it
    T own_factor_of_safety;  // of the wedge without columns, at the given strength; infinite if no force drives it
};

// The part of a wedge's joint that is the same at every strength and for all wedges on joints of one set.
template <class T = double>
struct SlideHeadJoint {
    SineCosine<T> dip;
    SineCosine<T> opening;  // its dip less that of the columns' base
    T friction;             // tangent

    SlideHeadJoint(const SlideHeadWedge<T>& wedge, const T& base_dip)
        : dip(sine_cosine(wedge.joint_dip)), opening(sine_cosine(T(wedge.joint_dip - base_dip))), friction([&] {
              using std::tan;
              return T(tan(wedge.friction_angle));
          }()) {}
};

// joint_friction: tangent of the friction angle of the columns' joints. strength_reduction divides it, the friction of
// the wedge's own joint and its cohesion. A wedge that jams gives no thrust, which `state` reports.
template <class T>
SlideHeadThrust<T> slide_head_thrust(const SlideHeadWedge<T>& wedge, const SlideHeadJoint<T>& joint,
                                     const T& joint_friction, const T& strength_reduction) {
    const auto& [dip, opening, tangent] = joint;
    const T own_friction = tangent / strength_reduction;
    const T friction = joint_friction / strength_reduction;
    const T driving = -(wedge.force_x * dip.cosine + wedge.force_y * dip.sine);
    const T into_joint = wedge.force_x * dip.sine - wedge.force_y * dip.cosine - wedge.water_force;
    const T cohesive = wedge.cohesion / strength_reduction * wedge.joint_length;

    SlideHeadThrust<T> thrust{SlideHeadState::stands, T(0), T(0), wedge.face_base, into_joint, T(0)};
    const T resisting = cohesive + (into_joint > 0 ? T(own_friction * into_joint) : T(0));
    thrust.own_factor_of_safety = driving > 0 ? T(resisting / driving) : T(std::numeric_limits<double>::infinity());
    const T missing = driving - own_friction * into_joint - cohesive;
    const T bracket = opening.cosine * (1 - own_friction * friction) + opening.sine * (own_friction + friction);
    if (!(missing > 0)) {
        return thrust;
    }
    if (!(bracket > 0) && !(into_joint < 0)) {
        thrust.state = SlideHeadState::jams;
        return thrust;
    }
    thrust.state = SlideHeadState::pushes;
    thrust.force = bracket > 0 ? T(missing / bracket) : T(0);
    thrust.shear = friction * thrust.force;
    thrust.normal_force = into_joint + thrust.force * (opening.sine - friction * opening.cosine);
    if (thrust.normal_force < 0) {
        thrust.state = SlideHeadState::lifts_off;
        thrust.normal_force = T(0);
        T along = driving - cohesive;
        if (opening.sine > 0 && along * opening.sine < -into_joint * opening.cosine) {
            const T without_drag = -into_joint * opening.cosine / opening.sine;
            along = driving < without_drag ? driving : without_drag;
        }
        thrust.force = along * opening.cosine - into_joint * opening.sine;
        const T most = friction * thrust.force;
        const T shear = along * opening.sine + into_joint * opening.cosine;
        thrust.shear = shear > most ? most : shear < -most ? T(-most) : shear;
        if (!(thrust.force > 0)) {
            thrust.force = thrust.shear = T(0);
            return thrust;
        }
    }
    T height = wedge.reaction_position * (opening.sine - thrust.shear / thrust.force * opening.cosine);
    height = height > 0 ? (height < wedge.face_length ? height : wedge.face_length) : T(0);
    thrust.height = wedge.face_base + height;
    return thrust;
}
template <class T>
SlideHeadThrust<T> slide_head_thrust(const SlideHeadWedge<T>& wedge, const T& base_dip, const T& joint_friction,
                                     const T& strength_reduction) {
    return slide_head_thrust(wedge, SlideHeadJoint<T>(wedge, base_dip), joint_friction, strength_reduction);
}

namespace detail {

template <class T>
struct HeadLoads {
    T unit_weight;
    std::optional<SeismicLoad<T>> seismic;
    T crest_x;
    const std::vector<Surcharge<T>>& surcharges;
    const std::vector<LineLoad<T>>& line_loads;
    T face_water;  // height of water on the columns' face above its lower end
    T face_water_gradient;
};

// The corners of the wedge in turned axes: end of the base, along the joint to the ground, back along the ground.
template <class T>
std::optional<std::vector<PlanePoint<T>>> head_ground(const TurnedGround<T>& ground, const PlanePoint<T>& end,
                                                      const PlanePoint<T>& along_joint) {
    GroundWalk<T> walk(ground);
    std::vector<PlanePoint<T>> before;
    walk.advance(end.x(), before);
    std::vector<PlanePoint<T>> top{walk.here()};
    if (!walk.advance_to_ray(end, along_joint, top)) {
        return std::nullopt;
    }
    return top;
}

template <class T>
ColumnCheck make_wedge(const SlideHead<T>& head, const TurnedGround<T>& ground, const SineCosine<T>& base,
                       const PlanePoint<T>& end, const HeadLoads<T>& loads, SlideHeadWedge<T>& wedge) {
    using std::sqrt;
    const SineCosine<T> dip = sine_cosine(head.joint_dip);
    const PlanePoint<T> along_joint = turned(base, dip.cosine, dip.sine);
    const auto top = head_ground(ground, end, along_joint);
    if (!top) {
        return ColumnCheck::head_joint_never_surfaces;
    }
    Polygon<T> outline{end};
    outline.insert(outline.end(), top->rbegin(), top->rend());
    TurnedResultant<T> resultant;
    wedge.weight = add_weight(resultant, outline, end, base, loads.unit_weight, loads.seismic);
    add_ground_loads(resultant, *top, position_in_plan(base, top->back(), loads.crest_x), end, base, loads.crest_x,
                     loads.surcharges, loads.line_loads);
    const T depth = loads.face_water;
    resultant.add(T(0), T(depth / 3), T(loads.face_water_gradient * depth * depth / 2), T(0));

    const PlanePoint<T> joint = difference(top->back(), end);
    wedge.joint_dip = head.joint_dip;
    wedge.joint_length = sqrt(T(joint.x() * joint.x() + joint.y() * joint.y()));
    wedge.friction_angle = head.friction_angle;
    wedge.cohesion = head.cohesion;
    wedge.water_force = T(0);
    if (head.water) {
        const T wetted = wedge.joint_length * head.water->filled_ratio;
        wedge.water_force = head.water->unit_weight * dip.sine * wetted * wetted / 2;
    } else {
        // The pressure at the joint's lower end equals that on the columns' face. It decreases along the joint, to zero
        // or to the ground, whichever is lower.
        const T pressure = loads.face_water_gradient * depth;
        const T fall = loads.face_water_gradient / base.cosine * dip.sine;  // of the pressure, per metre of joint
        const T wetted = pressure < fall * wedge.joint_length ? T(pressure / fall) : wedge.joint_length;
        wedge.water_force = pressure > 0 ? T((pressure - fall * wetted / 2) * wetted) : T(0);
    }
    const PlanePoint<T> force = turned_back(base, PlanePoint<T>(resultant.u, resultant.v));
    wedge.force_x = force.x();
    wedge.force_y = force.y();
    const T into_joint = along_joint.x() * resultant.v - along_joint.y() * resultant.u;
    // Point at which the loads press on the joint; half way up if they do not.
    T position = into_joint < 0 ? T(resultant.moment / into_joint) : T(wedge.joint_length / 2);
    position = position > 0 ? position : T(0);
    wedge.reaction_position = position < wedge.joint_length ? position : wedge.joint_length;
    wedge.face_length = top->front().y() - end.y();
    return ColumnCheck::valid;
}

}  // namespace detail

}  // namespace delabole
