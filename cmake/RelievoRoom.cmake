# relievo_compile_options(TARGET): the warnings and sanitizers that all of our own code is built with.
function(relievo_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
  if(RELIEVO_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(RELIEVO_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=address,undefined)
  endif()
  if(RELIEVO_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all)
    target_link_options(${target} PRIVATE -fsanitize=address,undefined)
  endif()
  # Archive members that a program does not use must not pull in their shared libraries
  # (OpenImageIO alone costs 0.16 s at every start).
  target_link_options(${target} PRIVATE -Wl,--as-needed)
endfunction()

# For what is compiled often and takes no time to run: tests and everything that includes CLI11, whose
# templates take twice as long at full optimisation. An option of a target or of source files.
set(RELIEVO_LIGHT_OPTIMISATION "$<$<CONFIG:Release>:-O1>")

# relievo_add_room(NAME SOURCES … HEADERS … [LINKS …] [PRIVATE_LINKS …] [INTERNAL])
# One room is one static library: target relievo_NAME, alias relievo::NAME. HEADERS are relative to
# the room's folder and are installed to include/relievo/NAME/. An INTERNAL room serves our own
# programs only and is not installed.
function(relievo_add_room name)
  cmake_parse_arguments(PARSE_ARGV 1 ROOM "INTERNAL" "" "SOURCES;HEADERS;LINKS;PRIVATE_LINKS")
  set(target relievo_${name})
  add_library(${target} STATIC ${ROOM_SOURCES} ${ROOM_HEADERS})
  add_library(relievo::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>"
    "$<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/relievo>")
  target_link_libraries(${target} PUBLIC ${ROOM_LINKS} PRIVATE ${ROOM_PRIVATE_LINKS})
  relievo_compile_options(${target})
  if(NOT ROOM_INTERNAL)
    install(TARGETS ${target} EXPORT relievoTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    install(FILES ${ROOM_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/relievo/${name})
  endif()
endfunction()

# relievo_add_command(NAME SOURCES … [LINKS …]): one command-line program, built in the build
# folder's bin/ and installed to bin/.
function(relievo_add_command name)
  cmake_parse_arguments(PARSE_ARGV 1 COMMAND "" "" "SOURCES;LINKS")
  add_executable(${name} ${COMMAND_SOURCES})
  target_link_libraries(${name} PRIVATE ${COMMAND_LINKS})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
  relievo_compile_options(${name})
  target_compile_options(${name} PRIVATE ${RELIEVO_LIGHT_OPTIMISATION})
  install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endfunction()

# What the sanitizer run builds: the test programs with the label `cpu`.
add_custom_target(cpu_tests)

# GoogleTest's headers cost more to compile than most tests: they are compiled once for all of them.
if(RELIEVO_BUILD_TESTS)
  file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/generated/test_headers.cpp" CONTENT "")
  add_library(relievo_test_headers STATIC EXCLUDE_FROM_ALL
    "${PROJECT_BINARY_DIR}/generated/test_headers.cpp")
  target_compile_features(relievo_test_headers PUBLIC cxx_std_20)
  target_link_libraries(relievo_test_headers PRIVATE GTest::gtest GTest::gmock)
  target_precompile_headers(relievo_test_headers PRIVATE <gmock/gmock.h> <gtest/gtest.h>)
  relievo_compile_options(relievo_test_headers)
  target_compile_options(relievo_test_headers PRIVATE ${RELIEVO_LIGHT_OPTIMISATION})
endif()

# relievo_add_tests(NAME SOURCES … [LINKS …] [LABELS …] [TIMEOUT s] [ENVIRONMENT …])
# One GoogleTest program, a ctest test of the room's name. Its label is `cpu`, which makes it part of
# the sanitizer run, unless LABELS says otherwise: `gl` for tests that render.
function(relievo_add_tests name)
  cmake_parse_arguments(PARSE_ARGV 1 TESTS "" "TIMEOUT" "SOURCES;LINKS;LABELS;ENVIRONMENT")
  set(target relievo_${name}_tests)
  add_executable(${target} ${TESTS_SOURCES})
  target_link_libraries(${target} PRIVATE ${TESTS_LINKS} GTest::gtest GTest::gtest_main GTest::gmock)
  relievo_compile_options(${target})
  target_compile_options(${target} PRIVATE ${RELIEVO_LIGHT_OPTIMISATION})
  target_precompile_headers(${target} REUSE_FROM relievo_test_headers)
  if(NOT TESTS_LABELS)
    set(TESTS_LABELS cpu)
  endif()
  if("cpu" IN_LIST TESTS_LABELS)
    add_dependencies(cpu_tests ${target})
  endif()
  add_test(NAME ${name} COMMAND ${target})
  if(NOT TESTS_TIMEOUT)
    set(TESTS_TIMEOUT 300)
  endif()
  set_tests_properties(${name} PROPERTIES TIMEOUT ${TESTS_TIMEOUT} LABELS "${TESTS_LABELS}"
    ENVIRONMENT "${TESTS_ENVIRONMENT}")
endfunction()
