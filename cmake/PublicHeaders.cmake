# The library's public face: a copy of the public headers in which "core/x.hpp" is "pelage/core/x.hpp", so that whoever
# uses Pelage has one folder more to look in, and nothing but pelage/ in it.
set(PELAGE_PUBLIC_INCLUDE ${PROJECT_BINARY_DIR}/include)
file(GLOB public_headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/host
  ${PROJECT_SOURCE_DIR}/host/pelage.hpp ${PROJECT_SOURCE_DIR}/host/core/*.hpp ${PROJECT_SOURCE_DIR}/host/io/*.hpp)
# Of the language and the backends only the doors; what lies behind them may change.
list(APPEND public_headers language/lint.hpp language/outline.hpp language/parse.hpp opencl/backend.hpp
  opencl/device/device.hpp opencl/device/options.hpp)
list(TRANSFORM public_headers PREPEND ${PROJECT_SOURCE_DIR}/host/)
list(APPEND public_headers ${PROJECT_SOURCE_DIR}/reference/backend.hpp)
set(public_stamp ${PELAGE_PUBLIC_INCLUDE}/made)
add_custom_command(
  OUTPUT ${public_stamp}
  COMMAND ${CMAKE_COMMAND} -DINTO=${PELAGE_PUBLIC_INCLUDE} -DSTAMP=${public_stamp} -DROOT=${PROJECT_SOURCE_DIR}
          "-DHEADERS=${public_headers}" -P ${PROJECT_SOURCE_DIR}/cmake/WriteHeaders.cmake
  DEPENDS ${public_headers} ${PROJECT_SOURCE_DIR}/cmake/WriteHeaders.cmake
  COMMENT "Copying public headers"
  VERBATIM)
add_custom_target(pelage_public_headers ALL DEPENDS ${public_stamp})
