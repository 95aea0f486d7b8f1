# Libraries, public headers, program and package files.
include(CMakePackageConfigHelpers)

install(TARGETS deltamesh_codec deltamesh_io deltamesh_gltf EXPORT deltameshTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS deltamesh_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY codec/include/deltamesh gltf_ext/include/deltamesh DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/deltamesh)
install(EXPORT deltameshTargets NAMESPACE deltamesh:: DESTINATION ${package_dir})
configure_package_config_file(cmake/deltameshConfig.cmake.in ${PROJECT_BINARY_DIR}/deltameshConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/deltameshConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/deltameshConfig.cmake ${PROJECT_BINARY_DIR}/deltameshConfigVersion.cmake
        DESTINATION ${package_dir})

# The installed tree may be moved: the .pc file finds its prefix from where it stands.
file(RELATIVE_PATH prefix_from_pkgconfig /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(cmake/deltamesh.pc.in ${PROJECT_BINARY_DIR}/deltamesh.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/deltamesh.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
