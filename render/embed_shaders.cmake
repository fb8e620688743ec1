# Writes OUTPUT, a C++ file with the text of every shader in FOLDER. A line `#include "name"` is replaced by the text of
# that file. Run as: cmake -DFOLDER=... -DOUTPUT=... -P embed_shaders.cmake
function(read_shader path result)
  file(READ ${path} text)
  string(REGEX MATCHALL "#include \"[a-z_.]+\"" includes "${text}")
  foreach(line IN LISTS includes)
    string(REGEX REPLACE "#include \"([a-z_.]+)\"" "\\1" name "${line}")
    read_shader(${FOLDER}/${name} part)
    string(REPLACE "${line}" "${part}" text "${text}")
  endforeach()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

file(GLOB shaders ${FOLDER}/*.vert ${FOLDER}/*.frag)
list(SORT shaders)
set(rows "")
foreach(shader IN LISTS shaders)
  get_filename_component(name ${shader} NAME)
  read_shader(${shader} text)
  string(APPEND rows "    {\"${name}\", R\"glsl(${text})glsl\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"render/gl/shader_sources.h\"

namespace ryosen {

const std::vector<ShaderSource>& shader_sources() {
  static const std::vector<ShaderSource> sources = {
${rows}  };
  return sources;
}

}  // namespace ryosen
")
