# Sources of tests, several at once (-DCMAKE_UNITY_BUILD=ON). Tests of different files call their models and helpers by
# the same names, since each file is read by itself; in one translation unit their unnamed namespaces are one. Hence each
# file gets a namespace of its own inside the project's, from which all names of the project are seen: the word `analogon`
# is a macro for it while the file is read. So no test has to tell, nor is kept from a name, for the sake of this build.
# Headers have to be read before, where the word is still itself: those that any source of the program includes.
#
# A helper that has the name of a function of the project hides it here, where it would be an overload elsewhere, and a
# name that both `analogon` and `analogon::ui` have is ambiguous unless it is told as `ui::Extent`. Tests that cannot do
# with that, or that define what is found in `namespace analogon` itself, are listed in packaging/cmake/alone.txt; sources
# that are no tests are compiled alone without being listed.

# analogon_own_headers(VARIABLE sources…): paths of the headers between quotation marks
function(analogon_own_headers variable)
    set(headers)
    foreach(source ${ARGN})
        get_filename_component(folder ${source} DIRECTORY)
        file(STRINGS ${source} includes REGEX "^#include \"")
        foreach(include ${includes})
            string(REGEX REPLACE "^#include \"([^\"]*)\".*" "\\1" header ${include})
            if(EXISTS ${folder}/${header})
                get_filename_component(header ${folder}/${header} ABSOLUTE)
            endif()
            list(APPEND headers ${header})
        endforeach()
    endforeach()
    list(REMOVE_DUPLICATES headers)
    list(SORT headers)
    set(${variable} ${headers} PARENT_SCOPE)
endfunction()

# analogon_inner_namespaces(VARIABLE sources…): what is opened inside the namespace of the project, "ui" or "ui::style"
function(analogon_inner_namespaces variable)
    set(inner)
    foreach(source ${ARGN})
        file(STRINGS ${source} opened REGEX "^namespace analogon::")
        list(TRANSFORM opened REPLACE "^namespace analogon::([a-z_:]+).*" "\\1")
        list(APPEND inner ${opened})
    endforeach()
    list(REMOVE_DUPLICATES inner)
    set(${variable} ${inner} PARENT_SCOPE)
endfunction()

# analogon_compile_tests_at_once(PROGRAM sources…): sources by their full paths
function(analogon_compile_tests_at_once program)
    analogon_compile_alone(${ARGN})
    foreach(source ${ARGN})
        if(NOT source MATCHES "_test\\.cpp$")  # defines what a header declares in the project's own namespace
            set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
        endif()
    endforeach()
    # a header that a source begins to include has to be read before from then on
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARGN})
    analogon_own_headers(headers ${ARGN})
    analogon_inner_namespaces(inner ${ARGN})
    list(TRANSFORM headers REPLACE "(.+)" "#include \"\\1\"")
    list(JOIN headers "\n" headers)
    set(first ${CMAKE_CURRENT_BINARY_DIR}/${program}_headers.hpp)
    file(CONFIGURE OUTPUT ${first} CONTENT "#pragma once\n${headers}\n" @ONLY)
    set(seen "namespace analogon::ANALOGON_TEST_FILE { using namespace analogon; }\n")
    foreach(name ${inner})
        string(APPEND seen "namespace analogon::${name} {}\n"
               "namespace analogon::ANALOGON_TEST_FILE::${name} { using namespace analogon::${name}; }\n")
    endforeach()
    set_target_properties(${program} PROPERTIES UNITY_BUILD ON
        UNITY_BUILD_UNIQUE_ID ANALOGON_TEST_FILE
        UNITY_BUILD_CODE_BEFORE_INCLUDE
        "#include \"${first}\"\n${seen}#define analogon analogon::ANALOGON_TEST_FILE"
        UNITY_BUILD_CODE_AFTER_INCLUDE "#undef analogon")
    # warns of tests whose fixture is of an unnamed namespace as soon as their file is included, as it is here
    target_compile_options(${program} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()
