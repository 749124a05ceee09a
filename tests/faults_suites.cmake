# The faults every chapter program survives, tried from outside. Included by CMakeLists.txt here.

if(UNIX AND PYTHON3)
  set(faults "${PYTHON3}" "${CMAKE_CURRENT_SOURCE_DIR}/faults/faults.py")
  add_test(NAME faults COMMAND ${faults} "$<TARGET_FILE_DIR:01_plain_spheres>" "${CMAKE_CURRENT_SOURCE_DIR}/corpus")
  add_test(NAME faults_can_fail COMMAND ${faults} --self-test)
  # Alone on the machine: it measures time, and starts many programs at once.
  set_tests_properties(faults PROPERTIES LABELS faults RUN_SERIAL ON TIMEOUT 240)
  set_tests_properties(faults_can_fail PROPERTIES LABELS faults TIMEOUT 60)
  if(TEXMAP_INSTRUMENT MATCHES "fsanitize")
    set_tests_properties(faults PROPERTIES ENVIRONMENT TEXMAP_SANITIZED=1 TIMEOUT 1200)
  endif()
endif()
