// Style sheets and script of the report: the files of plots/report/page/ when the program was built.
#pragma once

#include <string_view>

namespace delabole {

extern const std::string_view report_style;
extern const std::string_view animation_style;   // for a page with an animation (animation.hpp)
extern const std::string_view animation_script;  // moves the animation; goes after all animations of the page

}  // namespace delabole
