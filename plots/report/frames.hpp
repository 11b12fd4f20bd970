// Moving blocks for ParaView: for each moment one file of polygons and one of contact points, and collections that list
// the files with their times.
//
// The format is XML PolyData as text with nine significant digits, which needs no byte order. SI units, angles in
// radians; the section lies in the plane z = 0. A block or contact with a number that is not finite is left out.
#pragma once

#include "geometry/polyline.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

struct FrameBlock {
    Polyline outline = {};  // at that moment; a block with fewer than three corners is left out
    int number = 0;         // as labelled in the figures
    bool fixed = false;
    int movement = 0;  // index into the frame's movements
    Point displacement = {0, 0};
    double rotation = 0;  // anticlockwise
    Point velocity = {0, 0};
};

struct FrameContact {
    Point at = {0, 0};
    Point force = {0, 0};     // N/m, on the block that has the corner
    double normal_force = 0;  // N/m, compression positive
    double shear_force = 0;   // N/m
    bool sliding = false;
    int block = 0;  // number of the block that has the corner
    int other = 0;
};

struct BlockFrame {
    double time = 0;
    double tilt = 0;
    std::vector<FrameBlock> blocks = {};
    std::vector<FrameContact> contacts = {};
    std::vector<std::string> movements = {};  // the meaning of each number under "movement"
};

// The .vtp files. Cells of the block file have block, fixed, movement, displacement, rotation, velocity and speed;
// points of the contact file have force, normal_force, shear_force, sliding, block and other. Both have time and tilt,
// and the block file also the meaning of the movement numbers.
std::string blocks_vtp(const BlockFrame& frame);
std::string contacts_vtp(const BlockFrame& frame);

struct CollectedFile {
    double time;
    std::string name;  // of the file beside the collection
};

// The .pvd file.
std::string collection_pvd(const std::vector<CollectedFile>& files);

// Writes frames to a folder during a run: NAME_blocks.pvd and NAME_contacts.pvd, which can be opened before the run
// ends, and the files that they list. Throws OutputError if writing fails.
class FrameFolder {
  public:
    // Creates the folder. Frames of that name from an earlier run are removed, since that run may have had more of
    // them.
    FrameFolder(std::filesystem::path folder, std::string name);

    void add(const BlockFrame& frame);

    // The names of all files for that many frames.
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
