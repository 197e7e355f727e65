# cmake --install BUILD --prefix PREFIX: programs, configuration, systemd units and goalnet_msgs. The programs find the
# configuration beside themselves, so the tree may be moved as a whole; only the units name its place.
install(TARGETS goalnet goalnet-robot goalnet-train goalnet-bench-peer RUNTIME DESTINATION bin)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/config DESTINATION share/goalnet PATTERN systemd EXCLUDE)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/idl/goalnet_msgs DESTINATION share/goalnet/idl)
install(FILES ${CMAKE_SOURCE_DIR}/README.md ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION share/doc/goalnet)

set(systemd ${CMAKE_SOURCE_DIR}/config/systemd)
install(FILES ${systemd}/goalnet.target DESTINATION lib/systemd/system)
install(FILES ${systemd}/goalnet.sysusers DESTINATION lib/sysusers.d RENAME goalnet.conf)
# The prefix is known when installing, not when configuring.
install(CODE "file(READ \"${systemd}/goalnet@.service\" unit)")
install(CODE [[
string(REPLACE "/usr/local/bin/goalnet" "${CMAKE_INSTALL_PREFIX}/bin/goalnet" unit "${unit}")
set(place "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/lib/systemd/system/goalnet@.service")
message(STATUS "Installing: ${place}")
file(WRITE "${place}" "${unit}")
]])
