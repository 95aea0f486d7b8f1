# Libraries, public headers, program and package files, as far as they are built.
include(CMakePackageConfigHelpers)

set(headers ${PROJECT_SOURCE_DIR}/codec/include/deltamesh)
set(header_dir ${CMAKE_INSTALL_INCLUDEDIR}/deltamesh)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/deltamesh)
set(pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# The installed tree may be moved: the .pc files find their prefix from where they stand.
file(RELATIVE_PATH prefix_from_pkgconfig /prefix/${pkgconfig_dir} /prefix)
function(deltamesh_install_pkgconfig name)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${name}.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${pkgconfig_dir})
endfunction()

set(components decoder)
deltamesh_install_pkgconfig(deltamesh-decoder)
install(FILES ${headers}/decode.h ${headers}/known_mesh.h ${headers}/mesh.h ${headers}/model_states.h ${headers}/result.h ${headers}/stream_info.h ${headers}/version.h
              ${headers}/voxel_grid.h
        DESTINATION ${header_dir})
if(DELTAMESH_MAP)
  list(APPEND components receiver)
  deltamesh_install_pkgconfig(deltamesh-receiver)
  foreach(header IN ITEMS description fragment messages part part_entry part_key pose receiver smooth_normals)
    install(FILES map/include/deltamesh/map/${header}.h DESTINATION ${header_dir}/map)
  endforeach()
endif()
if(NOT DELTAMESH_DECODER_ONLY)
  list(APPEND components codec)
  deltamesh_install_pkgconfig(deltamesh)
  install(FILES ${headers}/anchor_containers.h ${headers}/attribute_quality.h ${headers}/compare.h ${headers}/encode.h ${headers}/find_grid.h
                ${headers}/quality_request.h
          DESTINATION ${header_dir})
endif()
if(TARGET deltamesh_files)
  list(APPEND components files)
  install(FILES ${headers}/files.h DESTINATION ${header_dir})
endif()
if(DELTAMESH_FILES)
  list(APPEND components io gltf)
  install(FILES ${headers}/io.h DESTINATION ${header_dir})
  install(DIRECTORY gltf_ext/include/deltamesh DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endif()
if(TARGET deltamesh_map)
  list(APPEND components map)
  deltamesh_install_pkgconfig(deltamesh-map)
  install(DIRECTORY map/include/deltamesh DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endif()
if(DELTAMESH_CLI)
  install(TARGETS deltamesh_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

list(TRANSFORM components PREPEND deltamesh_ OUTPUT_VARIABLE libraries)
install(TARGETS ${libraries} EXPORT deltameshTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT deltameshTargets NAMESPACE deltamesh:: DESTINATION ${package_dir})
configure_package_config_file(cmake/deltameshConfig.cmake.in ${PROJECT_BINARY_DIR}/deltameshConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/deltameshConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/deltameshConfig.cmake ${PROJECT_BINARY_DIR}/deltameshConfigVersion.cmake
        DESTINATION ${package_dir})
