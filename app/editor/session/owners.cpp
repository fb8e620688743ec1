#include "app/editor/session/owners.h"

#include "app/editor/input/input.h"
#include "app/editor/session/session.h"

namespace ryosen {

namespace {

template <class Owner>
struct Place;

}  // namespace

template <class Owner>
Owner& owner_of(Session& session) {
  return Place<Owner>::in(session);
}

template <class Owner>
const Owner& owner_of(const Session& session) {
  return Place<Owner>::in(session);
}

#define RYOSEN_PLACE(Owner, place)                   \
  namespace {                                        \
  template <>                                        \
  struct Place<Owner> {                              \
    static auto& in(auto& session) { return place; } \
  };                                                 \
  }
#define RYOSEN_OWNER(Owner, place)           \
  RYOSEN_PLACE(Owner, place)                 \
  template Owner& owner_of<Owner>(Session&); \
  template const Owner& owner_of<Owner>(const Session&);

RYOSEN_OWNER(Session, session)
RYOSEN_OWNER(Document, session.document())
RYOSEN_OWNER(Findings, session.findings())
RYOSEN_OWNER(ViewState, session.view)
RYOSEN_OWNER(Framing, session.framing)
RYOSEN_OWNER(Selecting, session.selecting)
RYOSEN_OWNER(Pointing, session.pointing)
RYOSEN_OWNER(Gesturing, session.gesturing)
RYOSEN_OWNER(Shown, session.shown)
RYOSEN_OWNER(Preferences, session.preferences)
RYOSEN_OWNER(Layout, session.layout)
RYOSEN_OWNER(Frontend, session.frontend)
RYOSEN_OWNER(RunFiles, session.files)
RYOSEN_OWNER(RepairTrials, session.trials)

// Nobody but an operator changes a mesh, and events go nowhere in a constant session.
RYOSEN_PLACE(Mesh, session.mesh())
template const Mesh& owner_of<Mesh>(const Session&);
RYOSEN_PLACE(Input, session.input())
template Input& owner_of<Input>(Session&);

}  // namespace ryosen
