# How every target of Pilotage is compiled. What makes results reproducible is passed on to whoever
# links the libraries, the rest is our own business.

# No fused multiply-add behind our back: live, replay and every build give the same bits.
set(PILOTAGE_PUBLIC_FLAGS -ffp-contract=off)

# None of these changes a result. gcc 12 packs products of 3x3 matrices into vectors and loses; errno
# costs a branch at every square root; renaming registers and calling libm without a stub save the
# update some 15 of 570 instructions. See bench/README.md.
set(PILOTAGE_RELEASE_FLAGS -O2 -fno-tree-vectorize -fno-math-errno -fno-plt)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  list(APPEND PILOTAGE_RELEASE_FLAGS -frename-registers)
endif()

# Of -Wconversion what gcc and clang agree on.
set(PILOTAGE_WARNING_FLAGS -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                           -Wnon-virtual-dtor -Woverloaded-virtual)
if(PILOTAGE_WERROR)
  list(APPEND PILOTAGE_WARNING_FLAGS -Werror)
endif()

# Gives a target the language, the flags and the warnings of this project.
function(pilotage_target name)
  target_compile_features(${name} PUBLIC cxx_std_17)
  set_target_properties(${name} PROPERTIES
    CXX_EXTENSIONS OFF
    CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON
    POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${name}
    PUBLIC ${PILOTAGE_PUBLIC_FLAGS}
    PRIVATE "$<$<CONFIG:Release>:${PILOTAGE_RELEASE_FLAGS}>" ${PILOTAGE_WARNING_FLAGS})
endfunction()
