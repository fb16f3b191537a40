# One function per build idiom; each folder's CMakeLists.txt is a list of names.

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${CCACHE_PROGRAM})
endif()

# Warnings and the include root for a target of ours.
function(steradian_target name)
  target_compile_options(${name} PRIVATE -Wall -Wextra -Wno-missing-field-initializers)
  target_include_directories(${name} PUBLIC ${CMAKE_SOURCE_DIR})
endfunction()

# A static library of ours: steradian_library(NAME SOURCES ... LINKS ... PRIVATE_LINKS ...)
function(steradian_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  steradian_target(${name})
  target_link_libraries(${name} PUBLIC ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
endfunction()

# One plugin = one folder = one shared object: steradian_add_plugin(NAME SOURCES ... LINKS ...)
function(steradian_add_plugin name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  add_library(${name} MODULE ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE steradian::sdk ${ARG_LINKS})
  target_compile_options(${name} PRIVATE -Wall -Wextra)
  set_target_properties(${name} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${STERADIAN_PLUGIN_DIR})
  install(TARGETS ${name} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/steradian/plugins)
  set_property(GLOBAL APPEND PROPERTY STERADIAN_PLUGINS ${name})
endfunction()

# A GoogleTest binary with ctest labels: steradian_add_test(NAME LABELS ... SOURCES ... LINKS ... [DISPLAY])
# DISPLAY: run it on an X display of its own.
function(steradian_add_test name)
  cmake_parse_arguments(ARG "DISPLAY" "TIMEOUT" "SOURCES;LINKS;LABELS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  steradian_target(${name})
  target_link_libraries(${name} PRIVATE ${ARG_LINKS} GTest::gtest GTest::gtest_main)
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  set(wrapper)
  if(ARG_DISPLAY)
    set(wrapper ${CMAKE_SOURCE_DIR}/tests/with_display.sh)
  endif()
  add_test(NAME ${name} COMMAND ${wrapper} $<TARGET_FILE:${name}>)
  if("unit" IN_LIST ARG_LABELS)
    add_dependencies(unit_tests ${name})
  endif()
  # A window is driven in real time, so it has the machine to itself.
  set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT ${ARG_TIMEOUT} RUN_SERIAL ${ARG_DISPLAY}
    ENVIRONMENT "STERADIAN_VALIDATION=1;STERADIAN_PLUGIN_PATH=${STERADIAN_PLUGIN_DIR};LSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/tests/leaks.supp:print_suppressions=0")
endfunction()
