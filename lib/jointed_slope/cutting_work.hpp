// The state that the steps of cutting a slope share; see jointed_section.hpp.
#pragma once

#include "geometry/polyline.hpp"
#include "jointed_slope/face_cutting.hpp"
#include "jointed_slope/jointed_section.hpp"

#include <map>
#include <string>
#include <vector>

namespace delabole {

// The joints of a set as they were cut, for what refers to them.
struct CutSet {
    PlanePoint<> normal;
    std::vector<double> position;  // increasing
    double spacing;
};

// Coordinates are counted from the outline's first corner.
struct CuttingWork {
    SectionMesh mesh;
    PlanePoint<> origin;
    double snap;
    std::map<std::string, Polyline, std::less<>> line = {};  // towards +x
    std::map<std::string, CutSet, std::less<>> set = {};
    std::vector<MeshIndex> gouge = {};  // rocks that may be thin
};

// Twice what has been run. So many take some seconds to be cut and checked; ten times as many took minutes.
inline constexpr std::size_t most_slope_blocks = 200'000;

PlanePoint<> centroid_of(const SectionMesh& mesh, MeshIndex face);

// The outline's corners from the first one on, anticlockwise, without repetitions; fault and counts in the section.
Polygon<> prepared_outline(const SlopeGeometry& geometry, JointedSection& section);
bool crosses_itself(const Polygon<>& outline, double snap);

// Divides the faces that are not convex.
void divide_into_convex(SectionMesh& mesh, double snap);

// `number` of the cut seeds a set that has no seed of its own. `rock`: the only one that is cut, or no_index.
CutCount cut_set(CuttingWork& work, const SlopeCut& named, const JointSetCut& set, std::size_t number, MeshIndex joint,
                 MeshIndex rock, SlopeCheck& check);

struct RocksOfLine {
    MeshIndex gouge;  // each no_index where there is none
    MeshIndex above;
    MeshIndex below;
};
CutCount cut_line(CuttingWork& work, const SlopeCut& named, const LineCut& line, MeshIndex joint,
                  const RocksOfLine& rocks, SlopeCheck& check);

// Puts together what was divided only to stay convex.
void rejoin_intact(SectionMesh& mesh);
// Area of the middling face that is no gouge.
double typical_area(const CuttingWork& work);
void merge_slivers(CuttingWork& work, double share, JointedSection& section);

}  // namespace delabole
