# Embeds the sentences on impossible cases in the program.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/impossible_cases.csv)
file(READ ${CMAKE_CURRENT_LIST_DIR}/impossible_cases.csv impossible_cases)
configure_file(${CMAKE_CURRENT_LIST_DIR}/impossible_cases.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/impossible_cases.cpp @ONLY)
target_sources(delabole_cases PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/impossible_cases.cpp)
