// Feeds tinyobjloader an OBJ file line by line; its callbacks say what each line is.
#include <tiny_obj_loader.h>

#include <cstring>
#include <istream>
#include <streambuf>

#include "core/io/obj.h"
#include "core/io/obj_builder.h"
#include "core/io/text_lines.h"

namespace ryosen {
namespace {

// A stream that hands out one logical line at a time, straight from the bytes of the file where the line stands there
// whole. When the next line is asked for, no callback has come for some lines (s, l, p, mtllib, a bare keyword, unknown
// words); these are told from their first word. Comments and blank lines are not handed out at all.
class ObjFeed : public std::streambuf {
 public:
  ObjFeed(TextLines& lines, ObjBuilder& builder) : lines_(lines), builder_(builder) {}

  // What follows the keyword, for the callback of a line.
  std::string_view after_keyword(std::size_t keyword_length) {
    has_called_ = true;
    return text_.substr(keyword_length);
  }
  ObjBuilder& builder() { return builder_; }

 protected:
  int_type underflow() override {
    if (!has_called_) take_line_without_callback();
    has_called_ = true;
    TextLine line;
    while (!builder_.has_failed() && lines_.next(line)) {
      const char* begin = line.text.data();
      const char* const end = begin + line.text.size();
      while (begin != end && (*begin == ' ' || *begin == '\t')) ++begin;
      if (begin == end) continue;
      text_ = {begin, static_cast<std::size_t>(end - begin)};
      if (*begin == '#') {
        builder_.comment(text_);
        continue;
      }
      has_called_ = false;
      // The stream only reads; the type asks for a pointer that could write. The line end belongs to the line.
      char* const area = const_cast<char*>(begin);
      setg(area, area, const_cast<char*>(end) + (*end == '\r' ? 2 : 1));
      return traits_type::to_int_type(*begin);
    }
    setg(nullptr, nullptr, nullptr);
    return traits_type::eof();
  }

 private:
  void take_line_without_callback() {
    using Kind = ObjBuilder::NameKind;
    std::string_view rest = text_;
    const std::string_view word = take_word(rest);
    if (word == "f") return builder_.face(rest);
    if (word == "l" || word == "p") return builder_.element(word == "p", rest);
    if (word == "s") return builder_.name(Kind::smoothing, rest);
    if (word == "g") return builder_.name(Kind::group, rest);
    if (word == "o") return builder_.name(Kind::object, rest);
    if (word == "usemtl") return builder_.name(Kind::material, rest);
    if (word == "mtllib") return builder_.material_library(rest);
    if (word == "v") return builder_.vertex(rest);
    if (word == "vt") return builder_.texcoord(rest);
    if (word == "vn") return builder_.normal(rest);
    builder_.unknown(word);
  }

  TextLines& lines_;
  ObjBuilder& builder_;
  std::string_view text_;   // the line handed out, without the blanks before it
  bool has_called_ = true;  // no line is waiting to be told by its first word
};

ObjFeed& feed_of(void* data) { return *static_cast<ObjFeed*>(data); }

// The numbers that arrive here are dropped: they are rounded loosely and wrap. The builder reads them from the line.
void on_vertex(void* data, tinyobj::real_t, tinyobj::real_t, tinyobj::real_t, tinyobj::real_t) {
  feed_of(data).builder().vertex(feed_of(data).after_keyword(1));
}
void on_normal(void* data, tinyobj::real_t, tinyobj::real_t, tinyobj::real_t) {
  feed_of(data).builder().normal(feed_of(data).after_keyword(2));
}
void on_texcoord(void* data, tinyobj::real_t, tinyobj::real_t, tinyobj::real_t) {
  feed_of(data).builder().texcoord(feed_of(data).after_keyword(2));
}
void on_face(void* data, tinyobj::index_t*, int) { feed_of(data).builder().face(feed_of(data).after_keyword(1)); }
void on_material(void* data, const char*, int) {
  feed_of(data).builder().name(ObjBuilder::NameKind::material, feed_of(data).after_keyword(6));
}
void on_group(void* data, const char**, int) {
  feed_of(data).builder().name(ObjBuilder::NameKind::group, feed_of(data).after_keyword(1));
}
void on_object(void* data, const char*) {
  feed_of(data).builder().name(ObjBuilder::NameKind::object, feed_of(data).after_keyword(1));
}

}  // namespace

Result<MeshFile> read_obj(std::string_view bytes, const std::filesystem::path& path) {
  if (const void* nul = bytes.empty() ? nullptr : std::memchr(bytes.data(), 0, bytes.size())) {
    return nul_byte_failure(static_cast<std::uint64_t>(static_cast<const char*>(nul) - bytes.data()));
  }
  TextLines lines(bytes, true);
  ObjBuilder builder(lines, path);
  ObjFeed feed(lines, builder);
  std::istream stream(&feed);
  stream.exceptions(std::ios_base::badbit);  // else the stream would swallow what is thrown while a line is read
  tinyobj::callback_t callbacks;
  callbacks.vertex_cb = on_vertex;
  callbacks.normal_cb = on_normal;
  callbacks.texcoord_cb = on_texcoord;
  callbacks.index_cb = on_face;
  callbacks.usemtl_cb = on_material;
  callbacks.group_cb = on_group;
  callbacks.object_cb = on_object;
  // Without a material reader the library opens no file. Its verdict is not asked for: every line is checked here.
  tinyobj::LoadObjWithCallback(stream, callbacks, &feed, nullptr, nullptr, nullptr);
  return builder.finish();
}

}  // namespace ryosen
