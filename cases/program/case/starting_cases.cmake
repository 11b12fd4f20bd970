# Builds the cases to start from into the program.
set(starting_cases "")
foreach(name plane_failure stepped_base stepped_path single_block block_row tilted_column kinematics relaxation
    flexural_toppling wedge jointed_slope fit sensitivity support)
    set(file ${PROJECT_SOURCE_DIR}/cases/starting/${name}.toml)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    string(APPEND starting_cases "        {\"${name}\", R\"toml(${text})toml\"},\n")
endforeach()
configure_file(${CMAKE_CURRENT_LIST_DIR}/starting_cases.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/starting_cases.cpp @ONLY)
target_sources(delabole_cases PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/starting_cases.cpp)
