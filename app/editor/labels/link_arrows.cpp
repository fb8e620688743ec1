#include "app/editor/labels/link_arrows.h"

#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/mesh/rings.h"

namespace ryosen {

namespace {

constexpr std::size_t most_of_one = 200;

Text link_text(const char* en, const char* ja, const std::string& name) {
  const std::string behind = name.empty() ? "" : " " + name;
  return {en + behind, ja + behind};
}

// The arrows of one selected element.
class LinksOf {
 public:
  LinksOf(const Mesh& mesh, std::span<const glm::dvec3> places, ArrowMaker& make, std::vector<LinkArrow>& arrows)
      : m_(mesh), places_(places), make_(make), arrows_(arrows) {}

  void add(const Element& e) {
    switch (e.kind) {
      case Element::Kind::vertex:
        return add(e.vertex());
      case Element::Kind::halfedge:
        return add(e.halfedge());
      case Element::Kind::edge:
        return add(e.edge());
      case Element::Kind::face:
        return add(e.face());
    }
  }

 private:
  const glm::dvec3& place(Vertex v) const { return places_[v.index]; }

  void arrow(Halfedge h, LinkRole role, const char* en, const char* ja) {
    if (auto made = make_.of(h, role, link_text(en, ja, name_of(m_, h)))) arrows_.push_back(std::move(*made));
  }
  void arrow_to(const glm::dvec3& from, const glm::dvec3& to, LinkRole role, Face on, Text label) {
    arrows_.push_back({from, to, role, {}, on, {}, false, std::move(label)});
  }
  void mark(Vertex v, const char* en, const char* ja) {
    arrow_to(place(v), place(v), LinkRole::vertex, {}, link_text(en, ja, slot_name(v)));
  }

  void add(Halfedge h) {
    const Halfedge n = m_.next(h), p = m_.prev(h), t = twin(h);
    const bool turns = n == p, back = n == t;
    arrow(h, LinkRole::itself, "halfedge", "半稜線");
    arrow(t, LinkRole::twin, back ? "twin, next" : "twin", back ? "対・次" : "対");
    // What comes first is labelled first: there is no other place for the face's label.
    const Face f = m_.face(h);
    if (f) {
      const glm::dvec3 middle = 0.5 * (place(m_.from(h)) + place(m_.to(h)));
      arrow_to(middle, middle_of(m_, f), LinkRole::face, f, link_text("face", "面", slot_name(f)));
    }
    if (!back) arrow(n, LinkRole::next, turns ? "next, prev" : "next", turns ? "次・前" : "次");
    if (!turns && p != t) arrow(p, LinkRole::prev, "prev", "前");
    mark(m_.from(h), "from", "始点");
    // Text 003's v_opps: the corner of a triangle that the halfedge does not touch.
    if (f && m_.next(n) == p && !turns) mark(m_.to(n), "opposite", "対角頂点");
  }

  void add(Edge e) {
    const Halfedge h = halfedge(e), t = twin(h);
    mark(m_.from(h), "start", "始点");
    mark(m_.to(h), "end", "終点");
    const glm::dvec3 middle = 0.5 * (place(m_.from(h)) + place(m_.to(h)));
    struct Side {
      Halfedge h;
      const char *en, *ja, *next_en, *next_ja, *prev_en, *prev_ja;
    };
    for (const Side& side : {Side{h, "left", "左", "left next", "左の次", "left prev", "左の前"},
                             Side{t, "right", "右", "right next", "右の次", "right prev", "右の前"}}) {
      const Face f = m_.face(side.h);
      if (!f) continue;
      arrow_to(middle, middle_of(m_, f), LinkRole::face, f, link_text(side.en, side.ja, slot_name(f)));
      wing(m_.next(side.h), side.next_en, side.next_ja);
      wing(m_.prev(side.h), side.prev_en, side.prev_ja);
    }
  }
  void wing(Halfedge h, const char* en, const char* ja) {
    if (auto made = make_.of(h, LinkRole::wing, link_text(en, ja, name_of(m_, edge(h)))))
      arrows_.push_back(std::move(*made));
  }

  void add(Vertex v) {
    mark(v, "vertex", "頂点");
    if (m_.is_isolated(v)) return;
    std::size_t n = 1;
    Halfedge h = m_.halfedge(v);
    do {
      const std::string number = std::to_string(n);
      if (n == 1)
        arrow(h, LinkRole::itself, "1 halfedge", "1 半稜線");
      else
        arrow(h, LinkRole::around, number.c_str(), number.c_str());
      h = m_.counter_clockwise(h);
    } while (h != m_.halfedge(v) && ++n <= most_of_one);
  }

  void add(Face f) {
    const glm::dvec3 middle = middle_of(m_, f);
    arrow_to(middle, middle + make_.size(f) * make_.normal(f), LinkRole::normal, {}, link_text("normal", "法線", ""));
    for_each_loop(m_, f, [&](Halfedge start) {
      const bool is_outer = start == m_.halfedge(f);
      add_loop(start, is_outer ? LinkRole::around : LinkRole::ring, is_outer);
    });
  }
  void add_loop(Halfedge start, LinkRole role, bool is_outer) {
    std::size_t n = 1;
    for (const Halfedge h : loop(m_, start)) {
      const std::string number = std::to_string(n);
      if (h == start)
        arrow(h, is_outer ? LinkRole::itself : role, is_outer ? "1 halfedge" : "ring",
              is_outer ? "1 半稜線" : "内側のループ");
      else
        arrow(h, role, number.c_str(), number.c_str());
      if (++n > most_of_one) return;
    }
  }

  const Mesh& m_;
  std::span<const glm::dvec3> places_;
  ArrowMaker& make_;
  std::vector<LinkArrow>& arrows_;
};

}  // namespace

void add_links_of(const Mesh& mesh, std::span<const glm::dvec3> places, ArrowMaker& make, const Element& e,
                  std::vector<LinkArrow>& arrows) {
  LinksOf(mesh, places, make, arrows).add(e);
}

}  // namespace ryosen
