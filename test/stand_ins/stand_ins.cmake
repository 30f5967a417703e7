# SPDX-License-Identifier: BSD-3-Clause
# MBNCC_STAND_INS: prefix of the message packages that generate.py writes. vision_msgs_INCLUDE_DIRS points to them if
# the package is not installed.
set(MBNCC_STAND_INS ${PROJECT_BINARY_DIR}/stand_ins)
set(generator ${PROJECT_SOURCE_DIR}/test/stand_ins/generate.py)
if("${generator}" IS_NEWER_THAN "${MBNCC_STAND_INS}/complete")
  message(STATUS "Generating stand-ins of message packages for tests")
  execute_process(
    COMMAND ${PYTHON_EXECUTABLE} ${generator} ${MBNCC_STAND_INS} ${GENCPP_BIN} ${GENCPP_TEMPLATE_DIR} ${GENMSG_PY_BIN}
            ${std_msgs_DIR}/../..
    RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "the stand-ins of message packages cannot be generated")
  endif()
  file(TOUCH ${MBNCC_STAND_INS}/complete)
endif()
if(NOT vision_msgs_FOUND)
  set(vision_msgs_INCLUDE_DIRS ${MBNCC_STAND_INS}/include)
endif()
