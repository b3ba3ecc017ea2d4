// What closed lists of kinds have in common: each kind has a name and fields, and most are prepared
// to a form, whose list follows from theirs.
#pragma once

#include <concepts>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/input/fields.h"

namespace tia {

/// A kind of a tagged union: the name that `type` has in JSON, and its fields.
template <class Kind>
concept IsKind = Described<Kind> && requires {
  { Kind::type } -> std::convertible_to<std::string_view>;
};

/// A kind of which prepare() makes a form: its numbers, made ready for tracing.
template <class Kind>
concept IsPrepared = requires(const Kind& kind) {
  prepare(kind);
};
template <IsPrepared Kind>
using FormOf = std::remove_cvref_t<decltype(prepare(std::declval<const Kind&>()))>;

namespace detail {

template <class... Forms>
struct FormsSoFar {
  using Variant = std::variant<Forms...>;
};
// Appends what each kind prepares to, once.
template <class Done, class... Kinds>
struct FormsWith : Done {};
template <class... Forms, class Kind, class... Kinds>
struct FormsWith<FormsSoFar<Forms...>, Kind, Kinds...> : FormsWith<FormsSoFar<Forms...>, Kinds...> {
};
template <class... Forms, IsPrepared Kind, class... Kinds>
struct FormsWith<FormsSoFar<Forms...>, Kind, Kinds...>
    : std::conditional_t<(std::same_as<FormOf<Kind>, Forms> || ...),
                         FormsWith<FormsSoFar<Forms...>, Kinds...>,
                         FormsWith<FormsSoFar<Forms..., FormOf<Kind>>, Kinds...>> {};
template <class List>
struct FormsOfList;
template <class... Kinds>
struct FormsOfList<std::variant<Kinds...>> {
  using Variant = typename FormsWith<FormsSoFar<>, Kinds...>::Variant;
};

}  // namespace detail

/// FormsOf: the variant of what a list's kinds prepare to, several of them perhaps to the same.
template <class List>
using FormsOf = typename detail::FormsOfList<List>::Variant;

}  // namespace tia
