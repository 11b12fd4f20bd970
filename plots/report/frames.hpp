// Moving blocks for ParaView: one file of polygons and one of contact points per moment, and collections that say which
// moment each belongs to.
//
// XML PolyData as text, nine significant digits: readable by anybody, without byte orders. SI units, angles in radians;
// the section lies in the plane z = 0. A block or contact with a number that is not finite is left out.
#pragma once

#include "geometry/polyline.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

struct FrameBlock {
    Polyline outline = {};  // where it is now; at least three corners, or the block is left out
    int number = 0;         // as in the figures
    bool fixed = false;
    int movement = 0;  // index into the frame's words
    Point displacement = {0, 0};
    double rotation = 0;  // anticlockwise
    Point velocity = {0, 0};
};

struct FrameContact {
    Point at = {0, 0};
    Point force = {0, 0};     // N/m, on the block of the corner
    double normal_force = 0;  // N/m, compression positive
    double shear_force = 0;   // N/m
    bool sliding = false;
    int block = 0;  // number of the one whose corner it is
    int other = 0;
};

struct BlockFrame {
    double time = 0;
    double tilt = 0;
    std::vector<FrameBlock> blocks = {};
    std::vector<FrameContact> contacts = {};
    std::vector<std::string> movements = {};  // what each number under "movement" means
};

// The .vtp files. Cells of the one have block, fixed, movement, displacement, rotation, velocity and speed; points of
// the other force, normal_force, shear_force, sliding, block and other. Both say time and tilt, the first what the
// numbers of movement mean.
std::string blocks_vtp(const BlockFrame& frame);
std::string contacts_vtp(const BlockFrame& frame);

struct CollectedFile {
    double time;
    std::string name;  // of the file beside the collection
};

// The .pvd file.
std::string collection_pvd(const std::vector<CollectedFile>& files);

// Writes frames to a folder as they come: NAME_blocks.pvd and NAME_contacts.pvd, which can be opened while the run goes
// on, and the files that they list. OutputError where that fails.
class FrameFolder {
  public:
    // Creates the folder. Frames of that name that an earlier run left there are removed: it may have had more.
    FrameFolder(std::filesystem::path folder, std::string name);

    void add(const BlockFrame& frame);

    // The names of all files of so many frames.
    std::vector<std::string> file_names(std::size_t frames) const;

  private:
    std::string collection_name(std::string_view kind) const;
    std::string file_name(std::string_view kind, std::size_t index) const;
    void write_collection(std::string_view kind) const;

    std::filesystem::path folder_;
    std::string name_;
    std::vector<double> times_ = {};
};

}  // namespace delabole
