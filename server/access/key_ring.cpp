#include "server/access/key_ring.h"

#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

#include "core/input/json.h"
#include "server/operation/config.h"

namespace tia::server {
namespace {

std::string text_of_file(const std::string& option, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw std::invalid_argument("option " + option + ": cannot read " + path);
  return text;
}

// What `read` makes of the file's text.
template <class Read>
auto read_file_of(const std::string& option, const std::string& path, const Read& read) {
  try {
    return read(text_of_file(option, path));
  } catch (const InputError& error) {
    throw std::invalid_argument("option " + option + ", " + path + ": " + error.what());
  }
}

void check_ids(const std::vector<KeyEntry>& keys, Faults& faults) {
  std::set<std::string_view> seen;
  const Place root;
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (!keys[i].id.text.empty() && !seen.insert(keys[i].id.text).second)
      faults.add({FaultKind::conflict, root.at(i).at("id").pointer(), Value(keys[i].id.text),
                  "an id that no other key has"});
}

int hex_value(char c) {
  constexpr std::string_view digits = "0123456789abcdef";
  const auto at = digits.find(c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c);
  return at == digits.npos ? -1 : static_cast<int>(at);
}

// The bytes that digits stand for, or "".
std::string bytes_of_hex(std::string_view digits) {
  std::string bytes;
  if (digits.size() % 2 != 0) return bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    const int high = hex_value(digits[i]), low = hex_value(digits[i + 1]);
    if (high < 0 || low < 0) return "";
    bytes += static_cast<char>(high * 16 + low);
  }
  return bytes;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  constexpr std::string_view blanks = " \t\r";
  for (auto at = line.find_first_not_of(blanks); at != line.npos;) {
    const auto end = line.find_first_of(blanks, at);
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(blanks, end == line.npos ? line.size() : end);
  }
  return words;
}

// Errors: InputError of that line.
SigningKey signing_key_in(const std::vector<std::string_view>& words, std::size_t line) {
  const auto refuse = [&](const char* what, const std::string& allowed) {
    throw InputError(Fault{FaultKind::out_of_range, "", Value(what), allowed, "", {}, line});
  };
  if (words.size() != 3) refuse("another number of words", "K HEX KEYID");
  const auto name = KeyId::parse(std::string(words[0])),
             owner = KeyId::parse(std::string(words[2]));
  std::string secret = bytes_of_hex(words[1]);
  if (!name) refuse("another K", std::string("as K ") + KeyId::form);
  if (secret.size() < 32 || secret.size() > 128)
    refuse("another HEX", "as HEX 64 to 256 hexadecimal digits, two a byte");
  if (!owner) refuse("another KEYID", "as KEYID the id of a key");
  return {name->text, std::move(secret), owner->text};
}

}  // namespace

std::vector<KeyEntry> read_keys(std::string_view json) {
  constexpr JsonLimits limits{.depth = 4, .values = 1'000'000, .option = ""};
  const Value value = parse_json(json, limits);
  std::vector<KeyEntry> keys;
  Faults faults;
  read_value(value, Place{}, Spec{}, faults, keys);
  if (faults.empty()) check_ids(keys, faults);
  faults.raise();
  return keys;
}

std::vector<SigningKey> read_signing_keys(std::string_view text) {
  std::vector<SigningKey> keys;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const auto end = text.find('\n');
    const auto words = words_of(text.substr(0, end));
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
    if (words.empty() || words[0].starts_with('#')) continue;
    keys.push_back(signing_key_in(words, line));
    for (std::size_t i = 0; i + 1 < keys.size(); ++i)
      if (keys[i].name == keys.back().name)
        throw InputError(Fault{FaultKind::conflict,
                               "",
                               Value(keys[i].name),
                               "a K that no other line has",
                               "",
                               {},
                               line});
  }
  return keys;
}

std::vector<SigningKey> signing_keys_of(const Config& config) {
  if (config.sign_file.empty())
    throw std::invalid_argument("option TIA_SIGN_FILE: got none, allowed: a file of K HEX KEYID");
  auto keys = read_file_of("TIA_SIGN_FILE", config.sign_file, read_signing_keys);
  if (keys.empty())
    throw std::invalid_argument("option TIA_SIGN_FILE, " + config.sign_file +
                                ": got no line, allowed: lines K HEX KEYID");
  return keys;
}

KeyRing::KeyRing(const Config& config) : has_file_(!config.keys_file.empty()) {
  if (has_file_)
    for (KeyEntry& entry : read_file_of("TIA_KEYS_FILE", config.keys_file, read_keys))
      keys_.emplace(entry.id.text, std::move(entry));
  if (config.sign_file.empty()) return;
  if (!has_file_)
    throw std::invalid_argument(
        "option TIA_SIGN_FILE: got " + config.sign_file +
        ", allowed: none without TIA_KEYS_FILE, which says what its keys may do");
  for (SigningKey& each : signing_keys_of(config)) {
    if (find(each.owner) == nullptr)
      throw std::invalid_argument("option TIA_SIGN_FILE, " + config.sign_file + ": got " +
                                  each.owner + " as KEYID of " + each.name +
                                  ", allowed: an id of TIA_KEYS_FILE");
    signing_keys_.emplace(each.name, std::move(each));
  }
}

const KeyEntry* KeyRing::find(std::string_view id) const {
  const auto found = keys_.find(id);
  return found == keys_.end() ? nullptr : &found->second;
}

const SigningKey* KeyRing::signing_key(std::string_view name) const {
  const auto found = signing_keys_.find(name);
  return found == signing_keys_.end() ? nullptr : &found->second;
}

}  // namespace tia::server
