#include "server/stores/objects_parts.h"

#include <openssl/evp.h>

#include <algorithm>
#include <memory>
#include <new>
#include <type_traits>

#include "core/parallel/stopped.h"

namespace tia::server {
namespace {

template <class T>
concept Number = std::is_arithmetic_v<T> || std::is_enum_v<T>;
template <class T>
concept PlacementStep = requires(const T& step) {
  T::key;
  step.by;
};

/// Feeds values to SHA-256. Whatever has no fixed length says first how long it is, or which of its
/// kinds, so that different values never feed the same bytes.
class Digester {
 public:
  /// Takes down the digest of each mesh.
  explicit Digester(MeshDigests& meshes) : meshes_(meshes), context_(EVP_MD_CTX_new()) {
    require(context_ ? EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) : 0);
  }
  Digested done() {
    flush();
    Digest digest;
    require(EVP_DigestFinal_ex(context_.get(), digest.data(), nullptr));
    return {digest, bytes_};
  }

  template <Number T>
  void add(T value) {
    if (used_ + sizeof value > buffer_.size()) flush();
    std::memcpy(buffer_.data() + used_, &value, sizeof value);
    used_ += sizeof value;
  }
  void add(const Vec3d& v) { add(v.x), add(v.y), add(v.z); }
  void add(const Color& c) { add(c.r), add(c.g), add(c.b); }
  void add(const MatrixRows& rows) { add(rows.row); }
  void add(const AlgebraicTerm& term) { add(term.powers), add(term.coefficient); }
  void add(const VoxelList& occupied) {
    add(occupied.width);
    add(occupied.numbers.size());
    add(occupied.numbers.data(), occupied.numbers.size() * sizeof(occupied.numbers[0]));
  }
  void add(const TransformSteps& placement) { add(placement.steps); }
  void add(const PictureFile& file) { add(file.base64); }  // what its pixels come from
  void add(const std::string& text) {
    add(text.size());
    add(text.data(), text.size());
  }
  template <class T>
  void add(const Numbers<T>& numbers) {
    const auto& values = numbers.values.get();
    add(values.size());
    add(values.data(), values.size() * sizeof(values[0]));
  }
  template <class T>
  void add(const std::vector<T>& list) {
    add(list.size());
    for (const T& each : list) {
      if constexpr (!std::is_trivially_copyable_v<T>) give_way();
      add(each);
    }
  }
  template <class T>
  void add(const Boxed<T>& boxed) {
    add(*boxed);
  }
  template <class T>
  void add(const SharedList<T>& list) {
    add(list.get());
  }
  template <class T, std::size_t n>
  void add(const std::array<T, n>& list) {
    for (const T& each : list) add(each);
  }
  template <class T>
  void add(const std::map<std::string, T>& map) {
    add(map.size());
    for (const auto& [name, value] : map) add(name), add(value);
  }
  template <class T>
  void add(const OptionalBox<T>& value) {
    add(static_cast<bool>(value));
    if (value) add(*value);
  }
  template <class T>
  void add(const std::optional<T>& value) {
    add(value.has_value());
    if (value) add(*value);
  }
  template <class... T>
  void add(const std::variant<T...>& value) {
    add(static_cast<std::uint8_t>(value.index()));
    std::visit([this](const auto& is) { this->add(is); }, value);
  }
  template <PlacementStep Step>
  void add(const Step& step) {
    add(step.by);
  }
  void add(const Mesh& mesh) {
    Digester own(meshes_);
    Mesh::fields(Fields<Mesh>{own, mesh});
    for (const auto* list : {&mesh.more_uvs, &mesh.tangents})  // which only models' have
      if (!list->values.empty()) own.add(std::uint8_t{list == &mesh.tangents}), own.add(*list);
    const Digested name = own.done();
    meshes_.emplace(&mesh, name.digest);
    add(name.digest);
    bytes_ += name.bytes;
  }
  void add(const Walls& walls) {
    Walls::fields(Fields<Walls>{*this, walls});
    bytes_ += children_in(walls).size() * sizeof(Object);  // more than what is said of them
  }
  template <Described T>
  void add(const T& value) {
    T::fields(Fields<T>{*this, value});
  }

 private:
  /// Visitor: a described object's fields.
  template <class Owner>
  struct Fields {
    Digester& to;
    const Owner& of;
    template <class Base, class Member>
    void operator()(std::string_view, Member Base::*member, const Spec&) {
      to.add(of.*member);
    }
    template <class Base, class Variant>
    void one_of(Variant Base::*member, const Spec&) {
      to.add(of.*member);
    }
  };

  // It fails for want of memory only.
  static void require(int done) {
    if (done != 1) throw std::bad_alloc();
  }
  void add(const void* bytes, std::size_t size) {
    flush();
    require(EVP_DigestUpdate(context_.get(), bytes, size));
    bytes_ += size;
  }
  void flush() {
    require(EVP_DigestUpdate(context_.get(), buffer_.data(), used_));
    bytes_ += used_;
    used_ = 0;
  }

  struct Free {
    void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
  };
  MeshDigests& meshes_;
  std::unique_ptr<EVP_MD_CTX, Free> context_;
  std::array<unsigned char, 1024> buffer_;  // calls for a number each would cost more than SHA-256
  std::size_t used_ = 0, bytes_ = 0;
};

Digested digested_part(const std::vector<Object>& objects, std::size_t part, MeshDigests& meshes) {
  const std::size_t first = part * ObjectsParts::objects_each;
  const std::size_t end = std::min(first + ObjectsParts::objects_each, objects.size());
  Digester digester(meshes);
  for (std::size_t i = first; i < end; ++i) {
    give_way();
    digester.add(objects[i]);
  }
  return digester.done();
}

void digest_again(const Scene& scene, const std::vector<std::size_t>& moved, ObjectsParts& parts) {
  MeshDigests meshes;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const std::size_t part = moved[i] / ObjectsParts::objects_each;
    if (i == 0 || part != moved[i - 1] / ObjectsParts::objects_each)
      parts.digests[part] = digested_part(scene.objects, part, meshes);
  }
}

}  // namespace

Digest digest_of_mesh(const Mesh& mesh) {
  MeshDigests alone;
  Digester(alone).add(mesh);
  return alone.at(&mesh);
}

// The parts' own digests are no bytes of the objects.
Digested digest_by_parts(const Scene& scene, const std::vector<std::size_t>& moved,
                         ObjectsParts& parts) {
  const std::size_t count = scene.objects.size(), each = ObjectsParts::objects_each;
  if (parts.digests.empty())
    for (std::size_t i = 0; i * each < count; ++i)
      parts.digests.push_back(digested_part(scene.objects, i, parts.meshes));
  else digest_again(scene, moved, parts);
  MeshDigests none;
  Digester digester(none);
  digester.add(count);
  std::size_t bytes = 0;
  for (const Digested& part : parts.digests) {
    digester.add(part.digest);
    bytes += part.bytes - part.digest.size();
  }
  digester.add(scene.materials);
  digester.add(scene.ambient_light);
  const Digested all = digester.done();
  return {all.digest, all.bytes + bytes};
}

}  // namespace tia::server
