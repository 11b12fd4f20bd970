#!/usr/bin/env bash
# The sentences that answer a case: on the screen, and at the head of the report.
source "$(dirname "${BASH_SOURCE[0]}")/harness.sh"

cases=$source_folder/cases
write_good_case good.toml

# says "a sentence" run's arguments...
says() {
    local sentence=$1
    shift
    "$program" run "$@" --no-report --out answer >"$scratch/out" 2>"$scratch/err" </dev/null || true
    expect_output "$sentence"
}

title "plane failure: the printed numbers of Wyllie & Mah's example 7.1"
says 'FS 1.25: stands.' good.toml
says '13.3 m2 of rock, 1242 kN/m, on a plane at 35 deg: ' good.toml
says ' resist; water takes part with 196 kN/m on the base and 44.1 kN/m in the crack.' good.toml
says 'FS 0.801: fails by sliding.' good.toml --set strength.cohesion='0 kPa'
says '; the slope is dry.' good.toml --set water.kind=dry
says 'Nothing drives the mass down the plane: the factor of safety is infinite.' good.toml \
    --set failure_plane.dip='0 deg' --set water.kind=dry
says 'FS 1.5 takes 400 kN/m as the force of bolt 1.' "$cases/plane_failure/wyllie_mah_7_1_bolts.toml"
says 'No value of the force of bolt 1 gives FS 50.' "$cases/plane_failure/wyllie_mah_7_1_bolts.toml" \
    --set 'required=[{ parameter = "bolt[1].force", factor_of_safety = 50 }]'
says 'FS 0.1 is exceeded whatever the cohesion is.' good.toml \
    --set 'required=[{ parameter = "strength.cohesion", factor_of_safety = 0.1 }]'

title "a wedge"
says 'FS 1.14: stands on both planes.' "$cases/wedge/hoek_bray_complete.toml"
says 'FS 1.5 takes ' "$cases/wedge/hoek_bray_complete.toml"
says ' of rock on a line that plunges 31.2 deg towards 158 deg.' "$cases/wedge/hoek_bray_complete.toml"
says ': slides on both planes.' "$cases/wedge/hoek_bray_complete.toml" --set plane_1.strength.cohesion='0 kPa'

title "columns"
says ': fails by toppling.' "$cases/stepped_base/goodman_bray_1976_cable.toml"
says 'FS 1 takes 2013 kN/m in a cable in column 1 at 0 deg.' "$cases/stepped_base/goodman_bray_1976_cable.toml"
says 'FS 1 is reached without a cable in column 1 at 0 deg.' "$cases/stepped_base/goodman_bray_1976_cable.toml" \
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
says 'They close: ' "$cases/starting/kinematics.toml"
says 'This is so at the mean orientations; ' "$cases/starting/kinematics.toml"
says 'Geometry and friction leave no movement open.' "$cases/starting/kinematics.toml" \
    --set strength.friction_angle='80 deg' --set slope.face_dip='10 deg'

finish
