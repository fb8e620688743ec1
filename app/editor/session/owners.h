// Gives a function of a table those parts of a session, its owners, that it names as its first parameters.
#pragma once

#include <functional>
#include <tuple>
#include <type_traits>
#include <utility>

namespace ryosen {

class Document;
class Findings;
class Framing;
class Gesturing;
class Input;
class Mesh;
class Pointing;
class RepairTrials;
class RunFiles;
class Selecting;
class Session;
class Shown;
struct Frontend;
struct Layout;
struct Preferences;
struct ViewState;

// A part of a session, or the session itself. owners.cpp has a line for each.
template <class Owner>
Owner& owner_of(Session& session);
template <class Owner>
const Owner& owner_of(const Session& session);

// A function of a row of a table: it takes, in front of its other arguments, the owners that it works on in place of
// the session:
//   OnOwners<bool(const Session&, int)> row = [](const ViewState& view, const Document& document, int n) { ... };
template <class Call>
class OnOwners;

template <class Result, class AnySession, class... Arguments>
class OnOwners<Result(AnySession&, Arguments...)> {
 public:
  OnOwners() = default;
  template <class Function>
  requires(!std::is_same_v<std::remove_cvref_t<Function>, OnOwners>) OnOwners(Function function)
      : call_(with_owners(function, std::function(function))) {}  // NOLINT: rows name functions

  explicit operator bool() const { return static_cast<bool>(call_); }
  Result operator()(AnySession& session, Arguments... arguments) const {
    return call_(session, std::forward<Arguments>(arguments)...);
  }

 private:
  using Stored = std::function<Result(AnySession&, Arguments...)>;

  template <class Function, class... Parameters>
  static Stored with_owners(const Function& function, const std::function<Result(Parameters...)>&) {
    static_assert(sizeof...(Parameters) >= sizeof...(Arguments), "owners come first, then the other arguments");
    constexpr std::size_t owners = sizeof...(Parameters) - sizeof...(Arguments);
    return with(function, std::make_index_sequence<owners>(), std::type_identity<std::tuple<Parameters...>>());
  }
  template <class Function, std::size_t... at, class Parameters>
  static Stored with(const Function& function, std::index_sequence<at...>, std::type_identity<Parameters>) {
    return [function](AnySession& session, Arguments... arguments) -> Result {
      return function(owner_for<std::tuple_element_t<at, Parameters>>(session)...,
                      std::forward<Arguments>(arguments)...);
    };
  }

  template <class Parameter>
  static Parameter owner_for(AnySession& session) {
    using Owner = std::remove_cvref_t<Parameter>;
    if constexpr (std::is_const_v<std::remove_reference_t<Parameter>>)
      return owner_of<Owner>(std::as_const(session));
    else
      return owner_of<Owner>(session);
  }

  Stored call_;
};

}  // namespace ryosen
