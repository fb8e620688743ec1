#include "app/editor/session/owners.h"

#include "app/editor/input/input.h"
#include "app/editor/session/session.h"

namespace ryosen {

namespace {

// Finds an owner of this type in a session, constant in a constant one.
template <class Owner, class AnySession>
auto& find_owner(AnySession& session) {
  if constexpr (std::is_same_v<Owner, Session>) return session;
  else if constexpr (std::is_same_v<Owner, Document>) return session.document();
  else if constexpr (std::is_same_v<Owner, Mesh>) return session.mesh();
  else if constexpr (std::is_same_v<Owner, Findings>) return session.findings();
  else if constexpr (std::is_same_v<Owner, Input>) return session.input();
  else if constexpr (std::is_same_v<Owner, ViewState>) return session.view;
  else if constexpr (std::is_same_v<Owner, Framing>) return session.framing;
  else if constexpr (std::is_same_v<Owner, Selecting>) return session.selecting;
  else if constexpr (std::is_same_v<Owner, Pointing>) return session.pointing;
  else if constexpr (std::is_same_v<Owner, Gesturing>) return session.gesturing;
  else if constexpr (std::is_same_v<Owner, Shown>) return session.shown;
  else if constexpr (std::is_same_v<Owner, Preferences>) return session.preferences;
  else if constexpr (std::is_same_v<Owner, Layout>) return session.layout;
  else if constexpr (std::is_same_v<Owner, Frontend>) return session.frontend;
  else if constexpr (std::is_same_v<Owner, RunFiles>) return session.files;
  else return session.trials;
}

}  // namespace

template <class Owner>
Owner& owner_of(Session& session) {
  return find_owner<Owner>(session);
}

template <class Owner>
const Owner& owner_of(const Session& session) {
  return find_owner<Owner>(session);
}

template const Mesh& owner_of<Mesh>(const Session&);
template Input& owner_of<Input>(Session&);
template Session& owner_of<Session>(Session&);
template const Session& owner_of<Session>(const Session&);
template Document& owner_of<Document>(Session&);
template const Document& owner_of<Document>(const Session&);
template Findings& owner_of<Findings>(Session&);
template const Findings& owner_of<Findings>(const Session&);
template ViewState& owner_of<ViewState>(Session&);
template const ViewState& owner_of<ViewState>(const Session&);
template Framing& owner_of<Framing>(Session&);
template const Framing& owner_of<Framing>(const Session&);
template Selecting& owner_of<Selecting>(Session&);
template const Selecting& owner_of<Selecting>(const Session&);
template Pointing& owner_of<Pointing>(Session&);
template const Pointing& owner_of<Pointing>(const Session&);
template Gesturing& owner_of<Gesturing>(Session&);
template const Gesturing& owner_of<Gesturing>(const Session&);
template Shown& owner_of<Shown>(Session&);
template const Shown& owner_of<Shown>(const Session&);
template Preferences& owner_of<Preferences>(Session&);
template const Preferences& owner_of<Preferences>(const Session&);
template Layout& owner_of<Layout>(Session&);
template const Layout& owner_of<Layout>(const Session&);
template Frontend& owner_of<Frontend>(Session&);
template const Frontend& owner_of<Frontend>(const Session&);
template RunFiles& owner_of<RunFiles>(Session&);
template const RunFiles& owner_of<RunFiles>(const Session&);
template RepairTrials& owner_of<RepairTrials>(Session&);
template const RepairTrials& owner_of<RepairTrials>(const Session&);

}  // namespace ryosen
