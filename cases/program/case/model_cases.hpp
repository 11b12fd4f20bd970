// Functions that the reader needs for each model besides its table of fields. Each model defines them in its own
// models/<model>/case.cpp.
#pragma once

#include "cases/program/case/model_list.hpp"
#include "cases/program/reader/section.hpp"
#include "parameters/model_interface.hpp"
#include "water/water.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace delabole {

// Complains about values that contradict each other.
class Checker {
  public:
    Checker(Reading& reading, std::string prefix) : reading_(&reading), prefix_(std::move(prefix)) {}

    // The complaint is placed at the mechanism's own key if it has one, otherwise at that of the case.
    void complain(const std::string& key, std::string message);

  private:
    Reading* reading_;
    std::string prefix_;
};

// Complains about a number that is given but not whole.
void check_whole(Checker& checker, const std::string& key, const std::optional<double>& number);

// Complains if a search's lower_<input> is not below its upper_<input>; `search` is the key of the search.
void check_bounds(Checker& checker, const std::string& search, const std::string& input,
                  const std::optional<double>& lower, const std::optional<double>& upper);

// Complains about the first point whose coordinate does not exceed that of the point before.
template <class Point, class Coordinate>
void check_increasing(Checker& checker, const std::vector<Point>& points, Coordinate coordinate, const std::string& key,
                      const std::string& name) {
    for (std::size_t index = 1; index < points.size(); ++index) {
        if (!(points[index].*coordinate > points[index - 1].*coordinate)) {
            checker.complain(indexed(key, index) + "." + name, "must be more than that of the point before");
            return;
        }
    }
}

// Complains about a water level given as an elevation if the toe has none.
template <class Water>
void check_water_level(Checker& checker, const Water& water, bool toe_has_elevation) {
    std::visit(
        [&](const auto& form) {
            if constexpr (requires { form.level; }) {
                if (std::holds_alternative<WaterElevation<>>(form.level) && !toe_has_elevation) {
                    checker.complain("water.water_elevation",
                                     "is an elevation, so slope.toe_elevation is required too");
                }
            }
        },
        water);
}

// Complains about surcharges whose end is not beyond their beginning.
template <class Surcharge>
void check_surcharges(Checker& checker, const std::vector<Surcharge>& surcharges) {
    for (std::size_t index = 0; index < surcharges.size(); ++index) {
        if (!(surcharges[index].from_distance < surcharges[index].to_distance)) {
            checker.complain(indexed("surcharge", index) + ".from_distance", "must be less than to_distance");
        }
    }
}

// Complains if the angles of a law of shear strength add up to 90 deg or more; `section` is its key.
void check_strength(Checker& checker, const std::string& section, const StrengthLaw<>& strength);

// Complains about a number of rows that is not whole and about rows above the crest.
void check_support(Checker& checker, const std::string& key, const BoltPattern<>& pattern, double slope_height);

// Complains unless each [[required]] names inputs of the case, each only once and all of one dimension.
void check_required(Checker& checker, const std::vector<RequiredValue<>>& requests, const CaseModel& model);

// Replaces file names by the contents of files in the case's folder. `prefix` is the beginning of the model's keys.
// Only slopes, records of shaking and measured poles are read from files.
template <class Model>
void take_files(Reading& /*reading*/, Model& /*model*/, const std::filesystem::path& /*folder*/,
                const std::string& /*prefix*/) {}
void take_files(Reading& reading, KinematicsStudy& study, const std::filesystem::path& folder,
                const std::string& prefix);
void take_files(Reading& reading, RelaxationStudy& study, const std::filesystem::path& folder,
                const std::string& prefix);

// Complains about combinations of inputs, as far as they can be judged without running the model. Some models have no
// such check.
template <class Model>
void check_case(Checker& /*checker*/, const Model& /*model*/) {}
void check_case(Checker& checker, const PlaneFailureStudy<>& study);
void check_case(Checker& checker, const SteppedBaseStudy<>& study);
void check_case(Checker& checker, const SingleBlock& problem);
void check_case(Checker& checker, const BlockRow& row);
void check_case(Checker& checker, const KinematicsStudy& study);
void check_case(Checker& checker, const RelaxationStudy& study);
void check_case(Checker& checker, const FlexuralSlope& slope);
void check_case(Checker& checker, const SteppedPath& path);
void check_case(Checker& checker, const WedgeFailureStudy& study);

// All outputs that the model can have, whatever a case asks for. These are the outputs of its interface unless that
// depends on more than the number of parts. The values of the model may be out of their ranges.
template <class Model>
std::vector<Quantity> possible_outputs(const Model& model) {
    return model_interface(model).outputs;
}
std::vector<Quantity> possible_outputs(const PlaneFailureStudy<>& study);
std::vector<Quantity> possible_outputs(const SteppedBaseStudy<>& study);
std::vector<Quantity> possible_outputs(const KinematicsStudy& study);
std::vector<Quantity> possible_outputs(const RelaxationStudy& study);

}  // namespace delabole
