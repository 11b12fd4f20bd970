# Builds the tables of the thesis and of the published problems, and the cases of both, into the program, which then needs
# no files beside it.
set(chapter_2_case_names plate_2_i plate_2_i_without_cleavage plate_2_i_continuity plate_2_ii plate_2_ii_joints_c
    plate_2_iii plate_2_iv plate_2_iv_divided plate_2_v plate_2_vi groundwater_column)
set(published_case_names
    rj_1a rj_1b rj_1c rj_1d rj_2 rj_3 rj_4 rj_5 rj_6 rj_7 rj_8 rj_9 rj_10 rj_11 rj_12 rj_13 rj_14 rj_15 rj_16 rj_17 rj_18
    rj_19 rj_20)
set(thesis_tables "")
foreach(table
    thesis/chapter_2/features thesis/chapter_2/groundwater_tests thesis/chapter_2/mechanisms thesis/chapter_2/trends
    thesis/chapter_3/table_3_1 thesis/chapter_3/table_3_2 thesis/chapter_3/table_3_3 thesis/chapter_3/tilting_frame
    published/published_factors)
    set(file ${PROJECT_SOURCE_DIR}/cases/${table}.csv)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    get_filename_component(name ${table} NAME)
    string(APPEND thesis_tables "const std::string_view thesis_${name} = R\"csv(${text})csv\";\n\n")
endforeach()
# Of cases/<folder>/<name>.toml the entries of a list of BuiltInCase, in `entries`.
function(delabole_built_in_cases entries folder)
    set(list "")
    foreach(case ${ARGN})
        set(file ${PROJECT_SOURCE_DIR}/cases/${folder}/${case}.toml)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
        file(READ ${file} text)
        string(APPEND list "        {\"${case}\", R\"toml(${text})toml\"},\n")
    endforeach()
    set(${entries} "${list}" PARENT_SCOPE)
endfunction()
delabole_built_in_cases(chapter_2_cases thesis/chapter_2 ${chapter_2_case_names})
delabole_built_in_cases(published_cases published ${published_case_names})
configure_file(${CMAKE_CURRENT_LIST_DIR}/thesis_tables.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/thesis_tables.cpp @ONLY)
target_sources(delabole_cases PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/thesis_tables.cpp)
