#include "cases/program/terminal/options.hpp"

#include "fitting/work/ranks.hpp"

namespace delabole {

bool leads(const Options& options) {
    return options.ranks == nullptr || options.ranks->leads();
}

}  // namespace delabole
