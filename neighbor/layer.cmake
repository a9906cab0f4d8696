# sluice_layer([INTO LIBRARY] [SEES ROOM...] [SOURCES FILE...] [ISA_SOURCES FILE... [COUNTED]] [LIBRARIES PACKAGE...]
#              [SELDOM])
#
# A room of the house, which is the folder that calls this: its headers, and its sources as a part of the static LIBRARY.
# It is compiled with the headers of the rooms that it SEES, of those that these see, and with no others: an include that
# climbs names a file that the compiler does not find. A room must be laid before it can be seen, so that no circle of
# rooms can be written down. A package that a room is compiled with comes with seeing it.
#
# ISA_SOURCES are compiled for each instruction set (isa.cmake), COUNTED also with numbers that count what is done with them.
# SELDOM: nothing in the room takes time in a run; it is optimised less.
#
# Each room has a folder of links to its own headers, build/layers/ROOM, in which they have the same names as here.
function(sluice_layer)
  cmake_parse_arguments(PARSE_ARGV 0 layer "COUNTED;SELDOM" "INTO" "SEES;SOURCES;ISA_SOURCES;LIBRARIES")
  if(layer_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "sluice_layer: what is ${layer_UNPARSED_ARGUMENTS}?")
  endif()
  file(RELATIVE_PATH room ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  sluice_link_headers(${room} trees)
  set(packages ${layer_LIBRARIES})
  foreach(seen IN LISTS layer_SEES)
    sluice_seen(${seen} seen_trees seen_packages)
    list(APPEND trees ${seen_trees})
    list(APPEND packages ${seen_packages})
  endforeach()
  list(REMOVE_DUPLICATES trees)
  list(REMOVE_DUPLICATES packages)
  set_property(GLOBAL APPEND PROPERTY sluice_rooms ${room})
  set_property(GLOBAL PROPERTY sluice_trees_of_${room} ${trees})
  set_property(GLOBAL PROPERTY sluice_packages_of_${room} ${packages})

  string(MAKE_C_IDENTIFIER room_${room} target)
  if(layer_SOURCES)
    add_library(${target} OBJECT ${layer_SOURCES})
    sluice_shareable(${target})
    target_include_directories(${target} PRIVATE ${trees})
    target_link_libraries(${target} PRIVATE sluice_options ${packages})
    sluice_few_pieces(${target})
    sluice_inline_as_alone(${target})
    if(layer_SELDOM)
      target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    endif()
  endif()
  if(layer_INTO)
    target_link_libraries(${layer_INTO} PRIVATE ${layer_LIBRARIES})
    if(layer_SOURCES)
      target_sources(${layer_INTO} PRIVATE $<TARGET_OBJECTS:${target}>)
    endif()
  endif()
  if(layer_ISA_SOURCES)
    set(and "")
    if(layer_COUNTED)
      set(and AND counted)
    endif()
    sluice_add_isa_sources(${layer_INTO} ${layer_ISA_SOURCES} INCLUDES ${trees} LIBRARIES ${packages} ${and})
  endif()
endfunction()

# Makes the folder of links of a room, and tells its name in the variable `tree`.
function(sluice_link_headers room tree)
  string(REPLACE "/" "." name ${room})
  set(folder ${PROJECT_BINARY_DIR}/layers/${name})
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *.hpp *.def)
  file(REMOVE_RECURSE ${folder})
  file(MAKE_DIRECTORY ${folder}/${room})
  foreach(header IN LISTS headers)
    file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR}/${header} ${folder}/${room}/${header} SYMBOLIC)
  endforeach()
  set(${tree} ${folder} PARENT_SCOPE)
endfunction()

# Tells with which folders of links and which packages those are compiled who see a room.
function(sluice_seen room trees packages)
  get_property(laid GLOBAL PROPERTY sluice_trees_of_${room} SET)
  if(NOT laid)
    message(FATAL_ERROR "${CMAKE_CURRENT_SOURCE_DIR} sees ${room}, which is not laid before it")
  endif()
  get_property(value GLOBAL PROPERTY sluice_trees_of_${room})
  set(${trees} ${value} PARENT_SCOPE)
  get_property(value GLOBAL PROPERTY sluice_packages_of_${room})
  set(${packages} ${value} PARENT_SCOPE)
endfunction()

# Lists the rooms, from the ground up, each with the folders of links that it is compiled with, for tests/layers.py.
function(sluice_write_layers file)
  get_property(rooms GLOBAL PROPERTY sluice_rooms)
  set(text "")
  foreach(room IN LISTS rooms)
    get_property(trees GLOBAL PROPERTY sluice_trees_of_${room})
    string(APPEND text "${room};${trees}\n")
  endforeach()
  file(WRITE ${file} "${text}")
endfunction()
