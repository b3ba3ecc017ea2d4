// URLs that are a permission: GET of one path and query, until a time, without a key.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tia::server {

/// UrlSignature: what stands at the end of a signed URL, `exp=UNIX&kid=K&sig=S`.
struct UrlSignature {
  std::string text;  ///< all before `&sig=`, path and query, which S is the code of
  std::string kid, code;
  std::int64_t expires = 0;  ///< seconds since 1970
  bool is_in_form = false;   ///< all three stand once, last and in this order; else all is unset
};

/// Takes the signature off path and query, so that what is left asks for what the URL is about; of
/// one that is not in form all parameters of these three names, for the right ones could be among
/// them, which no log should know. Returns: none where there is no `sig`; then the target stays.
std::optional<UrlSignature> take_signature(std::string& target);

/// Whether the code is that of the text.
bool is_signed_by(const UrlSignature& signature, std::string_view key);

/// The path and query with a signature at its end. Domain: without one, and without a fragment.
std::string signed_target(std::string target, std::string_view kid, std::string_view key,
                          std::int64_t expires);

}  // namespace tia::server
