# Fails where cmake is older than the course needs.
if(CMAKE_VERSION VERSION_LESS 3.25)
  message(FATAL_ERROR "cmake ${CMAKE_VERSION} is older than 3.25")
endif()
