# Run by the target delabole_revision: fills version.cpp.in. Leaves an up-to-date output untouched.
set(revision unknown)
find_program(git_program git)
if(git_program)
    # Sources unpacked inside another checkout must not use that checkout's commit.
    execute_process(
        COMMAND ${git_program} rev-parse --show-toplevel
        WORKING_DIRECTORY ${source_directory}
        OUTPUT_VARIABLE checkout
        OUTPUT_STRIP_TRAILING_WHITESPACE
        ERROR_QUIET)
    file(REAL_PATH "${source_directory}" real_source_directory)
    if(checkout AND checkout STREQUAL real_source_directory)
        execute_process(
            COMMAND ${git_program} describe --always --exclude=* --abbrev=12 --dirty=-modified
            WORKING_DIRECTORY ${source_directory}
            OUTPUT_VARIABLE described
            OUTPUT_STRIP_TRAILING_WHITESPACE
            ERROR_QUIET)
        if(described)
            set(revision ${described})
        endif()
    endif()
endif()

file(GLOB_RECURSE sources LIST_DIRECTORIES FALSE ${source_directory}/lib/*.cpp ${source_directory}/lib/*.hpp)
list(SORT sources)
set(hashes "${compiler}")
foreach(source IN LISTS sources)
    file(SHA256 ${source} hash)
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${source_directory})
    string(APPEND hashes " ${source} ${hash}")
endforeach()
string(SHA256 fingerprint "${hashes}")
configure_file(${template} ${output} @ONLY)
