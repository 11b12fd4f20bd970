// Print edits: histories of blocks, contacts and energies over time (thesis 5.2.4, Tables 5.1 to 5.5).
#pragma once

#include "dynamic_relaxation/step/bolt_forces.hpp"
#include "dynamic_relaxation/step/simulation.hpp"
#include "parameters/fields.hpp"

#include <cstddef>
#include <vector>

namespace delabole {

struct BlockMonitor {
    double block;
    static constexpr auto fields() {
        return FieldTable{number<&BlockMonitor::block>(at_least(1), "number of the block")};
    }
};

struct ContactMonitor {
    double block;
    double other;
    static constexpr auto fields() {
        return FieldTable{number<&ContactMonitor::block>(at_least(1), "number of the block that is pressed"),
                          number<&ContactMonitor::other>(at_least(1), "number of the block that presses it")};
    }
};

struct HistoryRequest {
    double interval;
    std::vector<BlockMonitor> block;
    std::vector<ContactMonitor> contact;
    static constexpr auto fields() {
        using H = HistoryRequest;
        return FieldTable{number<&H::interval>(Dimension::time, more_than(0), "model time between lines of the tables"),
                          section<&H::block>("blocks whose motion is wanted"),
                          section<&H::contact>("pairs of blocks whose force is wanted")};
    }
};

struct MonitoredBlock {
    double x = 0;  // m, displacement of the centroid since the start
    double y = 0;
    double rotation = 0;  // rad
    double velocity_x = 0;
    double velocity_y = 0;
    double angular_velocity = 0;
};

// Sum over the corners between two blocks, acting on the first of them, in section axes; spring forces without
// dashpots.
struct MonitoredContact {
    double horizontal = 0;  // N/m
    double vertical = 0;
    double normal = 0;   // sum of the normal forces of the corners
    double overlap = 0;  // m, the greatest
};

struct HistoryLine {
    double time = 0;
    double tilt = 0;
    EnergyBalance energy = {};
    std::vector<MonitoredBlock> block = {};      // in the order of the request
    std::vector<MonitoredContact> contact = {};  // in the order of the request
    std::vector<double> base_slip = {};          // m, of every block since the start
    std::vector<double> rotation = {};           // rad, of every block since the start
    std::vector<double> bolt = {};               // N/m, of every bolt
};

using RelaxationHistory = std::vector<HistoryLine>;

HistoryLine history_line(const HistoryRequest& request, const Simulation& simulation);

struct CornerForce {
    std::size_t block;
    std::size_t other;
    PlanePoint<> at;     // in the frame of the initial geometry, moved
    PlanePoint<> force;  // N/m, on `block`
    double normal;       // N/m, compressive; negative where a bond pulls
    double shear;        // N/m, along the edge
    double overlap;      // m
    bool sliding;
};

// Spring forces of all corners in compression and, at both ends of their faces, of all bonds that are whole; in
// equilibrium these are all forces between blocks.
std::vector<CornerForce> corner_forces(const std::vector<Bond>& bonds, const Bodies& bodies,
                                       const RelaxationState& state);

struct MotionFrame {
    double time = 0;
    double tilt = 0;
    std::vector<Motion> motion = {};
    std::vector<BlockOutcome> outcome = {};
    std::vector<BoltPull> bolt = {};
    std::vector<CornerForce> force = {};  // empty if only the motion is kept
};

enum class FrameParts { motion, all };

// Frames spread evenly over a run whose length is not known beforehand: whenever there are too many, every second one
// is dropped and the interval doubled.
struct MotionRecord {
    std::vector<MotionFrame> frame = {};
    double interval = 0;  // s, between frames; 0 before the first
    double next = 0;      // s, when the next frame is due

    // Keeps as many frames as their size allows: 8 to 120.
    void record(const Simulation& simulation, FrameParts parts = FrameParts::all);
    void add_last(const Simulation& simulation);
};

}  // namespace delabole
