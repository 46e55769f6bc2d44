# Installs the built tree, moves the result (an installed tree must not know where it came from),
# builds two programs against it and runs them: a tracer of one ray, and the example renderer on
# maps that the installed relievo-bake has made.
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  message("${output}")
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}: ${status}")
  endif()
endfunction()

set(staging "${WORK_DIR}/staging")
set(prefix "${WORK_DIR}/prefix")
set(build "${WORK_DIR}/build")
file(REMOVE_RECURSE "${staging}" "${prefix}" "${build}")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${staging}")
file(RENAME "${staging}" "${prefix}")

# A path of this checkout in the package would work here and nowhere else.
file(GLOB_RECURSE package_files "${prefix}/*.cmake")
foreach(file IN LISTS package_files)
  file(READ "${file}" text)
  foreach(path IN ITEMS "${SOURCE_DIR}" "${BUILD_DIR}" "${staging}")
    string(FIND "${text}" "${path}" position)
    if(NOT position EQUAL -1)
      message(FATAL_ERROR "${file} mentions ${path}")
    endif()
  endforeach()
endforeach()

run("${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${CMAKE_CURRENT_LIST_DIR}/consumer" -B "${build}"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_PREFIX_PATH=${prefix}"
  "-DOWN_RENDERER_SOURCE=${SOURCE_DIR}/materials/examples/own_renderer.cpp")
run("${CMAKE_COMMAND}" --build "${build}")
run("${build}/tracer")
run("${prefix}/bin/relievo-bake" relief "${SOURCE_DIR}/textures/samples/bricks-height.png"
  --cone conservative -o "${build}/bricks.exr")
run("${build}/own_renderer" "${build}/bricks.exr" "${build}/bricks.png")
file(SIZE "${build}/bricks.png" size)
if(size LESS 20000)
  message(FATAL_ERROR "bricks.png has ${size} bytes: an empty frame, which compresses to under 5000")
endif()
