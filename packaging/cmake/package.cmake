# What belongs to an installed program on Linux, and the Debian package (packaging/package.sh).
set(linux ${CMAKE_SOURCE_DIR}/packaging/linux)
set(share ${CMAKE_INSTALL_DATADIR})
set(maintainer "Analogon maintainers <maintainers@analogon.org>")
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # the programs alone are packed, whether the tests are built or not

install(DIRECTORY ${CMAKE_SOURCE_DIR}/examples DESTINATION ${share}/analogon
        PATTERN "*.py" EXCLUDE PATTERN "expected.json" EXCLUDE)
install(FILES ${linux}/org.analogon.Analogon.desktop DESTINATION ${share}/applications)
install(FILES ${linux}/org.analogon.Analogon.xml DESTINATION ${share}/mime/packages)
install(FILES ${linux}/org.analogon.Analogon.metainfo.xml DESTINATION ${share}/metainfo)
install(FILES ${linux}/org.analogon.Analogon.svg DESTINATION ${share}/icons/hicolor/scalable/apps)
install(FILES ${linux}/completions/analogon-cli.bash DESTINATION ${share}/bash-completion/completions RENAME analogon-cli)
install(FILES ${linux}/completions/analogon-cli.zsh DESTINATION ${share}/zsh/vendor-completions RENAME _analogon-cli)
install(FILES ${linux}/completions/analogon-cli.fish DESTINATION ${share}/fish/vendor_completions.d)
install(FILES ${linux}/copyright DESTINATION ${share}/doc/analogon)
install(FILES ${CMAKE_BINARY_DIR}/analogon.spdx.json DESTINATION ${share}/doc/analogon OPTIONAL)

# Debian wants man pages and change logs compressed, with nothing of the moment in them.
find_program(GZIP gzip REQUIRED)
function(install_compressed source destination name)
    set(compressed ${CMAKE_BINARY_DIR}/packaging/${name}.gz)
    file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/packaging)
    execute_process(COMMAND ${GZIP} -9nc ${source} OUTPUT_FILE ${compressed} COMMAND_ERROR_IS_FATAL ANY)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
    install(FILES ${compressed} DESTINATION ${destination})
endfunction()
install_compressed(${linux}/analogon.1 ${CMAKE_INSTALL_MANDIR}/man1 analogon.1)
install_compressed(${linux}/analogon-cli.1 ${CMAKE_INSTALL_MANDIR}/man1 analogon-cli.1)
install_compressed(${CMAKE_SOURCE_DIR}/CHANGELOG.md ${share}/doc/analogon CHANGES.md)
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${CMAKE_BINARY_DIR}/packaging/changelog
     "analogon (${PROJECT_VERSION}) bookworm; urgency=medium\n\n  * What has changed is told in CHANGES.md.gz.\n\n"
     " -- ${maintainer}  ${now}\n")
install_compressed(${CMAKE_BINARY_DIR}/packaging/changelog ${share}/doc/analogon changelog)

set(CPACK_PACKAGE_NAME analogon)
set(CPACK_PACKAGE_VENDOR Analogon)
set(CPACK_PACKAGE_CONTACT "${maintainer}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
    WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gcc, libc6-dev")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "models of components from test-bench measurements")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Composes the model of a component from blocks, estimates its parameters from
measurements, finds the physical effect that the model lacks, adds it at the
right place, fits again, and reports the error before and after on data that
the fit never saw. A desktop program and a program for the command line.")
set(CPACK_VERBATIM_VARIABLES ON)
include(CPack)
