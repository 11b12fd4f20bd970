# Builds the tables of the thesis and of the published problems, and the cases of both, into the program, which then needs
# no files beside it.
set(thesis_tables "")
foreach(table
    thesis/chapter_2/groundwater_tests thesis/chapter_2/mechanisms thesis/chapter_2/trends
    thesis/chapter_3/plates thesis/chapter_3/table_3_2 thesis/chapter_3/table_3_3 thesis/chapter_3/tilting_frame
    thesis/chapter_5/histories thesis/chapter_5/report thesis/chapter_5/runs
    published/published_factors)
    set(file ${PROJECT_SOURCE_DIR}/cases/${table}.csv)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    string(APPEND thesis_tables "        {\"${table}.csv\", R\"csv(${text})csv\"},\n")
endforeach()
set(built_in_cases "")
foreach(case
    delabole_1967/delabole_joint_sets plane_failure/dry_cohesionless
    plane_failure/fig_2_8 plane_failure/groundwater_by_tilting relaxation/base_friction_slope stepped_base/appendix_a
    thesis/chapter_2/groundwater_column thesis/chapter_2/plate_2_i
    thesis/chapter_2/plate_2_i_continuity thesis/chapter_2/plate_2_i_removed
    thesis/chapter_2/plate_2_i_without_cleavage thesis/chapter_2/plate_2_ii
    thesis/chapter_2/plate_2_ii_joints_c thesis/chapter_2/plate_2_iii
    thesis/chapter_2/plate_2_iii_friction thesis/chapter_2/plate_2_iv
    thesis/chapter_2/plate_2_iv_divided thesis/chapter_2/plate_2_v thesis/chapter_2/plate_2_vi
    thesis/chapter_3/fig_3_5 thesis/chapter_4/appendix_a_blocks thesis/chapter_4/fig_3_4 thesis/chapter_4/fig_4_1
    thesis/chapter_4/fig_4_3 thesis/chapter_4/fig_4_4 thesis/chapter_4/fig_4_6
    thesis/chapter_4/fig_4_8 thesis/chapter_4/west_face_blocks
    published/rj_1a published/rj_1b published/rj_1c published/rj_1d published/rj_2 published/rj_3 published/rj_4 published/rj_5
    published/rj_6 published/rj_7 published/rj_8 published/rj_9 published/rj_10 published/rj_11 published/rj_12 published/rj_13
    published/rj_14 published/rj_15 published/rj_16 published/rj_17 published/rj_18 published/rj_19
    published/rj_20)
    set(file ${PROJECT_SOURCE_DIR}/cases/${case}.toml)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    get_filename_component(folder ${case} DIRECTORY)
    get_filename_component(name ${case} NAME)
    string(APPEND built_in_cases "        {\"${folder}\", \"${name}\", R\"toml(${text})toml\"},\n")
endforeach()
configure_file(${CMAKE_CURRENT_LIST_DIR}/thesis_tables.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/thesis_tables.cpp @ONLY)
target_sources(delabole_cases PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/thesis_tables.cpp)
# Longer than a compiler has to support. These do.
set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/thesis_tables.cpp PROPERTIES
    COMPILE_OPTIONS -Wno-overlength-strings)
