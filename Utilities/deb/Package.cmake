# The Debian package, which Utilities/deb.sh makes: the plugin, the Python package, the documentation.
# All but the Python package and the documentation is in lib/<architecture>/shapemap.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME shapemap)
set(CPACK_PACKAGE_VERSION "${ShapeMap_VERSION}")
set(CPACK_PACKAGE_CONTACT "the ShapeMap developers <shapemap@shapemap.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_COMPONENTS_ALL Unspecified runtime python deb)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "maps between shapes, as filters of ParaView")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Which point of one shape corresponds to which point of another? ShapeMap
computes such maps and uses them. It maps a surface onto a sphere without
flipping a triangle, and a solid onto another by a harmonic map. It fills
solids with hexahedra, cuts and pastes features, and transfers fields from
one shape to another.

The filters are in the menu Filters of ParaView, in pvpython and pvserver,
and in the Python package shapemap.")
# The libraries of ParaView say that they are for one release of it.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_DEBIAN_PACKAGE_DEPENDS
  "paraview (>= 5.11), paraview (<< 5.12~), python3-paraview (>= 5.11), python3-paraview (<< 5.12~), python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
# It draws the pictures of the command shapemap where there is no display.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "xvfb")
# Python's compiled files come and go with the package.
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA
  "${CMAKE_CURRENT_LIST_DIR}/postinst" "${CMAKE_CURRENT_LIST_DIR}/prerm")

# ParaView's programs read this file beside them, and load the plugins that it names.
file(RELATIVE_PATH plugins_file /usr/bin
  "/usr/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/shapemap.plugins.xml")
set(written "${CMAKE_CURRENT_BINARY_DIR}/deb")
file(WRITE "${written}/paraview.conf" "${plugins_file}\n")
install(FILES "${written}/paraview.conf" DESTINATION bin COMPONENT deb EXCLUDE_FROM_ALL)

set(documents share/doc/shapemap)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE "${written}/changelog" "shapemap (${ShapeMap_VERSION}-1) unstable; urgency=medium

  * The first package. What is new in ShapeMap is in changelog.gz.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
configure_file(CHANGELOG.md "${written}/CHANGELOG.md" COPYONLY)
execute_process(COMMAND gzip -9nf "${written}/changelog" "${written}/CHANGELOG.md")
install(FILES "${written}/changelog.gz" RENAME changelog.Debian.gz
  DESTINATION "${documents}" COMPONENT deb EXCLUDE_FROM_ALL)
install(FILES "${written}/CHANGELOG.md.gz" RENAME changelog.gz
  DESTINATION "${documents}" COMPONENT deb EXCLUDE_FROM_ALL)
configure_file("${CMAKE_CURRENT_LIST_DIR}/shapemap.1" "${written}/shapemap.1" COPYONLY)
execute_process(COMMAND gzip -9nf "${written}/shapemap.1")
install(FILES "${written}/shapemap.1.gz" DESTINATION share/man/man1 COMPONENT deb EXCLUDE_FROM_ALL)
configure_file("${CMAKE_CURRENT_LIST_DIR}/copyright.in" "${written}/copyright" @ONLY)
install(FILES "${written}/copyright" README.md
  DESTINATION "${documents}" COMPONENT deb EXCLUDE_FROM_ALL)
install(DIRECTORY Documentation DESTINATION "${documents}" COMPONENT deb EXCLUDE_FROM_ALL)
install(FILES "${CMAKE_CURRENT_LIST_DIR}/lintian-overrides" RENAME shapemap
  DESTINATION share/lintian/overrides COMPONENT deb EXCLUDE_FROM_ALL)
include(CPack)
