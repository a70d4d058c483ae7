# An installed carom can be moved: no file of its package names the tree it was built in.
# cmake -DBUILD=… -DSOURCE=… -DPREFIX=… -P install.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${PREFIX} ${PREFIX}.first)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX}.first
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${PREFIX}.first ${PREFIX})

file(GLOB_RECURSE package_files ${PREFIX}/*.cmake)
if(NOT package_files)
  message(FATAL_ERROR "nothing for find_package() was installed")
endif()
foreach(package_file IN LISTS package_files)
  file(READ ${package_file} text)
  foreach(tree IN ITEMS ${BUILD} ${SOURCE} ${PREFIX}.first)
    string(FIND "${text}" "${tree}" at)
    if(NOT at EQUAL -1)
      message(FATAL_ERROR "${package_file} names ${tree}")
    endif()
  endforeach()
endforeach()

file(GLOB scenes ${PREFIX}/share/carom/scenes/*.toml)
if(NOT scenes)
  message(FATAL_ERROR "no scenes were installed")
endif()
