# Builds the tables of the thesis, and the cases of its models, into the program, which then needs no files beside it.
set(chapter_2_case_names plate_2_i plate_2_i_without_cleavage plate_2_i_continuity plate_2_ii plate_2_ii_joints_c
    plate_2_iii plate_2_iv plate_2_iv_divided plate_2_v plate_2_vi groundwater_column)
set(thesis_tables "")
foreach(table
    chapter_2/features chapter_2/groundwater_tests chapter_2/mechanisms chapter_2/trends
    chapter_3/table_3_1 chapter_3/table_3_2 chapter_3/table_3_3 chapter_3/tilting_frame)
    set(file ${CMAKE_CURRENT_SOURCE_DIR}/${table}.csv)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    get_filename_component(name ${table} NAME)
    string(APPEND thesis_tables "const std::string_view thesis_${name} = R\"csv(${text})csv\";\n\n")
endforeach()
set(chapter_2_cases "")
foreach(case ${chapter_2_case_names})
    set(file ${CMAKE_CURRENT_SOURCE_DIR}/chapter_2/${case}.toml)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    string(APPEND chapter_2_cases "        {\"${case}\", R\"toml(${text})toml\"},\n")
endforeach()
configure_file(${CMAKE_CURRENT_LIST_DIR}/thesis_tables.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/thesis_tables.cpp @ONLY)
target_sources(delabole_cases PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/thesis_tables.cpp)
