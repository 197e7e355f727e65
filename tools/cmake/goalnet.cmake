# The few rules that every target of the project shares.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
# Same source, same floating-point results on every optimisation level: repeatability is a feature.
add_compile_options(-ffp-contract=off)

# Five files of a target are compiled at once: most are short and share long headers, so a build from nothing takes
# two thirds of the time. Names in their anonymous namespaces must differ within a target.
# -DCMAKE_UNITY_BUILD=OFF shows that each file includes what it uses.
option(CMAKE_UNITY_BUILD "Compile several files of a target at once" ON)
set(CMAKE_UNITY_BUILD_BATCH_SIZE 5)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

# g++ 12 sees overlaps in "text" + std::string that are not there (GCC bug 105651).
set(GOALNET_WARNINGS -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Werror
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)

# goalnet_library(NAME SOURCES a.cc b.cc [DEPS targets...] [PRIVATE_DEPS targets...])
# Headers are included from the root: #include "components/core/predicate.h".
function(goalnet_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPS;PRIVATE_DEPS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_include_directories(${name} PUBLIC ${CMAKE_SOURCE_DIR})
  target_compile_options(${name} PRIVATE ${GOALNET_WARNINGS})
  target_link_libraries(${name} PUBLIC ${ARG_DEPS} PRIVATE ${ARG_PRIVATE_DEPS})
endfunction()

# goalnet_test(NAME SOURCES a_test.cc [DEPS targets...] [LABELS l...] [TIMEOUT s] [ENVIRONMENT K=V...])
# One GoogleTest program; CTest lists it as one test so that a run of everything stays readable.
function(goalnet_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;DEPS;LABELS;ENVIRONMENT" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  if(NOT ARG_LABELS)
    set(ARG_LABELS unit)
  endif()
  find_package(GTest REQUIRED)
  add_executable(${name} ${ARG_SOURCES})
  # What is tested is fully optimised; the tests' own code need not be, and compiles in two thirds of the time.
  target_compile_options(${name} PRIVATE ${GOALNET_WARNINGS} $<$<CONFIG:Release>:-O1>)
  target_link_libraries(${name} PRIVATE ${ARG_DEPS} GTest::gmock GTest::gtest GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE GOALNET_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  add_test(NAME ${name} COMMAND ${name} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
  set_tests_properties(${name} PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS "${ARG_LABELS}"
                       ENVIRONMENT "${ARG_ENVIRONMENT}")
endfunction()
