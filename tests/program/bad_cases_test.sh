#!/usr/bin/env bash
# A wrong case is refused: exit code 3; place, value and a correct alternative on standard error, nothing on standard
# output, no result folder. `check`, `run` and, where possible, `fit` print the same.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

write_good_case good.toml
write_good_fit good_fit.toml
write_good_blocks good_blocks.toml
write_good_columns good_columns.toml

# bad WHAT SED MESSAGE: changes the case with a sed script; MESSAGE is the whole of standard error.
bad() {
    bad_of good.toml "$@"
}

# bad_of FILE WHAT SED MESSAGE
bad_of() {
    title "$2"
    sed -E "$3" "$1" >case.toml
    expect "the case was changed" refuse cmp -s "$1" case.toml
    refused_by "$4" check run
}

bad_fit() {
    title "$1"
    sed -E "$2" good_fit.toml >case.toml
    expect "the case was changed" refuse cmp -s good_fit.toml case.toml
    refused_by "$3" check fit
}

refused_by() {
    local message=$1 command
    shift
    for command in "$@"; do
        delabole "$command" case.toml $([[ $command == check ]] || echo --out results)
        expect_status 3
        expect_silence out
        expect_error "$message"
        expect_one_line_of_error
        expect "$command leaves no result folder" refuse test -e results
    done
}

title "the cases that everything below changes are in order"
delabole check good.toml good_fit.toml good_blocks.toml good_columns.toml
expect_status 0

bad "wrong unit" '/^height/s/12 m/12 kPa/' 'case.toml:6:10: slope.height = "12 kPa": '
bad "unit that does not exist" '/^height/s/12 m/12 furlonk/' 'case.toml:6:10: slope.height = "12 furlonk": '
bad "missing unit" '/^height/s/"12 m"/12/' 'case.toml:6:10: slope.height = 12: '
bad "negative height" '/^height/s/12/-3/' 'case.toml:6:10: slope.height = "-3 m": must be more than 0 and at most 1000000 m'
bad "height that is not a number" '/^height/s/"12 m"/nan/' 'case.toml:6:10: slope.height = nan: must be a finite number'
bad "height of 4.3 million km" '/^height/s/12/4.3e9/' 'case.toml:6:10: slope.height = "4.3e9 m": must be more than 0 and at most 1000000 m'
bad "missing key" '/^face_dip/d' 'case.toml:5:1: slope.face_dip: is required'
bad "mistyped model" 's/plane_failure/plane_failrue/' 'case.toml:2:9: model = "plane_failrue": '
bad "not TOML" '/^height/s/=/:/' 'case.toml:6:'

# The values are well formed but describe an impossible slope.
bad "plane steeper than the face" '/^\[failure_plane/,/^dip/s/35/61/' \
    'case.toml:12:7: failure_plane.dip = "61 deg": the failure plane is as steep as the face or steeper: must be less than slope.face_dip = 60 deg'
bad "plane as steep as the face" '/^\[failure_plane/,/^dip/s/35/60/' 'case.toml:12:7: failure_plane.dip = "60 deg": '
bad "water above the crack, as a depth" '/^water_depth/s/3 m/5 m/' \
    'case.toml:29:15: water.water_depth = "5 m": exceeds the depth of the crack, 4.34798 m'
bad "water above the crack, as an elevation" 's/^water_depth.*/water_elevation = "113 m"/' \
    'case.toml:29:19: water.water_elevation = "113 m": is above the top of the crack, elevation 112 m'
bad "water above the base" 's/crack_and_base/base_peak_mid_height/;/^water_depth/s/3 m/9 m/' \
    'case.toml:29:15: water.water_depth = "9 m": exceeds the height of the upper end of the base above the lower end of the base, 7.65201 m'
bad "water above the crack, from the toe" 's/crack_and_base/peak_at_toe/;/^water_depth/s/3 m/13 m/' \
    'case.toml:29:15: water.water_depth = "13 m": exceeds the height of the top of the crack above the lower end of the base, 12 m'
bad "water for a crack that is not there" '/^\[tension_crack/,/^distance/d' \
    'case.toml:24:8: water.kind = "crack_and_base": '
bad "crack deeper than the mass" 's/^distance_behind_crest.*/depth = "8 m"/' \
    'case.toml:16:9: tension_crack.depth = "8 m": nowhere behind the crest is there so much rock above the failure plane: a crack of this dip can be at most 7.14881 m deep'
bad "crack deeper than the slope" 's/^distance_behind_crest.*/base_below_crest = "13 m"/' \
    'case.toml:16:20: tension_crack.base_below_crest = "13 m": the crack is deeper than the slope: its bottom must lie above the toe, less than 12 m below the crest'
bad "crack deeper than the slope, as an elevation" 's/^distance_behind_crest.*/base_elevation = "99 m"/' \
    'case.toml:16:18: tension_crack.base_elevation = "99 m": the crack is deeper than the slope: its bottom must lie above the toe, elevation 100 m'
bad "crack behind the plane" '/^distance/s/4 m/20 m/' \
    'case.toml:16:25: tension_crack.distance_behind_crest = "20 m": lies behind the point where the failure plane meets the ground, 10.2095 m behind the crest'
bad "crack flatter than the plane" '/^\[tension_crack/,/^dip/s/90/30/' \
    'case.toml:15:7: tension_crack.dip = "30 deg": must be more than failure_plane.dip = 35 deg'
bad "plane that never meets the ground" '/^upper_surface_dip/s/0/40/;/^\[tension_crack/,/^distance/d;s/crack_and_base/dry/;/^water_depth/d;/9\.81/d' \
    'case.toml:8:21: slope.upper_surface_dip = "40 deg": the ground behind the crest is as steep as the failure plane'

# Impossible columns on a stepped base.
bad_of good_columns.toml "joints that cannot topple on the base" '/^joint_dip/s/70/50/' \
    'case.toml:12:13: columns.joint_dip = "50 deg": cannot topple on this base: bases normal to the joints dip 40 deg'
bad_of good_columns.toml "base as steep as the face" '/^base_inclination/s/35/65/' \
    'case.toml:14:20: columns.base_inclination = "65 deg": the base is as steep as the face or steeper'
bad_of good_columns.toml "base steeper than the face" '/^base_inclination/s/35/70/' \
    'case.toml:14:20: columns.base_inclination = "70 deg": the base is as steep as the face or steeper'
bad_of good_columns.toml "base that ends above the crest" '/^base_end_height/s/25/61/' \
    'case.toml:15:19: columns.base_end_height = "61 m": the base would end above the ground'
bad_of good_columns.toml "base that never meets the ground" '/^base_end_height/d;/^upper_surface_dip/s/0/36/' \
    'case.toml:14:20: columns.base_inclination = "35 deg": the ground behind the crest is as steep as the base'
bad_of good_columns.toml "columns without a slope" '/^\[slope/,/^upper_surface_dip/d' \
    'columns.kind = "continuous": cuts the columns out of a slope, so [slope] is required'
bad_of good_columns.toml "too many columns" '/^spacing/s/3 m/1 um/' \
    'case.toml:13:11: columns.spacing = "1 um": gives more than 1 000 000 columns'
bad_of good_columns.toml "elevation of water without a datum" 's/^water_depth.*/water_elevation = "15 m"/' \
    'case.toml:30:19: water.water_elevation = "15 m": is an elevation, so slope.toe_elevation is required too'
bad_of good_columns.toml "negative unit weight" '/^unit_weight = "26/s/26/-26/' \
    'case.toml:18:15: rock.unit_weight = "-26 kN/m3": must be more than 0 kN/m3'
bad_of good_columns.toml "cable above the top of its column" '/^height = "1 m"/s/1 m/20 m/' \
    'case.toml:36:10: bolt[1].height = "20 m": lies above the top of column 2'
bad_of good_columns.toml "cable in a column that is not there" '/^block/s/2/40/' \
    'case.toml:33:9: bolt[1].block = 40: there are only'
required_cable='$a [[required_cable]]\nblock = BLOCK\nplunge = "0 deg"\nheight = "HEIGHT"\nfactor_of_safety = 1.2'
asked() {
    local text=${required_cable/BLOCK/$1}
    echo "${text/HEIGHT/$2}"
}
bad_of good_columns.toml "required cable in a column that is not there" "$(asked 99 '1 m')" \
    'required_cable[1].block = 99: there are only'
bad_of good_columns.toml "required cable in half a column" "$(asked 1.5 '1 m')" \
    'required_cable[1].block = 1.5: must be a whole number, 1 at the toe'
bad_of good_columns.toml "required cable above the top of its column" "$(asked 2 '20 m')" \
    'required_cable[1].height = "20 m": lies above the top of column 2, which is'
bad_of good_blocks.toml "required cable in a block that is not there" "$(asked 4 '1 m')" \
    'required_cable[1].block = 4: there are only 3 blocks'
bad_of good_blocks.toml "step higher than the block" '/^step_above = "0.6/s/0.6/3.5/' \
    'case.toml:17:14: columns.block[2].step_above = "3.5 m": a step is higher than the block below it'
bad_of good_blocks.toml "no blocks" '/^\[\[columns.block/,/^step_above/d' 'needs at least one [[columns.block]]'
bad_of good_blocks.toml "weight of one block negative" '/^step_above = "0.6/s/$/\nunit_weight = "-1 kN\/m3"/' \
    'case.toml:18:15: columns.block[2].unit_weight = "-1 kN/m3": must be more than 0 kN/m3'
bad_of good_blocks.toml "cable in a block that is not there" '/^block = 2/s/2/4/' \
    'case.toml:38:9: bolt[1].block = 4: there are only 3 blocks'
bad_of good_blocks.toml "cable in half a block" '/^block = 2/s/2/2.5/' \
    'case.toml:38:9: bolt[1].block = 2.5: must be a whole number'
bad_of good_blocks.toml "cable above the top of its block" '/^height = "1.5 m"/s/1.5/3.5/' \
    'case.toml:41:10: bolt[1].height = "3.5 m": lies above the top of column 2, which is 3 m high'
bad "crack under a pond, with less water than the pond gives it" '$a [pond]\ndepth = "11 m"\nunit_weight = "9.81 kN/m3"' \
    'case.toml:29:15: water.water_depth = "3 m": the water states less pressure than the pond, pond.depth = 11 m, gives where the plane daylights or at the bottom of the crack: must be at least 3.34799 m'
bad "level at the toe under a pond" 's/^kind = "crack_and_base"/kind = "peak_at_toe"/;/^water_depth/s/3/0/;$a [pond]\ndepth = "12 m"\nunit_weight = "9.81 kN/m3"' \
    'case.toml:29:15: water.water_depth = "0 m": the water states less pressure than the pond, pond.depth = 12 m, gives where the plane daylights or at the bottom of the crack: must be at least 12 m'

title "kinematics: ranges reversed, azimuths and frictions that are none, no joint set, an unknown key"
delabole init kinematics --full --out sets.toml
expect_status 0
bad_sets() {
    title "$1"
    sed -E "$2" sets.toml >case.toml
    expect "the case was changed" refuse cmp -s sets.toml case.toml
    refused_by "$3" check run
}
bad_sets "range of dips reversed" '0,/^lower_dip/s/^lower_dip = "[^"]*"/lower_dip = "80 deg"/' \
    'joint_set[1].lower_dip = "80 deg": range is reversed: must be at most joint_set[1].upper_dip'
bad_sets "azimuth beyond north" '/^face_dip_direction/s/"[^"]*"/"400 deg"/' \
    'slope.face_dip_direction = "400 deg": must be from 0 to 360 deg'
bad_sets "friction of a wall" '/^friction_angle/s/"[^"]*"/"95 deg"/' \
    'strength.friction_angle = "95 deg": must be at least 0 and less than 90 deg'
bad_sets "no joint set" '/^\[\[joint_set/,$d' 'case.toml:1:1: joint_set: is required: at least one [[joint_set]], or measured [[poles]]'
bad_sets "unknown key" '/^friction_angle/a cohesion = "5 kPa"' 'strength.cohesion: is not a key of strength'

title "single block: water above its top, a vertical base; row: no block, two weights, friction of a wall"
delabole init single_block --full --out block.toml
expect_status 0
delabole init block_row --full --out row.toml
expect_status 0
bad_of block.toml "water above the block" \
    '$a [water]\nunit_weight = "9.81 kN/m3"\ndepth_behind = "4 m"' \
    'water.depth_behind = "4 m": exceeds the height of the block, 3 m'
bad_of block.toml "vertical base" '/^inclination/s/"[^"]*"/"90 deg"/' \
    'base.inclination = "90 deg": must be at least 0 and less than 90 deg'
bad_of row.toml "no block" '/^\[\[block/,$d' 'case.toml:1:1: block: is required: at least one [[block]]'
bad_of row.toml "friction of a wall" '0,/^friction_angle/s/^friction_angle = "[^"]*"/friction_angle = "95 deg"/' \
    'friction_angle = "95 deg": must be from 0 to 89.9 deg'
bad_of row.toml "weightless block" '0,/^unit_weight/s/^unit_weight = "[^"]*"/unit_weight = "0 kN\/m3"/' \
    'block[1].unit_weight = "0 kN/m3": must be more than 0 kN/m3'

title "dynamic relaxation: blocks that overlap, run clockwise, are all fixed, too soft or not there"
delabole init relaxation --full --out relaxation.toml
expect_status 0
cat >blocks.toml <<'CASE'
schema = 1
model = "relaxation"
[scene]
kind = "blocks"
tilt = "5 deg"
[[scene.joint]]
friction_angle = "30 deg"
[[scene.block]]
density = "2700 kg/m3"
vertex = [{ x = "0 m", y = "0 m" }, { x = "1 m", y = "0 m" }, { x = "0 m", y = "1 m" }]
[[scene.block]]
density = "2700 kg/m3"
hold = "fixed"
vertex = [{ x = "-2 m", y = "-1 m" }, { x = "3 m", y = "-1 m" }, { x = "3 m", y = "0 m" }, { x = "-2 m", y = "0 m" }]
CASE
delabole check relaxation.toml blocks.toml
expect_status 0
bad_of blocks.toml "blocks that overlap" '10s/y = "0 m"/y = "-0.1 m"/g' \
    'case.toml:10:10: scene.block[1].vertex: block 1 and block 2 overlap in the drawing'
bad_of blocks.toml "corners clockwise" '10s/"1 m", y = "0 m"/"-1 m", y = "0 m"/' \
    'case.toml:10:10: scene.block[1].vertex: block 1 is not convex, or its corners run clockwise'
bad_of blocks.toml "nothing free" '9s/$/\nhold = "fixed"/' 'every block is fixed: nothing can move'
bad_of blocks.toml "joint that is not there" '9s/$/\njoint = 2/' \
    'case.toml:10:9: scene.block[1].joint = 2: must be the number of a [[scene.joint]], 1 to 1'
bad_of blocks.toml "joint like a cushion" '/^friction/s/$/\nnormal_stiffness = "1 N\/m\/m"/' \
    'block 1 would sink into its joint by more than a tenth of its size: raise the stiffness'
bad_of relaxation.toml "density without its unit" '/^density/s/"[^"]*"/2700/' 'scene.density = 2700: has no unit: a density is expected'

title "what the message allows is accepted"
sed '/^water_depth/s/3 m/4.34798 m/' good.toml >case.toml
delabole check case.toml
expect_status 0
sed -E 's/^distance_behind_crest.*/depth = "7.14881 m"/;/^water_depth/s/3 m/1 m/' good.toml >case.toml
delabole check case.toml
expect_status 0

title "a value given by --set is blamed as such"
delabole run good.toml --set 'water.water_depth=5 m' --out results
expect_status 3
expect_error '--set: water.water_depth = "5 m": exceeds the depth of the crack, 4.34798 m'
expect_one_line_of_error
delabole run good.toml --set slope.heigth=5 --out results
expect_status 3
expect_error 'did you mean'
delabole run good.toml --set slope.height --out results
expect_status 3
expect_error 'is not of the form key=value'
expect "no result folder" refuse test -e results

bad_fit "bounds reversed" '/^lower = "15/s/15/65/' \
    'fit.parameter[1].lower = "65 deg": bounds are reversed: lower must not exceed upper = "60 deg"'
bad_fit "empty observations" '/^\[\[fit.observation/,/^standard_deviation/d' 'fit: has no observations'
bad_fit "zero standard deviation" '/^standard_deviation/s/0\.05/0/' \
    'fit.observation[1].standard_deviation = 0: must be more than 0'
bad_fit "unknown key of the posterior" '/^seed/a [fit.posterior]\nchians = 4' 'fit.posterior.chians: is not a key of fit.posterior (did you mean chains?)'
bad_fit "one chain" '/^seed/a [fit.posterior]\nchains = 1' 'must be a whole number from 2 to 1000'
bad_fit "unknown algorithm" '/^algorithm/s/sbplx/sbplex/' 'fit.algorithm = "sbplex": '
bad_fit "no free parameter" '/^\[\[fit.parameter/,$d' 'has nothing free'
bad_fit "quantity that no model has" 's/^quantity.*/quantity = "factor_of_safty"/' 'did you mean factor_of_safety?'
bad_fit "free parameter that is no input" 's/^name = "water.water_depth"/name = "water.water_deepth"/' \
    'did you mean water.water_depth?'

title "a mistyped key: place and suggestion"
sed 's/^title/tilte/;s/^face_dip/face_dpi/' good.toml >case.toml
delabole check case.toml
expect_status 3
expect_error 'case.toml:3:1: tilte: is not a key of a case of this model (did you mean title?)'
expect_error 'case.toml:7:1: slope.face_dpi: is not a key of slope (did you mean face_dip?)'
expect_error 'case.toml:5:1: slope.face_dip: is required'

title "several errors are shown at once, in the order of the file"
sed -E '/^height/s/12 m/-3 m/;/^cohesion/s/kPa/m/;/^unit_weight = "26/s/26 kN\/m3/heavy/' good.toml >case.toml
delabole run case.toml --out results
expect_status 3
expect "three lines" test "$(wc -l <"$scratch/err")" == 3
expect "in order" test "$(cut -d: -f2 "$scratch/err" | tr '\n' ' ')" == "6 19 23 "
expect "no result folder" refuse test -e results

title "several cases: one that is wrong stops all before the first is analysed; check goes through all"
delabole run good.toml case.toml
expect_status 3
expect "no result folder" refuse test -e results
delabole check good.toml case.toml good_fit.toml
expect_status 3
expect_output 'good.toml: ok'
expect_output 'good_fit.toml: ok'
delabole check --json good.toml case.toml
expect_status 3
cp "$scratch/out" check.json
expect "JSON in spite of errors" is_json check.json
expect_output '"status": "invalid"'

title "an earlier result survives a case that is refused"
delabole run good.toml --out results --quiet
expect_status 0
cp -r results before
delabole run case.toml --out results
expect_status 3
expect "nothing has changed" diff -r before results

# Files that cannot be read. A user may give any of these names by mistake; the program must not wait for any of them.
unreadable() {
    title "$1"
    local command
    for command in check run show fit verify; do
        run timeout 300 "$program" "$command" "$2"
        expect_status 3
        expect_silence out
        expect_error "$3"
        expect_one_line_of_error
    done
}
rm -rf results
mkdir folder.toml
ln -s nowhere dangling.toml
ln -s loop.toml loop.toml
mkfifo pipe.toml
head -c 5000000 /dev/zero | tr '\0' '#' >huge.toml
head -c 3000 /dev/urandom >random.toml
: >empty.toml
unreadable "missing file" missing.toml 'missing.toml: there is no such file'
unreadable "dangling link" dangling.toml 'dangling.toml: there is no such file'
unreadable "link to itself" loop.toml 'loop.toml: cannot be read'
unreadable "pipe" pipe.toml 'pipe.toml: is not an ordinary file'
unreadable "device" /dev/zero '/dev/zero: is not an ordinary file'
unreadable "path through a file" good.toml/case.toml 'good.toml/case.toml: '
unreadable "huge file" huge.toml 'huge.toml: is larger than 4 MiB'
unreadable "not text" random.toml 'random.toml'
title "folder (verify looks into it)"
for command in check run show fit; do
    delabole "$command" folder.toml
    expect_status 3
    expect_error 'folder.toml: is a folder, not a case file'
done
delabole verify folder.toml
expect_status 3
expect_error 'there is nothing to compare'
title "likely mistakes in lines that are no TOML"
sed 's/^height = "12 m"/height = 12,5/' good.toml >comma.toml
sed 's/^height = "12 m"/height = "12 m/' good.toml >quote.toml
delabole check comma.toml
expect_status 3
expect_error '(numbers have a decimal point, no comma)'
delabole check quote.toml
expect_status 3
expect_error '(a quotation mark may be missing in this line)'
title "empty file"
delabole check empty.toml
expect_status 3
expect_error 'schema: is required'
expect "no result folder" refuse test -e results

if [[ $(id -u) != 0 ]]; then
    title "file that may not be read"
    cp good.toml secret.toml
    chmod 000 secret.toml
    unreadable "no permission" secret.toml 'secret.toml: cannot be read'
else
    title "file that may not be read: not checked, as nothing is hidden from root"
fi

finish
