#!/usr/bin/env bash
# What each command writes and prints: the files of a result folder, tables or JSON or nothing on standard output, --set
# and --seed in the provenance, folders with any name.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

write_good_case good.toml
write_good_fit good_fit.toml

title "run: table on standard output, folder named after the case"
delabole run good.toml
expect_status 0
expect_silence err
expect_output 'factor_of_safety'
expect_output 'report in results/good/report.html'
expect_complete_results results/good
expect_only_numbers results/good
expect_figures results/good 3
expect_result_is_newest results/good
expect "a table of results" contains results/good/results.csv 'factor_of_safety,'
expect "a table of sensitivities" contains results/good/sensitivities.csv 'slope.height,'
expect "status" test "$(json_value results/good/result.json status)" == '"ok"'
expect "a factor of safety" grep -qE '"factor_of_safety": 1\.24[67]' results/good/result.json
expect "the unit is in the name" contains results/good/result.json '"crack_depth_m": 4.34'

title "run: the answer comes first, on the terminal and in the report, and --set shows"
delabole run good.toml --set water.water_depth='0 m' --out changed
expect_status 0
expect "the title says what was set" grep -qF '[water.water_depth = 0 m]' "$scratch/out"
expect "so does the report's" grep -qF '[water.water_depth = 0 m]</h1>' changed/report.html
expect "the second line is the verdict" grep -qE '^FS [0-9.]+: (stands|fails by sliding)[.]$' <(sed -n 2p "$scratch/out")
expect "the head of the report as well" grep -qE '^<p>FS [0-9.]+: (stands|fails by sliding)[.]</p>$' changed/report.html
expect "no prediction after a failure that did not happen" refuse grep -q 'predicted after' changed/report.html

title "run and sensitivity: the cheapest support, and how likely it fails"
delabole init support --out support.toml
delabole run support.toml --out support
expect_status 0
expect_output 'Of 180 patterns the cheapest for FS 2: '
expect "rows are counted" grep -qE 'FS 2: [0-9]+ rows?, ' "$scratch/out"
expect "it gives that factor" awk -F'[:, ]+' '/"factor_of_safety"/ { exit !($3 >= 2) }' \
    <(sed -n '/"support_design"/,/}/p' support/result.json)
expect_output 'With these bolts FS 2'
expect_output 'instead of FS 1.54 without these bolts'
expect "rows, whole numbers, have no derivative" refuse grep -qF '[1].rows' support/sensitivities.csv
expect "all that were tried" test "$(wc -l <support/support.csv)" -gt 10
expect "the report says so as well" contains support/report.html 'Of 180 patterns the cheapest'
expect "and the case that was analysed holds it" refuse cmp -s \
    <(grep -A9 '^\[\[support\]\]' support.toml | grep '^rows\|^length') <(grep '^rows\|^length' support/resolved.toml)
delabole run support.toml --set support_design.choose='[{ input = "support[1].rows", from = 3, to = 5, points = 3 }]' \
    --no-report
expect_output '; cheaper ones may lie beyond the range of support[1].rows.'
delabole grid support.toml --vary 'rock.unit_weight=26 kN/m3,27 kN/m3' --out grid_of_support
expect_status 0
expect_output 'Of 180 patterns the cheapest for FS 2'
weight=$(sed -n "/^unit_weight/s/.*= \"\([0-9]*\).*/\1/p" support.toml | head -n 1)
expect "a grid has the same pattern as the run" test "$(awk -F, -v at="$weight" '$1 == at { printf "%.6g", $2 }' \
    grid_of_support/grid.csv)" == "$(awk -F'[:, ]+' '/"factor_of_safety"/ { printf "%.6g", $3; exit }' support/result.json)"
delabole compare support.toml support.toml --out same_support
expect_status 0
delabole run support.toml --set support_design.factor_of_safety=50 --out too_much
expect_status 0
expect_output 'None of 180 patterns gives FS 50 (choose beyond the range of support[1].rows and support[1].spacing, or '
expect_output 'give the bolts more capacity); the strongest, shown here: 5 rows, spacing 1.5 m, '
high='[{ input = "support[1].lowest_height", from = "13 m", to = "20 m", points = 3 }]'
for command in run sensitivity; do
    delabole $command support.toml --set support_design.choose="$high" --out too_high
    expect_status 0
    expect_output 'None of 3 patterns of support has an answer (bolt head above crest 3)'
    expect "$command: the report says so" contains too_high/report.html 'None of 3 patterns of support has an answer'
    expect "$command: so does result.json" contains too_high/result.json '"bolt_head_above_crest": 3'
done
delabole sensitivity support.toml --out support_probability
expect_status 0
expect_order support_probability/report.html '<section class="head' 'Probability of failure' \
    '>The slope with the values of the case</h2>' 'The slope and what slides.' '>Distribution of the factor of safety</h2>'
expect_output 'Of 180 patterns the cheapest for FS 2'
expect_output 'Probability of failure'
delabole run support.toml --set support_design.choose='[{ input = "support[1].rows", from = 1, to = 4, points = 3 }]'
expect_status 3
expect_error 'makes numbers of rows that are not whole'
delabole run good.toml --set support_design.factor_of_safety=2
expect_status 3
delabole sensitivity "$source_folder/cases/stepped_base/bolted_columns.toml" --out bolted_columns --no-report
expect_status 0
expect_output 'Of 252 patterns the cheapest for FS 1.1'
expect_output 'Probability of failure'
delabole init block_row --out row.toml
delabole run row.toml --set support='[{ rows = 2 }]'
expect_status 3
expect_error 'support: is not a key of a case of this model; it belongs to plane_failure, stepped_base and relaxation'
bar="plunge = '10 deg'\nlength = '8 m'\nspacing = '2 m'\naxial_stiffness = '100 MN'\ncapacity = '200 kN'\n"
delabole init jointed_slope --out unbolted.toml
sed -i '/^\[critical\]/,$d' unbolted.toml
{ cat unbolted.toml; printf "[settings]\nduration = '0.02 s'\n[[support]]\nrows = 1\nlowest_height = '6 m'\nrow_spacing = '2 m'\n$bar"; } >row_of_one.toml
{ cat unbolted.toml; printf "[settings]\nduration = '0.02 s'\n[[bolt]]\nhead_x = '3 m'\nhead_y = '6 m'\n$bar"; } >single_bolt.toml
delabole run row_of_one.toml single_bolt.toml --no-report
expect_output 'Bolt 1 pulls most at the end'
expect "a row of one is the same as the single bolt" cmp results/row_of_one/results.csv results/single_bolt/results.csv
{ "$program" init relaxation; printf '[[support]]\nrows = 2\nlowest_height = "1 m"\nrow_spacing = "1 m"\n'; echo -e "$bar"; } >rows_in_a_row.toml
delabole check rows_in_a_row.toml
expect_error 'in other scenes each bolt is a [[bolt]] with head_x and head_y'
{ cat row_of_one.toml; printf '[support_design]\nfactor_of_safety = 1.2\ncost_per_bolt = 150\ncost_per_metre = 40\nchoose = [{ input = "support[1].rows", from = 1, to = 2, points = 2 }]\n'; } >designed_blocks.toml
delabole check designed_blocks.toml
expect_error 'support_design: belongs to plane_failure and stepped_base'
{ "$program" init jointed_slope; printf '\n[controls]\nwatch = "4 s"\n'; } >controls.toml
delabole check controls.toml
expect_error 'controls: is not a key of a case of this model (did you mean settings.watch?)'

title "run: feet and kips in the report, metres in the files"
for name in good support; do
    { cat $name.toml; printf '\n[report]\nunits = "imperial"\n'; } >imperial_$name.toml
done
mv imperial_good.toml imperial.toml
delabole run imperial_support.toml --out imperial_support
expect_output 'per foot of slope'
expect "the figure too" contains imperial_support/figures/support.gp 'cost per foot of slope'
delabole run "$source_folder/cases/relaxation/two_blocks_3.toml" --set 'report.units="imperial"' --out imperial_blocks
expect "small movements are in inches" grep -qE '<td[^>]*>-?[0-9.e-]+ in</td>' imperial_blocks/report.html
delabole run imperial.toml --out imperial
expect_status 0
expect "sentences" grep -qE 'kip/ft drive' "$scratch/out"
expect "axes" contains imperial/figures/section.gp 'distance from the toe (ft)'
expect "none left in metres" refuse grep -qE '[0-9] (m|m2|kPa|kN/m|kN/m3)(<| |,|[.])' imperial/report.html
expect "files are metric" contains imperial/result.json '"crack_depth_m": 4.34'
expect "what was set is kept" contains imperial/resolved.toml 'units = "imperial"'
delabole run good.toml --out metric --no-report
expect "and the next is metric again" grep -qE 'kN/m drive' "$scratch/out"

title "run: what has no meaning has no number, and a height beyond all mountains is asked about"
delabole run good.toml --set slope.height='40 km' --out high --no-report
expect_output 'warning: slope.height is 40000 m high: is that meant?'
expect_silence err
delabole check good.toml --set slope.height='40 km'
expect_status 0
expect_error 'good.toml: slope.height is 40000 m high: is that meant?'
delabole check good.toml --set rock.unit_weight='26 N/m3'
expect_status 0
expect_error 'good.toml: rock.unit_weight is 0.026 kN/m3: is that meant?'

title "check: what is nearly an output is asked about"
{ cat good.toml; printf '\n[[expect]]\nquantity = "factor_of_safty"\nvalue = 1\ntolerance = 0.1\n'; } >misspelt.toml
delabole check misspelt.toml
expect_status 0
expect_error ': is factor_of_safty an output of the model? (did you mean factor_of_safety?)'

title "run: a slope whose factor of safety is infinite"
delabole run good.toml --set failure_plane.dip='0 deg' --set water.water_depth='0 m' --out level --no-report
if [[ $status == 0 ]]; then
    expect_only_numbers level
    expect "said in a word" contains level/result.json '"infinite"'
else
    expect_status 3
fi

title "grid: an output over one input, on the screen and as CSV; over two, a map"
delabole grid good.toml --vary "water.water_depth=0 m:4 m:5" --vary "strength.cohesion=0 kPa, 25 kPa" --out grid
expect_status 0
expect_output '10 points in grid.csv'
expect_figures grid 1
expect_only_numbers grid
expect "the answer comes first" contains grid/report.html '<p>Factor of safety '
expect "the figure says what it shows" contains grid/figures/grid.gp 'Factor of safety against water depth and cohesion'
delabole grid good.toml --vary "strength.friction_angle=20 deg:60 deg:9" --out curve
expect "where it is 1" grep -qE 'Factor of safety [0-9.]+ to [0-9.]+; 1 at strength.friction_angle = [0-9.]+ deg\.' curve/report.html
expect "all points" test "$(wc -l <grid/grid.csv)" == 11
expect "inputs and outputs with their units" contains grid/grid.csv 'water.water_depth_m,strength.cohesion_kPa,factor_of_safety'
delabole grid good.toml --vary "water.water_depth=0 m:4 m:3" --output weight --output outcome --json
expect_status 0
expect "JSON" is_json "$scratch/out"
expect_output '"weight_kN_per_m": '
expect "beside the result of run, not in its place" test -s results/good_grid/grid.csv
delabole grid good.toml --vary "water.water_depth=0 m:4 m:12" --vary "strength.cohesion=0 kPa:25 kPa:11" --out map
expect_status 0
expect_figures map 1
delabole grid good.toml --vary "strength.friction_angle=15 deg:40 deg:9" --vary "strength.cohesion=0 kPa:25 kPa:9" --out map
expect "where the factor of safety is 1" contains map/figures/grid.svg 'factor of safety 1'
for wrong in "water.water_depth" "water.water_depth=1 m" "water.water_depth=1 m:2 m:3:4"; do
    delabole grid good.toml --vary "$wrong"
    expect_status 2
done
delabole grid good.toml --vary "water.water_dept=0 m:4 m"
expect_status 3
expect_error 'vary: water.water_dept: is not an input of this case (did you mean water.water_depth?)'
delabole grid good.toml --vary "strength.cohesion=0:50:5"
expect "nothing is said of an order that is not known" refuse grep -q 'the last value' "$scratch/err"
delabole grid "$source_folder/cases/relaxation/single_block.toml" --vary settings.stiffness_ratio=1e3,1e6 --output critical_tilt --out keys --no-report
expect_status 0
expect "a key that is no input" contains keys/grid.csv 'settings.stiffness_ratio,critical_tilt_deg'
delabole grid good.toml --vary "water.water_depth=0 m:4 m:3" --vary "water.water_depth=0 m:4 m:3"
expect_status 3
expect_error '"water.water_depth": varies twice in the sweep'
delabole grid good.toml --vary "water.water_depth=0 m:4 m:3" --output factor
expect_status 3
expect_error '--output factor: is not an output of this case'

title "compare: what differs in inputs and outputs"
sed 's/^cohesion = .*/cohesion = "30 kPa"/' good.toml >other.toml
expect "the case was changed" refuse cmp -s good.toml other.toml
delabole compare good.toml other.toml
expect_status 0
expect_output 'strength.cohesion'
expect_output 'factor_of_safety'
expect "nothing that is the same" refuse grep -q crack_depth "$scratch/out"
sed 's/kind = "crack_and_base"/kind = "crack_only"/' good.toml >drained.toml
expect "the kind of water was changed" refuse cmp -s good.toml drained.toml
delabole compare good.toml drained.toml
expect_status 0
expect_output 'water.kind'
delabole compare good.toml other.toml --out compared
expect_status 0
expect_figures compared 2
expect "both answers and what differs" grep -qE '<p>They differ in strength.cohesion 25 kPa against 30 kPa' compared/report.html
expect "as a table" contains compared/compare.csv 'strength.cohesion,25,30,5,kPa'
expect "of nothing but what differs" refuse grep -q 'the same' compared/compare.csv
sed '/^height/s/12 m/39.370078740157 ft/' good.toml >feet.toml
expect "the unit was changed" refuse cmp -s good.toml feet.toml
for other in good feet; do  # the height in feet differs by rounding alone
    delabole compare good.toml $other.toml --json
    expect_status 0
    expect "no input differs" grep -q '"inputs": \[\]' "$scratch/out"
done

title "run draws the sweeps of a case"
cat good.toml - >swept.toml <<'CASE'

[[sweep]]
name = "water"
output = "factor_of_safety"

[[sweep.vary]]
input = "water.water_depth"
from = "0 m"
to = "4 m"

[[sweep.statement]]
label = "more water"
curve = "factor_of_safety"
is = "falls"
CASE
delabole run swept.toml
expect_status 0
expect "drawn" test -s results/swept/figures/water.svg
expect "its points" test "$(wc -l <results/swept/water.csv)" == 102
expect "compared" grep -q '"verdict": "ok"' results/swept/result.json
delabole verify swept.toml
expect_status 0
expect_output 'more water'
sed 's/is = "falls"/is = "rises"/' swept.toml >wrong.toml
delabole verify wrong.toml
expect_status 1

title "fit"
delabole fit good_fit.toml
expect_status 0
expect_output 'report in results/good_fit_fit/report.html'
expect_complete_results results/good_fit_fit
expect_only_numbers results/good_fit_fit
expect_figures results/good_fit_fit 3
expect_result_is_newest results/good_fit_fit
expect "status" test "$(json_value results/good_fit_fit/result.json status)" == '"converged"'
expect "the seed of the case is recorded" contains results/good_fit_fit/resolved.toml 'seed = 7'

title "fit needs a [fit] section"
delabole fit good.toml --out none
expect_status 3
expect_error 'good.toml: fit: the case has no [fit] section'
expect_one_line_of_error
expect "no folder" refuse test -e none

title "trade"
delabole trade "$source_folder/cases/relaxation/single_block.toml" --set 'critical.tolerance=0.1 deg'
expect_status 0
expect_output 'Errors are differences from 18.4349 deg'
expect_output 'report in results/single_block_trade/report.html'
expect_complete_results results/single_block_trade
expect_only_numbers results/single_block_trade
expect_figures results/single_block_trade 1
expect_result_is_newest results/single_block_trade
expect "status" test "$(json_value results/single_block_trade/result.json status)" == '"finished"'
expect "a line for each setting" test "$(wc -l <results/single_block_trade/trade.csv)" -ge 30
expect "some on the front" grep -q ',yes,' results/single_block_trade/trade.csv

title "trade without an expected value takes the finest setting for it, and says so"
sed '/^\[\[expect\]\]/,$d' "$source_folder/cases/relaxation/single_block.toml" >unexpected.toml
delabole trade unexpected.toml --set 'critical.tolerance=0.1 deg' --no-report
expect_status 0
expect_output 'what the finest setting found, for want of an [[expect]] of critical_tilt'

title "trade needs a relaxation with a [critical] section"
delabole trade good.toml --out none
expect_status 3
expect_error 'good.toml:2:9: model = "plane_failure": only a relaxation has numerical settings'
expect_one_line_of_error
sed '/^\[critical\]/,$d' "$source_folder/cases/relaxation/single_block.toml" >uncritical.toml
delabole trade uncritical.toml --out none
expect_status 3
expect_error 'uncritical.toml: critical: the case has no [critical] section'
expect_one_line_of_error
expect "no folder" refuse test -e none

title "run: columns one by one, in the files and not on the screen"
write_good_blocks blocks.toml
delabole run blocks.toml --out blocks
expect_status 0
expect "no column on the screen" refuse contains "$scratch/out" 'column['
expect "columns in the result" contains blocks/result.json 'column[3].lower_force_kN_per_m'
expect "a table of them" contains blocks/columns.csv 'limiting,3,'
expect_figures blocks 5

title "--set works and is recorded"
delabole run good.toml --set water.water_depth='2 m' --set strength.friction_angle=40deg --out set
expect_status 0
expect "recorded" contains set/result.json 'water.water_depth=2 m'
expect "recorded in the report" contains set/report.html 'water.water_depth=2 m'
expect "resolved" contains set/resolved.toml 'water_depth = "2 m"'
expect "the result differs" test "$(json_value set/result.json factor_of_safety)" != \
    "$(json_value results/good/result.json factor_of_safety)"
sed 's/water_depth = "3 m"/water_depth = "2 m"/;s/37 deg/40 deg/' good.toml >edited.toml
delabole run edited.toml --out edited --no-report
for key in factor_of_safety case_hash weight_kN_per_m; do
    expect "the same $key as of the edited case" test "$(json_value set/result.json $key)" == \
        "$(json_value edited/result.json $key)"
done

title "--seed is recorded and replaces that of the case"
delabole fit good_fit.toml --seed 12345 --out seeded --quiet --no-report
expect_status 0
expect "recorded" test "$(json_value seeded/result.json seed)" == 12345

title "the fit of one mechanism begins with its values and how well they are known; zeros are zeros"
delabole init fit --out fit_start.toml
delabole fit fit_start.toml --out fit_start
head_card=$(grep -A3 -m1 'Best fit with' fit_start/report.html)
for phrase in 'Best fit with the priors: friction angle 35.9' '(30.9' 'to 39.6' 'at most 12.1' \
    'Friction angle and cohesion: only one combination is determined: along the line FS = 1' 'deg in friction angle is offset'; do
    expect "its head card has: $phrase" grep -qF -- "$phrase" <<<"$head_card"
done
expect "and no names of keys" refuse grep -qF 'strength.' <<<"$head_card"
expect "no ranking of one" refuse grep -q 'one mechanism that was fitted' fit_start/report.html
expect "a title of what is drawn" contains fit_start/figures/*_section.gp 'The slope at the best point'
expect "no rounding" test -z "$(awk -F, 'NR > 1 && (($3 != 0 && $3 < 1e-9) || ($5 != 0 && $5 < 1e-10))' fit_start/*_profiles.csv)"

title "--quiet prints nothing, and writes the same"
for arguments in "run good.toml" "fit good_fit.toml" "reproduce tilting" "verify $source_folder/cases/stepped_base" "check good.toml"; do
    # shellcheck disable=SC2086
    delabole $arguments --quiet
    expect_status 0
    expect_silence out
    expect_silence err
done

title "--json prints JSON and nothing else, the same as result.json"
for arguments in "run good.toml --out json" "fit good_fit.toml --out json" "reproduce fig2.8 --out json"; do
    # shellcheck disable=SC2086
    delabole $arguments --json
    expect_status 0
    expect_silence err
    cp "$scratch/out" printed.json
    expect "JSON" is_json printed.json
    expect "the same as in the file" cmp printed.json json/result.json
    # shellcheck disable=SC2086
    delabole $arguments --json --quiet --no-report
    expect "JSON when quiet, too" is_json "$scratch/out"
done
for arguments in "check good.toml good_fit.toml" "show good.toml" "verify $source_folder/cases/stepped_base"; do
    # shellcheck disable=SC2086
    delabole $arguments --json
    expect_status 0
    cp "$scratch/out" printed.json
    expect "JSON" is_json printed.json
done

title "show prints a case; init prints one that is in order, for each model"
delabole show good_fit.toml
expect_status 0
cp "$scratch/out" shown.toml
delabole show shown.toml
expect "showing what is shown changes nothing" cmp "$scratch/out" shown.toml
for model in plane_failure stepped_base single_block block_row tilted_column kinematics flexural_toppling wedge; do
    delabole init "$model"
    expect_status 0
    cp "$scratch/out" "$model.toml"
    delabole init "$model" --out "written_$model.toml"
    expect_status 0
    expect_silence out
    expect "the same in a file" cmp "$model.toml" "written_$model.toml"
    expect "25 lines at most" test "$(wc -l <"$model.toml")" -le 25
    delabole check "$model.toml"
    expect_status 0
    delabole run "$model.toml" --out "result_$model" --no-report
    expect_status 0
    delabole init "$model" --full --out "full_$model.toml"
    expect_status 0
    delabole run "full_$model.toml" --out "result_$model"
    expect_status 0
    expect_complete_results "result_$model"
    expect_only_numbers "result_$model"
    expect_zeros_are_zeros "result_$model"
done
for name in stepped_path relaxation jointed_slope; do
    expect "$name: 25 lines at most" test "$("$program" init "$name" | wc -l)" -le 25
done
for study in fit sensitivity; do
    delabole init "$study" --out "$study.toml"
    expect_status 0
    delabole "$study" "$study.toml" --out "result_$study"
    expect_status 0
done
delabole init jointed_slope --out jointed_slope.toml
delabole run jointed_slope.toml --no-report
expect_status 0  # a starting case has an answer
expect_output 'FS 0.83'

title "init: the joint sets found in measured poles cut a slope, by the command that their report says"
delabole run "$source_folder/cases/kinematics/road_cut_poles.toml" --out "poles of a cut"
command=$(grep -o "delabole init jointed_slope --sets .* --out my_slope.toml" "poles of a cut/report.html" | sed "s/&#39;/'/g")
run bash -c "\"$program\" ${command#delabole }"
expect_status 0
delabole run my_slope.toml --no-report
expect_status 0
expect_output ': fails.'
expect "the face is that of the study" grep -qF 'x = "4.37 m", y = "12 m"' my_slope.toml  # 12 m / tan 70 deg
expect "apparent dips are the cuts', but of the set that strikes along the section" test \
    "$(grep -o 'dip = "[^ ]*' my_slope.toml | cut -d'"' -f2 | xargs printf '%.1f ')" == \
    "$(awk -F, 'NR > 1 && $1 != "set_3" { printf "%.1f ", $4 }' 'poles of a cut/joint_sets.csv')"
expect "the title tells the study" grep -qF 'title = "Joint sets found in the poles of a road cut: a slope cut by' my_slope.toml
expect "how well a mean is known stands beside it" grep -qE 'mean is known to [0-9.]+ deg with 95 %$' my_slope.toml
expect "every pole has its set, or none" test "$(awk -F, 'NR > 1 { all++; none += $5 == "" } END { print all, none }' \
    'poles of a cut/poles.csv')" == "100 $(awk -F, '$1 == "poles.without_set" { print $2 }' 'poles of a cut/results.csv')"
expect "which is named" grep -qF 'strike within 30 deg of it: "set_3".' my_slope.toml
delabole init jointed_slope --sets "$source_folder/cases/kinematics/road_cut_poles.toml"
expect "the case does as well as its results" cmp "$scratch/out" my_slope.toml
delabole init jointed_slope --sets good.toml
expect_status 2
expect_error 'joint sets are those of one of model kinematics'
delabole init wedge --sets "poles of a cut"
expect_status 2
expect_error '--sets belongs to jointed_slope, not to wedge'
printf '[[joint_set]]\nname = "only"\ndip = "80 deg"\ndip_direction = "185 deg"\n' |
    cat <(sed '/^joint_set = \[/,/^\]/d' kinematics.toml) - >one_set.toml
delabole init jointed_slope --sets one_set.toml
expect_status 2
expect_error 'no joint set crosses the section across the face'

title "inputs and outputs are listed for a model and for a case, and as JSON"
for name in jointed_slope fit sensitivity support; do
    delabole inputs "$name"
    expect_status 0
    expect_output 'friction_angle '
done
delabole inputs plane_failure
expect_output 'strength.friction_angle '
delabole inputs good.toml --json
expect "JSON" is_json "$scratch/out"
delabole outputs plane_failure
expect_output 'factor_of_safety '
delabole outputs good.toml --json
expect "JSON" is_json "$scratch/out"

title "a case from standard input; --set chooses another kind; neither report nor figures"
run bash -c '"$0" run - --no-report <plane_failure.toml' "$program"
expect_status 0
expect "answers" test -s results/stdin/result.json
expect "no report" test ! -e results/stdin/report.html
expect "no figures" test ! -e results/stdin/figures
delabole run plane_failure.toml --set strength.kind=stepped_surface --set strength.roughness_angle="40 deg" --no-report
expect_status 0
delabole run full_plane_failure.toml --set water.kind=dry --no-report
expect_status 0
delabole run "$DELABOLE_SOURCE/cases/relaxation/free_slide.toml" --no-report --out bare_motion
expect_status 0
expect "frames" test -s bare_motion/frames/run_blocks.pvd
delabole run "$DELABOLE_SOURCE/cases/relaxation/retreating_slope.toml" --no-report --out retreat
expect_status 0
expect "the ground after each stage, the last being what is left" awk -F, '
    FNR == NR { if ($1 == "retrogression.stages") stages = $2; next }
    FNR == 1 { ended = stages > 0 && NF == 3 + stages && $3 == "left_standing_m" && $NF == "after_stage_" stages "_m"; next }
    { off = $3 - $NF; ended = ended && off * off < 1e-12 }
    END { exit !(ended && FNR > 100) }' <(tr -s ' ' , <"$scratch/out") retreat/left_standing.csv
delabole fit fit.toml --no-report --out bare_fit
expect_status 0
expect_output 'results in bare_fit'
expect "no report" test ! -e bare_fit/report.html


title "--version"
delabole --version
expect_status 0
expect "a version and a revision" grep -qE '^[0-9]+\.[0-9]+(\.[0-9]+)? \(.+\)$' "$scratch/out"
expect "the version is in the results" contains results/good/result.json \
    "\"program\": \"delabole $(cut -d' ' -f1 "$scratch/out")\""

title "folders of any name: relative, deep, with spaces, beyond ASCII, starting with a hyphen"
mkdir -p "in a folder/Schieferbrüche"
cp good.toml "in a folder/Schieferbrüche/Old Delabole – 1967.toml"
delabole run "in a folder/Schieferbrüche/Old Delabole – 1967.toml"
expect_status 0
expect_complete_results "results/Old Delabole – 1967"
expect_figures "results/Old Delabole – 1967" 3
delabole run "in a folder/Schieferbrüche/Old Delabole – 1967.toml" --out "../work/./deep/er/ärger & \"quotes\" 'n <b>"
expect_status 0
expect_complete_results "deep/er/ärger & \"quotes\" 'n <b>"
expect_figures "deep/er/ärger & \"quotes\" 'n <b>" 3
(cd "in a folder" && "$program" fit ../good_fit.toml --out "Ergebnisse 1" --quiet)
expect_complete_results "in a folder/Ergebnisse 1"
delabole run --out=-hyphen -- good.toml
expect_status 0
expect_complete_results ./-hyphen
expect_figures ./-hyphen 3
name=$'latin1-\xe9.toml'
if cp good.toml "$name" 2>/dev/null; then
    delabole run "$name" --out bytes
    expect_status 0
    expect_complete_results bytes
fi

finish
