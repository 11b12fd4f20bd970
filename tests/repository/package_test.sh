#!/usr/bin/env bash
# Tests the library as its user gets it: it is installed and found by find_package, and examples of READMEs run with it.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$DELABOLE_BUILD" --component library --prefix "$work/prefix" >"$work/install.log"

# Only the library is installed: the rooms above it belong to the program.
if find "$work/prefix" -path '*/fitting/*' -o -path '*/plots/*' -o -path '*/cases/*' | grep .; then
    echo "installed, but not part of the library"
    exit 1
fi

mkdir "$work/consumer"
cd "$work/consumer"
fenced() { # language [README]: the blocks of that language
    awk -v fence="\`\`\`$1" '$0 == fence { inside = 1; next } /^```$/ { inside = 0 } inside' \
        "$DELABOLE_SOURCE/${2:-README.md}"
}
fenced cmake >CMakeLists.txt
fenced cpp >slope.cpp

# The examples of lib/README.md get one scope each; their comments state what they print.
{
    fenced cpp lib/README.md | grep '^#include'
    printf '#include <iostream>\nusing namespace delabole;\nint main() {\n'
    awk '$0 == "```cpp" { inside = 1; print "{"; next } inside && /^```$/ { inside = 0; print "}" } inside && !/^#/' \
        "$DELABOLE_SOURCE/lib/README.md"
    echo '}'
} >one_per_model.cpp
fenced cpp lib/README.md | sed -n 's|^std::cout .*// \([0-9.]*\).*|\1|p' >printed
test "$(wc -l <printed)" -ge 9

# Another source includes every installed header, so that one left behind is missed here and not by a user.
{
    find "$work/prefix/include/delabole" -name '*.hpp' -printf '#include <%P>\n' | sort
    echo '#include <iostream>'
    echo 'int main() { std::cout << delabole::version() << "\n"; }'
} >every_header.cpp
cat >>CMakeLists.txt <<'CMAKE'
add_executable(every_header every_header.cpp)
target_link_libraries(every_header PRIVATE delabole::lib)
add_executable(one_per_model one_per_model.cpp)
target_link_libraries(one_per_model PRIVATE delabole::lib)
file(WRITE ${CMAKE_BINARY_DIR}/version_found ${delabole_VERSION}\n)
CMAKE

cmake -S . -B build -G Ninja -D CMAKE_PREFIX_PATH="$work/prefix"
cmake --build build
./build/slope
./build/every_header | diff - build/version_found
./build/one_per_model | diff printed -
