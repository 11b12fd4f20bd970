#!/usr/bin/env bash
# The sentences that answer a case: on the screen, and at the head of the report.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

cases=$source_folder/cases
write_good_case good.toml

# says "a sentence" run's arguments...
says() {
    local sentence=$1
    shift
    delabole run "$@" --no-report --out answer
    expect_output "$sentence"
}

title "plane failure: the printed numbers of Wyllie & Mah's example 7.1"
says 'FS 1.25: stands.' good.toml
says '47.8 m2 of rock, 1242 kN/m, on a plane at 35 deg: ' good.toml
says ' resist; water takes part with 196 kN/m on the base and 44.1 kN/m in the crack.' good.toml
says 'FS 0.801: fails by sliding.' good.toml --set strength.cohesion='0 kPa'
says '; the slope is dry.' good.toml --set water.kind=dry
says 'Nothing drives the mass down the plane: the factor of safety is infinite.' \
    "$cases/plane_failure/wyllie_mah_7_1_bolts.toml" --set 'bolt[1].force=100 MN/m' --set 'bolt[1].plunge=-20 deg'
says 'FS 1.5 takes 401 kN/m in bolt 1 at 55 deg.' "$cases/plane_failure/wyllie_mah_7_1_bolts.toml"  # 400 give 1.499
says 'No value of the water depth gives FS 5.' good.toml \
    --set 'required=[{ parameter = "water.water_depth", factor_of_safety = 5 }]'
says 'FS 0.1 is exceeded whatever the cohesion is.' good.toml \
    --set 'required=[{ parameter = "strength.cohesion", factor_of_safety = 0.1 }]'

title "a wedge"
says 'FS 1.14: stands on both planes.' "$cases/wedge/hoek_bray_complete.toml"
says 'For FS 1.5 the force of bolt 1 has to be at least ' "$cases/wedge/hoek_bray_complete.toml"
says ' of rock on a line that plunges 31.2 deg towards 158 deg.' "$cases/wedge/hoek_bray_complete.toml"
says ': slides on both planes.' "$cases/wedge/hoek_bray_complete.toml" --set plane_1.strength.cohesion='0 kPa'

title "columns"
says 'FS 0.9999: fails by toppling.' "$cases/stepped_base/goodman_bray_1976.toml"  # not FS 1, which would stand
says ': fails by toppling.' "$cases/stepped_base/goodman_bray_1976_cable.toml"
says 'FS 1 takes 2013 kN/m in a cable in column 1, 2 m above its base, at 0 deg.' "$cases/stepped_base/goodman_bray_1976_cable.toml"
says 'FS 1 is reached without a cable in column 1, 2 m above its base, at 0 deg.' "$cases/stepped_base/goodman_bray_1976_cable.toml" \
    --set joints.friction_angle='45 deg' --set bases.friction_angle='45 deg'
says 'In limiting equilibrium 10 columns topple and 3 columns slide, ' "$cases/stepped_base/goodman_bray_1976.toml"
says 'm behind the crest.' "$cases/stepped_path/columns_and_wedge.toml"
says 'columns move, ' "$cases/stepped_path/columns_and_wedge.toml"

title "blocks on a plane, bending columns, a tilted column"
says 'The row stands.' "$cases/starting/block_row.toml" --set base.inclination='5 deg'
says 'The row fails: it ' "$cases/starting/block_row.toml" --set base.inclination='25 deg'
says 'The block ' "$cases/starting/single_block.toml"
says 'Factor of safety against sliding ' "$cases/starting/single_block.toml"
says ': fails by flexural toppling.' "$cases/starting/flexural_toppling.toml"
says 'It takes a tensile strength of ' "$cases/starting/flexural_toppling.toml"
says 'The column at the toe lacks a push of ' "$cases/starting/flexural_toppling.toml"
says ' stands for the water.' "$cases/starting/tilted_column.toml"

title "joint sets"
says 'Geometry and friction leave open: ' "$cases/starting/kinematics.toml"
says 'They close: planar sliding, wedge sliding and flexural toppling.' "$cases/starting/kinematics.toml" \
    --set strength.friction_angle='80 deg' --set slope.face_dip='10 deg'
says 'This holds for the mean orientations; ' "$cases/starting/kinematics.toml"
says 'Geometry and friction leave no movement open.' "$cases/starting/kinematics.toml" \
    --set 'joint_set=[{ name = "only", dip = "5 deg", dip_direction = "95 deg" }]'

title "blocks in motion"
motion=$cases/relaxation
says 'Stands: at rest after ' "$motion/bolted_block.toml"
says 'Bolt 1 pulls most at the end, 26.5 kN/m of the 100 kN/m at which it yields; the energy balance closes to ' "$motion/bolted_block.toml"
says 'Fails: 2 m2 had begun to move after 0.5 s.' "$motion/free_slide.toml"
says 'The first block passed the thresholds of failure at ' "$motion/free_slide.toml"
says 'Collapsed: 2 m2 had moved after ' "$motion/free_slide.toml" --set settings.duration='5 s'
says 'Failed, and came to rest: 0.4 m2 had moved after ' "$motion/newmark_block.toml"
says 'Followed past the verdict, as settings.watch asks. The energy balance closes to ' "$cases/starting/relaxation.toml" \
    --set settings.watch='1 s'
says 'Not decided: the blocks neither came to rest nor failed after ' "$motion/bolted_block.toml" --set settings.duration='0.01 s'
says 'Stands: no block fails.' "$motion/retreating_slope.toml" --set ensemble.runs=2 --set 'scene.joint[1].friction_angle=80 deg'
says 'Fails: it retreats in 1 stage, in which ' "$motion/retreating_slope.toml" --set ensemble.runs=2
says 'FS 1.2, by strength reduction: stands.' "$motion/strength_reduction.toml"
says 'At 1.197 the blocks stand, at 1.2 they fail.' "$motion/strength_reduction.toml"
says 'With the strength and loads as given: stands, at rest after ' "$motion/strength_reduction.toml"
says ': raise critical.upper.' "$motion/strength_reduction.toml" --set critical.upper=1.1 --set critical.lower=1

title "a back-analysis of several mechanisms, and of one without an answer"
# fits "a sentence" fit's arguments...
fits() {
    local sentence=$1
    shift
    delabole fit "$@" --out fitted
    expect "$sentence" grep -qE "^<p>$sentence" fitted/report.html
}
write_good_fit good_fit.toml
fits 'Best fit: friction angle [0-9.]+ deg \(.* with 95 %\) and water depth ' good_fit.toml
fits 'Friction angle and water depth: only one combination is determined: along ' good_fit.toml
cat good.toml - >two.toml <<'CASE'
[fit]
starts = 2
profile_points = 5
map_points = 5
[[fit.observation]]
label = "it failed"
quantity = "factor_of_safety"
value = 1
standard_deviation = 0.05
[[fit.mechanism]]
name = "weak"
title = "A plane without cohesion"
parameter = [{ name = "strength.cohesion", lower = "0 kPa", upper = "40 kPa" }]
[[fit.mechanism]]
name = "wet"
parameter = [{ name = "water.water_depth", lower = "0 m", upper = "1 m" }]
CASE
fits 'Best explanation of the 2 compared: A plane without cohesion[.]' two.toml
fits 'The data determine its parameter near the best point; they give cohesion ' two.toml
# Half a bracket of the search is 0.1 deg.
fits 'Best fit: friction angle (34[.]9[0-9]*|35([.]0[0-9]*)?) deg ' "$motion/strength_reduction.toml" --set critical.paths=all
fits 'No mechanism has an answer within the bounds of its parameters[.]' good_fit.toml --set slope.face_dip='30 deg'

finish
