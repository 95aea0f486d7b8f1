# deltamesh_configure(TARGET): what every target of the project has in common.
function(deltamesh_configure target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF CXX_VISIBILITY_PRESET hidden
                        VISIBILITY_INLINES_HIDDEN ON)
  if(NOT EMSCRIPTEN)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  endif()
  # The same floats from every compiler: no fused multiply-add that the source does not ask for.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  if(CMAKE_SIZEOF_VOID_P EQUAL 4 AND CMAKE_SYSTEM_PROCESSOR MATCHES "86" AND NOT EMSCRIPTEN)
    target_compile_options(${target} PRIVATE -msse2 -mfpmath=sse)
  endif()
  if(DELTAMESH_DEVELOPER_MODE)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                             -Werror)
  endif()
endfunction()

# deltamesh_build_quickly(TARGET...): for what spends its time in the libraries. Optimising what the command line's and the tests'
# headers bring along takes longer than anything it could save; instrumented by sanitizers, even -O1 does.
function(deltamesh_build_quickly)
  foreach(target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1> $<$<CONFIG:Sanitizers>:-O0>)
  endforeach()
endfunction()
