// Shader programs, built from the embedded shaders.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string_view>

#include "render/gl/object.h"
#include "ryosen/base/result.h"

namespace ryosen {

struct ProgramKind {
  static constexpr GLenum identifier = GL_PROGRAM;
  static GLuint create();
  static void destroy(GLuint id);
};

// A linked program. Uniforms are set by name after use(); unused names are ignored.
class Program {
 public:
  // Compiles `vertex` and `fragment`, file names in shaders/, with `defines` behind the line of their version. Where
  // the driver refuses that, `failure` is ExitCode::no_backend with its log, and the program of no use. It keeps a
  // failure that it has already: of several programs the first one that is refused is told.
  Program(std::optional<Failure>& failure, const char* vertex, const char* fragment, std::string_view defines = {});

  void use() const { glUseProgram(object_.id()); }
  void set(const char* name, int value) const { glUniform1i(location(name), value); }
  void set(const char* name, float value) const { glUniform1f(location(name), value); }
  void set(const char* name, glm::ivec2 value) const { glUniform2i(location(name), value.x, value.y); }
  void set(const char* name, glm::vec2 value) const { glUniform2f(location(name), value.x, value.y); }
  void set(const char* name, glm::vec3 value) const { glUniform3f(location(name), value.x, value.y, value.z); }
  void set(const char* name, glm::vec4 value) const { glUniform4f(location(name), value.x, value.y, value.z, value.w); }
  void set(const char* name, const glm::mat4& value) const {
    glUniformMatrix4fv(location(name), 1, GL_FALSE, &value[0][0]);
  }

 private:
  GLint location(const char* name) const { return glGetUniformLocation(object_.id(), name); }

  GlObject<ProgramKind> object_;
};

}  // namespace ryosen
