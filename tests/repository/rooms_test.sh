#!/usr/bin/env bash
# The sources keep the rules of rooms.sh, and its check finds each way of breaking them.
set -euo pipefail
rooms=$DELABOLE_SOURCE/tests/repository/rooms.sh
bash "$rooms" "$DELABOLE_SOURCE"

house=$(mktemp -d)
trap 'rm -rf "$house"' EXIT

# A tree of two headers keeps the rules until a line is added.
build_house() {
    rm -rf "${house:?}"/*
    mkdir -p "$house"/{lib/water,fitting/work,fitting/search,plots,cases/program/commands,cases/python,tests}
    printf '#pragma once\n#include <cmath>\n#include <Eigen/Core>\n' >"$house/lib/water/water.hpp"
    printf '#pragma once\n#include "water/water.hpp"\n#include <nlopt.hpp>\n' >"$house/fitting/work/fit.hpp"
    printf '#pragma once\n#include "fitting/work/fit.hpp"\n' >"$house/fitting/search/search.hpp"
    printf '#include "fitting/work/fit.hpp"\n#include <unistd.h>\n#include <toml++/toml.h>\n' >"$house/cases/program/commands/main.cpp"
    printf '#pragma once\n#include "cases/program/commands/commands.hpp"\n#include <pybind11/pybind11.h>\n' >"$house/cases/python/module.hpp"
    printf '#pragma once\n' >"$house/cases/program/commands/commands.hpp"
    printf '#include "helper.hpp"\n#include <gtest/gtest.h>\n' >"$house/tests/some_test.cpp"
}
failed=0
expect_broken() { # file, line
    build_house
    printf '%s\n' "$2" >>"$house/$1"
    if bash "$rooms" "$house" >/dev/null; then
        echo "not noticed: $2 in $1"
        failed=1
    fi
}
build_house
bash "$rooms" "$house"
expect_broken lib/water/water.hpp '#include <iostream>'
expect_broken lib/water/water.hpp '  #  include <fstream>'
expect_broken lib/water/water.hpp '#include <unistd.h>'
expect_broken lib/water/water.hpp '#include <nlopt.hpp>'
expect_broken lib/water/water.hpp '#include <glpk.h>'
expect_broken lib/water/water.hpp '#include <klu.h>'
expect_broken lib/water/water.hpp '#include "fitting/work/fit.hpp"'
expect_broken lib/water/water.hpp 'inline void shout() { std::cerr << 1; }'
expect_broken lib/water/water.hpp 'inline void shout() { std::printf("1"); }'
expect_broken fitting/work/fit.hpp '#include <toml++/toml.h>'
expect_broken fitting/work/fit.hpp '#include "plots/drawing/figure.hpp"'
expect_broken fitting/work/fit.hpp '#include "fit.hpp"'
expect_broken fitting/work/fit.hpp '#include "../lib/water/water.hpp"'
expect_broken cases/program/commands/main.cpp '#include <gnuplot-iostream.h>'
expect_broken cases/program/commands/main.cpp '#include <nlopt.hpp>'
expect_broken cases/program/commands/main.cpp '#include <gtest/gtest.h>'
expect_broken cases/program/commands/main.cpp '#include <boost/multiprecision/cpp_dec_float.hpp>'
expect_broken cases/program/commands/main.cpp '#include "tests/helper.hpp"'
expect_broken cases/program/commands/main.cpp '#include <pybind11/pybind11.h>'
expect_broken cases/program/commands/main.cpp '#include "cases/python/module.hpp"'
expect_broken cases/program/commands/main.cpp '#include SOME_MACRO'
expect_broken tests/some_test.cpp '#include <armadillo.h>'
expect_broken fitting/work/fit.hpp '#include "fitting/search/search.hpp"'

# Two rules concern no line of a file: sources outside the sub-rooms, and more sources than a folder may hold.
expect_house_broken() { # what
    if bash "$rooms" "$house" >/dev/null; then
        echo "not noticed: $1"
        failed=1
    fi
}
build_house
mkdir "$house/fitting/cellar"
cp "$house/fitting/search/search.hpp" "$house/fitting/cellar/"
expect_house_broken "a folder that is no sub-room"
build_house
cp "$house/fitting/search/search.hpp" "$house/fitting/"
expect_house_broken "a source beside the sub-rooms"
build_house
for number in {1..26}; do
    printf '#include "water/water.hpp"\n' >"$house/lib/water/water_$number.cpp"
done
expect_house_broken "more sources than a reader takes in"
build_house
mkdir "$house/tests/lib"
for number in {1..26}; do
    printf '#include "water/water.hpp"\n' >"$house/tests/lib/water_${number}_test.cpp"
done
expect_house_broken "more tests in a folder than a reader takes in"
build_house
printf '#include "fitting/work/fit.hpp"\n' >"$house/fitting/search/other.cpp"
expect_house_broken "a source without a header that declares what it defines"
build_house
printf '#include <cmath>\n#include "fitting/work/fit.hpp"\n#include "fitting/search/search.hpp"\n' >"$house/fitting/search/search.cpp"
expect_house_broken "a source that does not include its own header first"
build_house
yes '// a line' | head -n 501 >>"$house/lib/water/water.hpp" || true
expect_house_broken "a source of too many lines"
build_house
mkdir -p "$house/plots/drawing"
for number in {1..20}; do
    yes '// a line' | head -n 450 >"$house/plots/drawing/figure_$number.hpp" || true
done
expect_house_broken "a room of too many lines"
exit "$failed"
