# The faults every chapter program survives, tried from outside. Included by tests/CMakeLists.txt.

if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND PYTHON3)
  # Alone on the machine: it measures time, and starts many programs at once.
  add_check(faults faults "${PYTHON3}" "${tests}/faults/faults.py" "$<TARGET_FILE_DIR:01_plain_spheres>" "${tests}/corpus"
    WITH RUN_SERIAL ON TIMEOUT 240)
  if(TEXMAP_INSTRUMENT MATCHES "fsanitize")
    set_tests_properties(faults PROPERTIES ENVIRONMENT TEXMAP_SANITIZED=1 TIMEOUT 1200)
  endif()
endif()
