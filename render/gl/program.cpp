#include "render/gl/program.h"

#include <array>
#include <iterator>
#include <string>
#include <utility>

#include "render/gl/shader_sources.h"

namespace ryosen {

GLuint ProgramKind::create() { return glCreateProgram(); }
void ProgramKind::destroy(GLuint id) { glDeleteProgram(id); }

namespace {

Failure refused_by_driver(const std::string& name, const std::string& log) {
  return make_failure(ExitCode::no_backend, "shader_refused",
                      {"The graphics driver refuses the shader " + name + ": " + log,
                       "グラフィックスドライバーがシェーダー " + name + " を受け付けません: " + log});
}

// Compiles one shader and attaches it; returns the driver's log on failure, else empty.
std::string attach(GLuint program, GLenum stage, const char* name, std::string_view defines) {
  for (const ShaderSource& source : shader_sources()) {
    if (source.name != name) continue;
    const GLuint shader = glCreateShader(stage);
    const std::size_t version_end = source.text.find('\n') + 1;
    const std::string_view all(source.text), parts[] = {all.substr(0, version_end), defines, all.substr(version_end)};
    std::array<const char*, std::size(parts)> texts;
    std::array<GLint, std::size(parts)> lengths;
    for (std::size_t i = 0; i < std::size(parts); ++i) {
      texts[i] = parts[i].data() ? parts[i].data() : "";
      lengths[i] = static_cast<GLint>(parts[i].size());
    }
    glShaderSource(shader, static_cast<GLsizei>(texts.size()), texts.data(), lengths.data());
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    std::string log(compiled ? 0 : 1000, '\0');
    if (!compiled) {
      GLsizei written = 0;
      glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &written, log.data());
      log.resize(static_cast<std::size_t>(written));
      if (log.empty()) log = "unknown error";
    }
    glAttachShader(program, shader);
    glDeleteShader(shader);
    return log;
  }
  return "no such shader";
}

}  // namespace

Program::Program(std::optional<Failure>& failure, const char* vertex, const char* fragment, std::string_view defines)
    : object_(vertex) {
  if (failure) return;
  const GLuint id = object_.id();
  for (const auto& [stage, name] : {std::pair(GL_VERTEX_SHADER, vertex), std::pair(GL_FRAGMENT_SHADER, fragment)})
    if (const std::string log = attach(id, stage, name, defines); !log.empty()) {
      failure = refused_by_driver(name, log);
      return;
    }
  glLinkProgram(id);
  GLint linked = 0;
  glGetProgramiv(id, GL_LINK_STATUS, &linked);
  if (linked) return;
  std::string log(1000, '\0');
  GLsizei written = 0;
  glGetProgramInfoLog(id, static_cast<GLsizei>(log.size()), &written, log.data());
  log.resize(static_cast<std::size_t>(written));
  failure = refused_by_driver(std::string(vertex) + " + " + fragment, log);
}

}  // namespace ryosen
