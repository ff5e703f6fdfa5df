# SPDX-License-Identifier: Apache-2.0
# What is installed. Called once for the prefix (cmake --install, the tarball) and once for the .deb packages, whose libraries
# lie elsewhere: those rules are components that nothing but the packages takes.
#   toothseg_install(LIBDIR EXPORT RUNTIME_COMPONENT DEV_COMPONENT [EXCLUDE_FROM_ALL])
function(toothseg_install libdir export runtime dev)
  set(runtime COMPONENT ${runtime} ${ARGN})
  set(namelink NAMELINK_COMPONENT ${dev})
  set(dev COMPONENT ${dev} ${ARGN})
  set(config ${libdir}/cmake/toothseg)
  set(made ${PROJECT_BINARY_DIR}/${export})

  install(FILES ${PROJECT_SOURCE_DIR}/include/toothseg.h ${PROJECT_SOURCE_DIR}/include/toothseg.hpp
    ${PROJECT_SOURCE_DIR}/synth/include/toothseg_arch.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${dev})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/toothseg DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${dev})
  foreach(library toothseg_shared toothseg_static toothseg_arch)
    if(TARGET ${library})
      install(TARGETS ${library} EXPORT ${export}
        LIBRARY DESTINATION ${libdir} ${runtime} ${namelink} ARCHIVE DESTINATION ${libdir} ${dev}
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} ${runtime})
    endif()
  endforeach()
  if(WIN32 AND TARGET toothseg_shared)
    install(FILES ${PROJECT_BINARY_DIR}/src/api/toothseg.lib ${PROJECT_SOURCE_DIR}/abi/toothseg.def DESTINATION ${libdir} ${dev})
  endif()
  install(EXPORT ${export} FILE toothsegTargets.cmake NAMESPACE toothseg:: DESTINATION ${config} ${dev})
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/toothsegConfig.cmake.in ${made}/toothsegConfig.cmake
    INSTALL_DESTINATION ${config})
  write_basic_package_version_file(${made}/toothsegConfigVersion.cmake COMPATIBILITY SameMajorVersion)
  install(FILES ${made}/toothsegConfig.cmake ${made}/toothsegConfigVersion.cmake DESTINATION ${config} ${dev})
  file(RELATIVE_PATH pc_to_prefix /prefix/${libdir}/pkgconfig /prefix)
  string(REPLACE TBB::tbb " -ltbb" link_tbb "${TOOTHSEG_TBB}")
  configure_file(${PROJECT_SOURCE_DIR}/cmake/toothseg.pc.in ${made}/toothseg.pc @ONLY)
  install(FILES ${made}/toothseg.pc DESTINATION ${libdir}/pkgconfig ${dev})
endfunction()
