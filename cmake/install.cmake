# Installs libraries, headers, program and scenes, and the package that find_package(carom) reads.

option(CAROM_INSTALL "Install carom with this build" ${PROJECT_IS_TOP_LEVEL})
if(NOT CAROM_INSTALL)
  return()
endif()

include(CMakePackageConfigHelpers)
set(CAROM_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/carom)

get_property(carom_libraries GLOBAL PROPERTY CAROM_LIBRARIES)
install(TARGETS ${carom_libraries} EXPORT caromTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT caromTargets NAMESPACE carom:: DESTINATION ${CAROM_PACKAGE_DIR})

# Headers only of what was built: a package without pictures has no carom/draw.
set(carom_components ${carom_libraries})
list(TRANSFORM carom_components REPLACE "^carom_" "")
foreach(component IN LISTS carom_components)
  install(DIRECTORY include/carom/${component} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/carom OPTIONAL
          FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(FILES include/carom/carom.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/carom)

if(TARGET carom_program)
  install(TARGETS carom_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(DIRECTORY scenes/ DESTINATION ${CMAKE_INSTALL_DATADIR}/carom/scenes)
# The page, where it was built (scripts/build-web).
install(DIRECTORY web/dist/page/ DESTINATION ${CMAKE_INSTALL_DATADIR}/carom/lab OPTIONAL)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/caromConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/caromConfig.cmake INSTALL_DESTINATION ${CAROM_PACKAGE_DIR})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/caromConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/caromConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/caromConfigVersion.cmake
        DESTINATION ${CAROM_PACKAGE_DIR})
