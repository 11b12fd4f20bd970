// Base friction models of the west face of Delabole as they are run: cases/thesis/chapter_2/*.toml, built into the
// program.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/thesis/physical_models.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// Of "plate_2_iii", the file's name without its ending. std::logic_error where there is none.
RelaxationStudy slope_model(std::string_view name, const std::vector<Setting>& settings = {});

// A slope from its start to its end, with frames between.
struct SlopeRun {
    RelaxationStudy study;
    RelaxationRun run;
    PostFailure end;
    // The last frame in which no more than half of what fails in the end has begun to: cracks and first movements.
    std::size_t early_frame = 0;
    PostFailure early;
};

SlopeRun run_slope(RelaxationStudy study);

// m, of the slope above its toe
double slope_height(const PostFailure& failure);

// The field criteria of 2.3.3.2 as numbers, and how a run meets them.
struct FieldScore {
    FieldVerdict profile;
    FieldVerdict cracks;
    FieldVerdict movements;
    std::string profile_in_words;
    std::string cracks_in_words;
    std::string movements_in_words;
};

FieldScore score_of(const SlopeRun& run);

}  // namespace delabole
