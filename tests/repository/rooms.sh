#!/usr/bin/env bash
# Usage: rooms.sh ROOT
# Holds the sources below ROOT to the plan of the house: each third-party library stays in its room, rooms and their
# sub-rooms include only downwards, lib/ neither reads nor prints, every source stands with its header, no folder holds
# more sources, and no source or room more lines, than a reader takes in.
# Prints every include that breaks a rule as file:line:text; exit code 1 if there is one.
set -euo pipefail
cd "$1"

rooms=(lib fitting plots cases tests)

# What each room may include between angle brackets beside the standard library and POSIX; in lib/ only pages of memory
# and the processor's own lanes of those.
declare -A libraries=(
    [lib]='(unsupported/)?Eigen/|gsl/|(glpk|klu)\.h$|sys/mman\.h$|emmintrin\.h$'
    [fitting]='(unsupported/)?Eigen/|gsl/|nlopt\.hp?p?$|(sqlite3|mpi)\.h$'
    [plots]='(unsupported/)?Eigen/|gsl/|gnuplot-iostream\.h$'
    [cases]='(unsupported/)?Eigen/|gsl/|toml\+\+/|(udunits2|malloc)\.h$|CLI/|nlohmann/|pybind11/|httplib\.h$'
    [tests]='netinet/in\.h$|(unsupported/)?Eigen/|gsl/|nlopt\.hp?p?$|gnuplot-iostream\.h$|toml\+\+/|udunits2\.h$|CLI/|nlohmann/|gtest/|gmock/|benchmark/|boost/multiprecision/|fuzzer/'
)
# Rooms that each may include, by folder from the root. lib/ is on the include path itself, so its headers are those
# whose first folder is none of the other rooms.
declare -A rooms_below=(
    [lib]=''
    [fitting]='fitting'
    [plots]='plots fitting'
    [cases]='cases plots fitting'
    [tests]='tests cases plots fitting'
)
posix='^(sys/[a-z]+|unistd|fcntl|signal|poll|spawn|termios)\.h$'
# The one file that may include it: a library whose types nobody else should see.
declare -A only_file=([glpk.h]=lib/limit_equilibrium/bound/lp_bound.cpp [klu.h]=lib/numerics/sparse_system.cpp
    [sqlite3.h]=fitting/work/evaluation_store.cpp [mpi.h]=fitting/work/ranks.cpp [httplib.h]=cases/program/live/server.cpp
    [malloc.h]=cases/program/commands/main.cpp
    [sys/mman.h]=lib/dynamic_relaxation/wide/large_array.hpp
    [emmintrin.h]=lib/numerics/lanes.hpp)
# The one folder whose files may include it.
declare -A only_folder=([pybind11]=cases/python)
# Folders inside a room, from the lowest up: each includes only itself and those before it. A folder with such a list
# has no other folders, and no sources beside them.
declare -A sub_rooms=(
    [lib/limit_equilibrium]='columns bound block_row stepped_base stepped_path'
    [lib/dynamic_relaxation]='wide scene blocks contact statics step study checkpoint'
    [fitting]='work probability search posterior mechanism back_analysis studies sensitivity'
    [plots]='drawing figures report'
    [cases]='program python'
    [cases/program]='reader case terminal results reports sweeps models live thesis commands'
)
most_sources=25
most_lines=500
# What the rooms have grown to. A change that needs more lines first looks for what can go.
declare -A most_lines_of_room=([lib]=36895 [fitting]=13741 [plots]=8054 [cases]=36351)
forbidden_in_lib='^(iostream|fstream|ostream|istream|iomanip|cstdio|stdio\.h|filesystem|syncstream|print)$'

broken=0
# Places of the sub-rooms in their lists, by room and sub-room.
declare -A floor_of=()
for room in "${!sub_rooms[@]}"; do
    floor=0
    for name in ${sub_rooms[$room]}; do
        floor_of[$room/$name]=$((floor++))
    done
done

report() {
    printf '%s: %s\n' "$1" "$2"
    broken=1
}

for room in "${rooms[@]}"; do
    [[ -d $room ]] || continue
    while IFS=: read -r file line text; do
        if [[ $text =~ ^[[:space:]]*#[[:space:]]*include[[:space:]]*\<([^\>]+)\> ]]; then
            header=${BASH_REMATCH[1]}
            if [[ $room == lib && $header =~ $forbidden_in_lib ]]; then
                report "$file:$line" "lib/ has no files and no printing: <$header>"
            elif [[ $header =~ ^[a-z_0-9]+$ ]]; then
                :  # standard library
            elif [[ $room != lib && $header =~ $posix ]]; then
                :
            elif [[ ! $header =~ ^(${libraries[$room]}) ]]; then
                report "$file:$line" "<$header> has no place in $room/"
            elif [[ -n ${only_file[$header]:-} && $file != "${only_file[$header]}" ]]; then
                report "$file:$line" "<$header> belongs in ${only_file[$header]} alone"
            elif [[ -n ${only_folder[${header%%/*}]:-} && $file != "${only_folder[${header%%/*}]}"/* ]]; then
                report "$file:$line" "<$header> belongs in ${only_folder[${header%%/*}]} alone"
            fi
        elif [[ $text =~ ^[[:space:]]*#[[:space:]]*include[[:space:]]*\"([^\"]+)\" ]]; then
            header=${BASH_REMATCH[1]}
            first=${header%%/*}
            if [[ " ${rooms[*]} " == *" $first "* && $first != lib ]]; then
                if [[ " ${rooms_below[$room]} " != *" $first "* ]]; then
                    report "$file:$line" "$room/ may not include $first/: \"$header\""
                elif [[ ! -f $header ]]; then
                    report "$file:$line" "no such header: \"$header\""
                fi
            elif [[ $first == .. || ( ! -f lib/$header && $room != tests ) ]]; then
                report "$file:$line" "neither in lib/ nor given from the root of the repository: \"$header\""
            fi
        else
            report "$file:$line" "an include this check cannot read: $text"
        fi
    done < <(grep -rnE '^[[:space:]]*#[[:space:]]*include' --include='*.[ch]pp' --include='*.h' --include='*.in' "$room")
done

# Printing without its header, e.g. through one that another header brings along. snprintf writes to memory only.
if [[ -d lib ]]; then
    while IFS=: read -r file line text; do
        report "$file:$line" "lib/ does not print: $text"
    done < <(grep -rnE '\b(std::)?(cout|cerr|clog)\b|\b(v?f?printf|f?puts|putchar|fwrite|fopen|perror)[[:space:]]*\(' \
        --include='*.[ch]pp' --include='*.in' lib)
fi

for room in "${!sub_rooms[@]}"; do
    [[ -d $room ]] || continue
    prefix=${room#lib/}
    while IFS=: read -r file line text; do
        below=${file#"$room"/}
        floor=${floor_of[$room/${below%%/*}]:-}
        if [[ -z $floor ]]; then
            report "$file" "stands in none of the folders of $room/: ${sub_rooms[$room]}"
        elif [[ $text =~ \"$prefix/([^\"]+)\" ]]; then
            included=${floor_of[$room/${BASH_REMATCH[1]%%/*}]:-}
            if [[ -n $included ]] && ((included > floor)); then
                report "$file:$line" "may not include what stands above it in $room/: \"$prefix/${BASH_REMATCH[1]}\""
            fi
        fi
    done < <(grep -rnE '^[[:space:]]*#[[:space:]]*include' --include='*.[ch]pp' "$room")
done
# A source stands with the header that declares what it defines, and includes it: one of its name, first of all, where
# there is one; otherwise several sources share one of their folder or of the folder above, and each model's share the
# lists of what the program needs of a model. main() is declared nowhere.
model_lists='cases/program/(case/model_cases|results/model_reports)'
while read -r file; do
    path=${file#lib/}
    header=${path%.cpp}.hpp
    folder=${path%/*}
    if [[ -f ${file%.cpp}.hpp ]]; then
        [[ $(grep -m 1 '^#include "' "$file") == "#include \"$header\"" ]] ||
            report "$file" "does not include \"$header\" first"
    elif [[ ${file##*/} != main.cpp ]]; then
        grep -qE "^#include \"((${folder}|${folder%/*})/[^/]*|$model_lists\.hpp)\"" "$file" ||
            report "$file" "includes no header that declares what it defines: one of its name, its folder or the one above"
    fi
done < <(find "${rooms[@]}" -name '*.cpp' -not -path 'tests/*' 2>/dev/null)
while read -r count folder; do
    if ((count > most_sources)); then
        report "$folder" "holds $count sources, more than $most_sources"
    fi
done < <(find "${rooms[@]}" -name '*.[ch]pp' 2>/dev/null | sed 's#/[^/]*$##' | sort | uniq -c)

while read -r count file; do
    if [[ $file != total ]] && ((count > most_lines)); then
        report "$file" "has $count lines, more than $most_lines"
    fi
done < <(find "${rooms[@]}" -name '*.[ch]pp' -exec wc -l {} + 2>/dev/null)

for room in "${!most_lines_of_room[@]}"; do
    [[ -d $room ]] || continue
    lines=$(find "$room" -name '*.[ch]pp' -exec cat {} + | wc -l)
    if ((lines > most_lines_of_room[$room])); then
        report "$room" "has $lines lines, more than ${most_lines_of_room[$room]}"
    fi
done

exit "$broken"
