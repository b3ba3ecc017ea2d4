// Walks the fields of described types without knowing the types: what reads, writes or makes a
// schema is compiled once and not for each of a hundred types. What is made for each is one
// function that names its fields, and for each member's type its codec behind pointers.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/input/value_codecs.h"

namespace tia {

/// Checks that concern several fields: a described type may have
/// `void check(const Place&, Faults&)`, called when all that it holds is right. So may a kind of a
/// tagged union. One that is not const may keep what follows from the fields.
template <class T>
concept Checked = requires(T& t, const Place& at, Faults& faults) {
  t.check(at, faults);
};

/// Checks of what one part says of another: a described type may have
/// `void check_links(const Place&, Faults&) const`, called whatever else is wrong. What could not
/// be read is as it is by default, and has its fault.
template <class T>
concept Linked = requires(const T& t, const Place& at, Faults& faults) {
  t.check_links(at, faults);
};

template <class T>
class Boxed;

namespace detail {

// A list may hold a kind that is larger than most in a Boxed: what it is stays the kind.
template <class Held>
struct KindIn {
  using Kind = Held;
};
template <class T>
struct KindIn<Boxed<T>> {
  using Kind = T;
};
template <class Held>
using KindOf = typename KindIn<Held>::Kind;
template <class Held>
auto& unboxed(Held& held) {
  if constexpr (std::is_same_v<KindOf<std::remove_const_t<Held>>, std::remove_const_t<Held>>)
    return held;
  else return *held;
}

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// Calls f(std::in_place_type<Kind>) for the i-th kind of the list, as it is held.
template <class... Kinds, class F>
void with_kind(const std::variant<Kinds...>*, std::size_t i, F f) {
  std::size_t at = 0;
  ((at++ == i ? f(std::in_place_type<Kinds>) : void()), ...);
}

// ---- types behind pointers --------------------------------------------------------------------

/// MemberType: the codec of a field's type.
struct MemberType {
  void (*read)(const Value&, const Place&, const Spec&, Faults&, void* out);
  Value (*write)(const void* value);
  Value (*schema)(const Spec&, Definitions&);
  std::string (*allowed)(const Spec&);
  bool (*equal)(const void*, const void*);
  bool optional;
};

class FieldSink;
using CheckOf = void (*)(void* owner, const Place&, Faults&);

/// OwnerType: a described type: its fields, and its checks, null where it has none.
struct OwnerType {
  void (*walk)(FieldSink& to, void* owner);  ///< of null: those of a default-constructed one
  CheckOf check, check_links;
};

/// KindType: an alternative of a tagged union.
struct KindType {
  std::string_view name;
  const OwnerType* fields;
  void* (*emplace)(void* variant);  ///< makes it what the variant holds
  void* (*held)(void* variant);     ///< Domain: the variant holds it
};
struct UnionType {
  std::span<const KindType> kinds;
  std::size_t (*index)(const void* variant);
};

/// FieldSink: takes the fields of one owner after another. A field's `standard` is what a
/// default-constructed owner holds; null unless the sink asks for it.
class FieldSink {
 public:
  explicit FieldSink(bool asks_standard) : asks_standard_(asks_standard) {}
  FieldSink(const FieldSink&) = delete;
  FieldSink& operator=(const FieldSink&) = delete;
  bool asks_standard() const { return asks_standard_; }
  virtual void field(std::string_view name, const Spec& spec, const MemberType& type, void* value,
                     const void* standard) = 0;
  virtual void one_of(const Spec& spec, const UnionType& type, void* variant) = 0;

 protected:
  ~FieldSink() = default;

 private:
  bool asks_standard_;
};

// ---- made of each type ------------------------------------------------------------------------

template <class Member>
struct MemberBehind {
  static void read(const Value& value, const Place& at, const Spec& spec, Faults& faults,
                   void* out) {
    read_value(value, at, spec, faults, *static_cast<Member*>(out));
  }
  static Value write(const void* value) { return write_value(*static_cast<const Member*>(value)); }
  static Value schema(const Spec& spec, Definitions& named) {
    return schema_of<Member>(spec, named);
  }
  static std::string allowed(const Spec& spec) { return Codec<Member>::allowed(spec); }
  // Groups of requests, which are only read, cannot be compared.
  static bool equal(const void* a, const void* b) {
    if constexpr (requires(const Member& each) { each == each; })
      return *static_cast<const Member*>(a) == *static_cast<const Member*>(b);
    else return false;
  }
  static constexpr MemberType type{read, write, schema, allowed, equal, is_optional<Member>};
};

template <class Variant>
struct UnionBehind;

/// FieldNamer: the visitor of an owner that hands its fields to a sink.
template <class Owner>
struct FieldNamer {
  FieldSink& to;
  Owner& owner;
  const Owner* standard;

  template <class Base, class Member>
  void operator()(std::string_view name, Member Base::*member, const Spec& spec) const {
    to.field(name, spec, MemberBehind<Member>::type, &(owner.*member),
             standard != nullptr ? &(standard->*member) : nullptr);
  }
  /// The key `type` picks the alternative, whose fields stand in the same object.
  template <class Base, class Variant>
  void one_of(Variant Base::*member, const Spec& spec) const {
    to.one_of(spec, UnionBehind<Variant>::type, &(owner.*member));
  }
};

template <class Owner>
struct OwnerBehind {
  static void walk(FieldSink& to, void* owner) {
    std::optional<Owner> standard;
    if (owner == nullptr || to.asks_standard()) standard.emplace();
    Owner& of = owner != nullptr ? *static_cast<Owner*>(owner) : *standard;
    Owner::fields(FieldNamer<Owner>{to, of, standard ? &*standard : nullptr});
  }
  static constexpr CheckOf check() {
    if constexpr (!Checked<Owner>) return nullptr;
    else
      return [](void* owner, const Place& at, Faults& faults) {
        static_cast<Owner*>(owner)->check(at, faults);
      };
  }
  static constexpr CheckOf check_links() {
    if constexpr (!Linked<Owner>) return nullptr;
    else
      return [](void* owner, const Place& at, Faults& faults) {
        static_cast<const Owner*>(owner)->check_links(at, faults);
      };
  }
};
template <class Owner>
inline constexpr OwnerType owner_type{OwnerBehind<Owner>::walk, OwnerBehind<Owner>::check(),
                                      OwnerBehind<Owner>::check_links()};

template <class... Kinds>
struct UnionBehind<std::variant<Kinds...>> {
  using Variant = std::variant<Kinds...>;
  template <class Held>
  static void* emplace(void* variant) {
    return &unboxed(static_cast<Variant*>(variant)->template emplace<Held>());
  }
  template <class Held>
  static void* held(void* variant) {
    return &unboxed(*std::get_if<Held>(static_cast<Variant*>(variant)));
  }
  static std::size_t index(const void* variant) {
    return static_cast<const Variant*>(variant)->index();
  }
  static constexpr std::array<KindType, sizeof...(Kinds)> kinds{
      KindType{KindOf<Kinds>::type, &owner_type<KindOf<Kinds>>, emplace<Kinds>, held<Kinds>}...};
  static constexpr UnionType type{kinds, index};
};

}  // namespace detail
}  // namespace tia
