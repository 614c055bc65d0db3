# The Debian package. packaging/build.py runs cpack with the version and, in the environment, CLS_ROOT,
# the installed files.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME cls)
set(CPACK_PACKAGE_FILE_NAME cls)
set(CPACK_PACKAGE_VENDOR "the cls maintainers")
set(CPACK_PACKAGE_CONTACT "the cls maintainers <cls@localhost.localdomain>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "RoboCup 2D soccer matches between gRPC Playmakers")
set(CPACK_PACKAGE_DESCRIPTION
"Plays, evaluates and tests soccer matches of the RoboCup 2D simulation league
between teams whose decisions come from gRPC servers in any language. One
program has the soccer server, the agents, tournaments, scenario tests and
statistics. The package also has the Python packages cls_playmaker and cls_gym
and the library libcls_training for learning programs.")
set(CPACK_INSTALLED_DIRECTORIES "$ENV{CLS_ROOT};/")
set(CPACK_PACKAGING_INSTALL_PREFIX "/")
set(CPACK_SET_DESTDIR OFF)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE amd64)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
# The program was linked with this one; everything else is inside.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libc6 (>= 2.36)")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-grpcio, python3-numpy, python3-protobuf, rcssserver")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA 
  "${CMAKE_CURRENT_LIST_DIR}/triggers;${CMAKE_CURRENT_LIST_DIR}/shlibs")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION TRUE)
