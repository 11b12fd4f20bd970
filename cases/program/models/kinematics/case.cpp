// Kinematic feasibility: checks of its case for the reader.
#include "cases/program/case/model_cases.hpp"
#include "kinematics/kinematics.hpp"

#include <algorithm>

namespace delabole {
namespace {

void check_names(Checker& checker, const std::vector<JointSet>& sets) {
    for (std::size_t index = 0; index < sets.size(); ++index) {
        const std::string key = indexed("joint_set", index) + ".name";
        const auto own = sets.begin() + static_cast<std::ptrdiff_t>(index);
        if (sets[index].name.empty()) {
            checker.complain(key, "must not be empty");
        } else if (std::find_if(sets.begin(), own, [&](const JointSet& set) { return set.name == own->name; }) != own) {
            checker.complain(key, "names two joint sets");
        }
    }
}

void check_dips(Checker& checker, const std::vector<JointSet>& sets) {
    for (std::size_t index = 0; index < sets.size(); ++index) {
        const auto* range = std::get_if<OrientationRange>(&sets[index].orientation);
        if (range != nullptr && range->lower_dip > range->upper_dip) {
            checker.complain(indexed("joint_set", index) + ".lower_dip",
                             "range is reversed: must be at most " + indexed("joint_set", index) + ".upper_dip");
        }
    }
}

void check_poles(Checker& checker, const Kinematics& model) {
    for (std::size_t index = 0; index < model.poles.size(); ++index) {
        if (model.poles[index].plane.empty()) {
            checker.complain(indexed("poles", index), "needs a file or at least one plane");
        }
    }
    if (measured_planes(model).size() > most_poles) {
        checker.complain("poles", "are more than " + std::to_string(most_poles));
    }
    for (std::size_t index = 0; index < model.joint_set.size(); ++index) {
        if (model.poles.empty() && std::holds_alternative<PoleWindow>(model.joint_set[index].orientation)) {
            checker.complain(indexed("joint_set", index) + ".window_dip",
                             "picks measured poles, but there are no [[poles]]");
        }
    }
    if (model.set_search) {
        check_whole(checker, "set_search.most_sets", model.set_search->most_sets);
        if (model.poles.empty() || !model.joint_set.empty()) {
            checker.complain("set_search.most_sets",
                             "sets are searched for where there are [[poles]] and no [[joint_set]]");
        }
    }
}

}  // namespace

void check_case(Checker& checker, const KinematicsStudy& study) {
    const std::vector<JointSet>& sets = study.model.joint_set;
    if (sets.empty() && study.model.poles.empty()) {
        checker.complain("joint_set", "is required: at least one [[joint_set]], or measured [[poles]]");
    }
    if (sets.size() > most_joint_sets) {
        checker.complain("joint_set", "is given " + std::to_string(sets.size()) + " times: at most " +
                                          std::to_string(most_joint_sets));
        return;
    }
    check_names(checker, sets);
    check_dips(checker, sets);
    check_poles(checker, study.model);
    if (study.sampling) {
        check_whole(checker, "sampling.sample_count", study.sampling->sample_count);
        check_whole(checker, "sampling.seed", study.sampling->seed);
    }
}

// The outputs of every set and every pair are the same, so the number of sets decides. It is limited here, because a
// case with too many sets, which is rejected later, must not exhaust the memory.
std::vector<Quantity> possible_outputs(const KinematicsStudy& study) {
    const std::size_t given = std::min(study.model.joint_set.size(), most_joint_sets);
    // The search may find fewer sets.
    const std::size_t sets = given > 0 || study.model.poles.empty() ? given : most_sets_searched(study.model);
    KinematicsResult result;
    result.joint_set.resize(sets);
    for (std::size_t set = 0; set < sets; ++set) {
        if (given == 0 || std::holds_alternative<PoleWindow>(study.model.joint_set[set].orientation)) {
            result.joint_set[set].measured.emplace();
        }
    }
    result.pair.resize(sets < 2 ? 0 : sets * (sets - 1) / 2);
    if (!study.model.poles.empty()) {
        result.poles.emplace();
    }
    std::vector<Quantity> outputs;
    for_each_named_number(result, [&](const std::string& path, const FieldInfo& info, double) {
        outputs.push_back({path, info.dimension, std::string(info.meaning)});
    });
    return outputs;
}

}  // namespace delabole
