# SPDX-License-Identifier: GPL-3.0-or-later
# What is installed beside the plugin and the Python package, and the Debian package of it all.
include(GNUInstallDirs)
set(package paraview-foam)
install(FILES README.md CHANGELOG.md
  DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}" COMPONENT documentation)
install(FILES cmake/debian-copyright
  DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}" COMPONENT documentation RENAME copyright)
install(DIRECTORY docs
  DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}" COMPONENT documentation)
install(DIRECTORY examples sample-data
  DESTINATION "${CMAKE_INSTALL_DATADIR}/${package}" COMPONENT documentation)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME "${package}")
set(CPACK_PACKAGE_CONTACT "The authors of Foam <foam@localhost>")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "A plugin that turns points into foam, lets it coarsen and
measures it, as filters of ParaView and of its Python.")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_PACKAGING_INSTALL_PREFIX "${CMAKE_INSTALL_PREFIX}")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_CMAKE_PROJECTS)
foreach(component IN ITEMS runtime python documentation)
  list(APPEND CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};Foam;${component};/")
endforeach()
# Libraries are found by themselves; the plugin needs the very ParaView that it is built for.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(FOAM_PARAVIEW_VERSION)
  string(REGEX MATCH "^([0-9]+)\\.([0-9]+)" this_version "${FOAM_PARAVIEW_VERSION}")
  math(EXPR next_minor "${CMAKE_MATCH_2} + 1")
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "paraview (>= ${this_version}), \
paraview (<< ${CMAKE_MATCH_1}.${next_minor}), python3-paraview")
endif()
# The icons of ParaView's windows, of Qt 5 and 6.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libqt5svg5")
if(FOAM_PARAVIEW_VERSION VERSION_GREATER_EQUAL 5.13)
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "qt6-svg-plugins")
endif()
include(CPack)
