# Installs a built tree, builds the consumer against what was installed and nothing else, and holds what it prints and
# saves against what it must. Run by CTest as cmake -DBUILD=... -P check.cmake, see tests/CMakeLists.txt.
set(folder ${BUILD}/consumer)
set(prefix ${folder}/installed)
file(REMOVE_RECURSE ${folder})

# run(NAME COMMAND...) keeps what the command printed in the variable NAME and ends the test when it fails.
function(run name)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${folder}
                  RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "exit ${status} from ${ARGN}\n${out}${err}")
  endif()
  set(${name} "${out}" PARENT_SCOPE)
endfunction()

function(expect what actual expected)
  if(NOT actual STREQUAL expected)
    message(FATAL_ERROR "${what}:\n${actual}\nexpected:\n${expected}")
  endif()
endfunction()

file(MAKE_DIRECTORY ${folder})
run(ignored ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
# Whatever was installed must also work without the folders that it was made from.
file(GLOB_RECURSE package_files ${prefix}/*.cmake)
foreach(file IN LISTS package_files)
  file(READ ${file} content)
  foreach(origin IN ITEMS ${SOURCE} ${BUILD})
    string(FIND "${content}" ${origin} place)
    expect("${file} names ${origin} at" ${place} -1)
  endforeach()
endforeach()
if(NOT EXISTS ${prefix}/share/doc/ryosen/LICENSE)
  message(FATAL_ERROR "the licence is not installed")
endif()

run(ignored ${CMAKE_COMMAND} -S ${SOURCE}/tests/consumer -B ${folder}/build -G ${GENERATOR}
    -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS}
    -DCMAKE_BUILD_TYPE=${CONFIGURATION})
run(ignored ${CMAKE_COMMAND} --build ${folder}/build)

set(consumer ${folder}/build/consumer)
set(cube ${SOURCE}/assets/cube.obj)
run(out ${consumer} ${cube} 1-2 saved.obj)
expect("collapse on a cube" "${out}" "ring: v2 v5 v0\ncollapsed: V 7, E 11\nat the end: V 8, E 12\n")
file(READ ${cube} given)
file(READ ${folder}/saved.obj saved)
expect("the cube saved after undo" "${saved}" "${given}")
run(out ${consumer} ${SOURCE}/assets/tetrahedron.off 1-2 saved.off)
expect("collapse on a tetrahedron" "${out}" "ring: v2 v3 v0\nrefused: duplicate_face\nat the end: V 4, E 6\n")

file(READ ${SOURCE}/vcpkg.json manifest)
string(JSON manifest_version GET "${manifest}" version)
expect("the version in vcpkg.json" "${manifest_version}" "${VERSION}")
if(NOT CORE_ONLY)
  run(out ${prefix}/bin/ryosen --version)
  expect("the version of the installed program" "${out}" "ryosen ${VERSION}\n")
  run(ignored ${prefix}/bin/ryosen check ${cube})
endif()
