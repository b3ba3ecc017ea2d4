// The keys that there are, and what URLs are signed with: two files, read at the start and again at
// SIGHUP, in between never changed.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "server/access/key_entry.h"

namespace tia::server {

struct Config;

/// SigningKey: a line `K HEX KEYID` of TIA_SIGN_FILE.
struct SigningKey {
  std::string name;    ///< K, which URLs tell in `kid`
  std::string secret;  ///< the bytes of HEX
  std::string owner;   ///< KEYID, the key whose rights hold
};

/// Errors: InputError, every fault by its pointer, such as /3/may/0.
std::vector<KeyEntry> read_keys(std::string_view json);

/// Lines of three words; others may be empty or begin with #. Errors: InputError with the line,
/// which repeats no secret.
std::vector<SigningKey> read_signing_keys(std::string_view text);

/// Those of the file, of which there must be one.
/// Errors: std::invalid_argument naming the option, the file and each fault in it.
std::vector<SigningKey> signing_keys_of(const Config& config);

class KeyRing {
 public:
  KeyRing() = default;  ///< no file: all may do all but what asks for `admin`
  /// Errors: as signing_keys_of; also an owner of no entry, and a file of the latter without the
  /// former.
  explicit KeyRing(const Config& config);

  bool is_open() const { return !has_file_; }
  /// The entry of that id; or null.
  const KeyEntry* find(std::string_view id) const;
  const KeyEntry* anonymous() const { return find(KeyEntry::anonymous); }
  const SigningKey* signing_key(std::string_view name) const;

 private:
  bool has_file_ = false;
  std::map<std::string, KeyEntry, std::less<>> keys_;
  std::map<std::string, SigningKey, std::less<>> signing_keys_;
};

}  // namespace tia::server
