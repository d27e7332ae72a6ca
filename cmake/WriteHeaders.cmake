# Copies HEADERS, which lie in ROOT/host or ROOT, to INTO/pelage and lets them include each other there. Run by
# PublicHeaders.cmake.
file(REMOVE_RECURSE ${INTO})
foreach(header IN LISTS HEADERS)
  string(REPLACE "${ROOT}/host/" "" place ${header})
  string(REPLACE "${ROOT}/" "" place ${place})
  file(READ ${header} text)
  string(REGEX REPLACE "#include \"(core|io|language|opencl|reference)/" "#include \"pelage/\\1/" text "${text}")
  file(WRITE ${INTO}/pelage/${place} "${text}")
endforeach()
file(WRITE ${STAMP} "")
