# The revision is read at every build, not at every configure, so that a cached value cannot hide a new commit;
# the source is rewritten only if its content changes, so that the cost is one small file and a link.
set(version_source ${CMAKE_CURRENT_BINARY_DIR}/version/version.cpp)
add_custom_target(delabole_revision
    COMMAND ${CMAKE_COMMAND}
        -D source_directory=${PROJECT_SOURCE_DIR}
        -D version=${PROJECT_VERSION}
        "-D compiler=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} ${CMAKE_SYSTEM_PROCESSOR} ${CMAKE_BUILD_TYPE} ${CMAKE_CXX_FLAGS}"
        -D template=${CMAKE_CURRENT_LIST_DIR}/version.cpp.in
        -D output=${version_source}
        -P ${CMAKE_CURRENT_LIST_DIR}/write_version.cmake
    BYPRODUCTS ${version_source}
    COMMENT "Asking for the revision"
    VERBATIM)
target_sources(delabole_lib PRIVATE ${version_source})
add_dependencies(delabole_lib delabole_revision)
