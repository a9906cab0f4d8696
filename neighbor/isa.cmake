# sluice_add_isa_sources(TARGET FILE... [INCLUDES FOLDER...] [LIBRARIES PACKAGE...] [AND LEVEL...]): compiles the files once
# per instruction set into the target; and once more for each LEVEL that is none of a processor's.
#
# Only optimised x86-64 builds get all levels: without optimisation, inline functions from headers would be emitted with
# the newer instructions, and the linker may take any one of several copies for the whole program.
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND build_type MATCHES "RELEASE|MINSIZEREL"
   AND NOT CMAKE_CXX_FLAGS MATCHES "fsanitize")
  set(SLUICE_ALL_ISAS ON CACHE INTERNAL "every instruction set is compiled in")
  target_compile_definitions(sluice_options INTERFACE SLUICE_ALL_ISAS)
else()
  set(SLUICE_ALL_ISAS OFF CACHE INTERNAL "every instruction set is compiled in")
endif()

function(sluice_add_isa_sources target)
  cmake_parse_arguments(PARSE_ARGV 1 isa "" "" "INCLUDES;LIBRARIES;AND")
  set(levels baseline)
  if(SLUICE_ALL_ISAS)
    list(APPEND levels avx2 avx512)
  endif()
  set(flags_avx2 -mavx2 -mfma)
  set(flags_avx512 -mavx512f -mavx512bw -mavx512dq -mavx512vl -mfma -mprefer-vector-width=512)
  # The loops on numbers that count what is done with them run once, for profiles.
  set(flags_counted $<$<CONFIG:Release>:-O1>)
  # Checks of every pointer that address sanitizer makes as well: they would take most of a sanitized build, and of its run.
  if(CMAKE_CXX_FLAGS MATCHES "fsanitize=[a-z,]*undefined")
    set(flags_baseline -fno-sanitize=null,alignment,object-size,pointer-overflow,vptr)
  endif()
  # GCC 12 takes the undefined lanes in its own intrinsics for an oversight (-Wno-maybe-uninitialized).
  foreach(level IN LISTS levels isa_AND)
    add_library(${target}_${level} OBJECT ${isa_UNPARSED_ARGUMENTS})
    target_include_directories(${target}_${level} PRIVATE ${isa_INCLUDES})
    target_link_libraries(${target}_${level} PRIVATE sluice_options ${isa_LIBRARIES})
    sluice_shareable(${target}_${level})
    sluice_few_pieces(${target}_${level})
    sluice_inline_as_alone(${target}_${level})
    target_compile_definitions(${target}_${level} PRIVATE SLUICE_ISA=${level} SLUICE_ISA_${level})
    target_compile_options(${target}_${level} PRIVATE -ffp-contract=fast -Wno-psabi -Wno-maybe-uninitialized ${flags_${level}})
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_${level}>)
  endforeach()
endfunction()
