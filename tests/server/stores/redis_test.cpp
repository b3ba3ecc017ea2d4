// The connection to a Redis: its URL, who it believes, what becomes of calls when it goes away.
#include "server/stores/redis.h"

#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>
#include <signal.h>

#include <array>
#include <memory>
#include <utility>

#include "server/contract/problem.h"
#include "tests/server/redis_support.h"

namespace tia::test {
namespace {

TEST(RedisUrl, IsReadWhole) {
  using server::RedisAddress;
  const std::array<std::pair<const char*, RedisAddress>, 5> urls{
      {{"redis://host", {false, "", "host", 6379, 0}},
       {"rediss://tia@host.example:6380/3", {true, "tia", "host.example", 6380, 3}},
       {"redis://127.0.0.1:1/", {false, "", "127.0.0.1", 1, 0}},
       {"rediss://[fd00::1]:65535/15", {true, "", "fd00::1", 65535, 15}},
       {"redis://a-b_c.d@[::1]", {false, "a-b_c.d", "::1", 6379, 0}}}};
  for (const auto& [url, address] : urls) EXPECT_EQ(server::read_redis_url(url), address) << url;
}

TEST(RedisUrl, IsNothingElse) {
  for (const char* url : {"",
                          "host",
                          "http://host",
                          "redis:/host",
                          "redis://",
                          "redis:///0",
                          "redis://:6379",
                          "redis://tia:secret@host",
                          "redis://@host",
                          "redis://host:",
                          "redis://host:0",
                          "redis://host:65536",
                          "redis://host:+1",
                          "redis://host: 1",
                          "redis://host:6379x",
                          "redis://host/16",
                          "redis://host/-1",
                          "redis://host/a",
                          "redis://host/0/",
                          "redis://ho st",
                          "redis://[::1",
                          "redis://[]",
                          "redis://[::1]x",
                          "redis://[ho]:1]",
                          "redis://host?db=1",
                          "rediss ://host",
                          "REDIS://host",
                          "redis://a@b@host",
                          "redis://host:99999999999999999999"})
    EXPECT_THROW(server::read_redis_url(url), std::invalid_argument) << url;
}

/// Redises: tests of the program itself.
class Redises : public testing::Test {
 protected:
  void SetUp() override {
    if (RedisServer::program().empty()) GTEST_SKIP() << "redis-server is not installed";
  }
};

TEST_F(Redises, AnswerWithWhatTheyWereGiven) {
  server::Redis redis(empty_redis().options());
  const std::string bytes("\r\n\0$-1\xff", 7);
  EXPECT_EQ(redis.call({"SET", "k", bytes}).words, "OK");
  EXPECT_EQ(redis.call({"GET", "k"}).words, bytes);
  EXPECT_EQ(redis.call({"GET", "none"}).kind, server::RedisReply::nothing);
  EXPECT_EQ(redis.call({"STRLEN", "k"}).count, 7);
  const std::string large(3 << 20, 'x');
  redis.call({"SET", "large", large});
  const auto both = redis.call({"MGET", "large", "none"});
  ASSERT_EQ(both.items.size(), 2U);
  EXPECT_EQ(both.items[0].words, large);
  EXPECT_THROW(redis.call({"NO-SUCH"}), StorageAway);
  EXPECT_TRUE(redis.is_up());
}

TEST_F(Redises, ScriptsAreKnownToOneThatIsStartedAnew) {
  RedisServer server;
  server::Redis redis(server.options());
  server::RedisScript script("return KEYS[1] .. ARGV[1]");
  EXPECT_EQ(script.run(redis, "a", {"b"}).words, "ab");
  server.kill();
  EXPECT_THROW(script.run(redis, "a", {"b"}), StorageAway);
  EXPECT_FALSE(redis.is_up());
  server.start();
  EXPECT_EQ(script.run(redis, "a", {"b"}).words, "ab");
}

TEST_F(Redises, WhoSaysNothingIsWaitedForSoLongAndNoLonger) {
  RedisServer server;
  auto options = server.options();
  options.timeout = milliseconds(100);
  server::Redis redis(options);
  redis.call({"PING"});
  server.signal(SIGSTOP);
  const auto start = Clock::now();
  EXPECT_THROW(redis.call({"PING"}), StorageAway);
  EXPECT_LT(Clock::now() - start, seconds(5));
  server.signal(SIGCONT);
  EXPECT_TRUE(eventually([&] {
    try {
      return redis.call({"PING"}).words == "PONG";
    } catch (const StorageAway&) {
      return false;
    }
  })) << "and no answer is taken for another question's";
}

TEST_F(Redises, LetInWhoHasThePasswordAndOnlyToItsKeys) {
  RedisServer server(false, {"--user", "default", "off", "--user", "tia", "on", ">secret",
                             "~{tia}:*", "&{tia}:*", "+@all", "-@admin", "-@dangerous"});
  auto options = server.options();
  EXPECT_THROW(server::Redis(options).call({"GET", "{tia}:k"}), StorageAway);
  options.at.user = "tia", options.password = "wrong";
  EXPECT_THROW(server::Redis(options).call({"GET", "{tia}:k"}), StorageAway);
  options.password = "secret";
  server::Redis redis(options);
  EXPECT_EQ(redis.call({"SET", "{tia}:k", "v"}).words, "OK");
  EXPECT_THROW(redis.call({"GET", "other"}), StorageAway);
}

// ---- TLS ------------------------------------------------------------------------------------

using Key = std::unique_ptr<EVP_PKEY, void (*)(EVP_PKEY*)>;

// Writes a certificate of that name that vouches for itself, and its key.
void write_certificate(const std::string& name, const std::string& file,
                       const std::string& key_file) {
  const Key key(EVP_EC_gen("P-256"), EVP_PKEY_free);
  const std::unique_ptr<X509, void (*)(X509*)> made(X509_new(), X509_free);
  X509_set_version(made.get(), X509_VERSION_3);
  ASN1_INTEGER_set(X509_get_serialNumber(made.get()), 1);
  X509_gmtime_adj(X509_getm_notBefore(made.get()), -60);
  X509_gmtime_adj(X509_getm_notAfter(made.get()), 3600);
  X509_set_pubkey(made.get(), key.get());
  X509_NAME* const subject = X509_get_subject_name(made.get());
  X509_NAME_add_entry_by_txt(subject, "CN", MBSTRING_ASC,
                             reinterpret_cast<const unsigned char*>("test"), -1, -1, 0);
  X509_set_issuer_name(made.get(), subject);
  const std::unique_ptr<X509_EXTENSION, void (*)(X509_EXTENSION*)> names(
      X509V3_EXT_conf_nid(nullptr, nullptr, NID_subject_alt_name, name.c_str()),
      X509_EXTENSION_free);
  X509_add_ext(made.get(), names.get(), -1);
  ASSERT_GT(X509_sign(made.get(), key.get(), EVP_sha256()), 0);
  const auto write = [](const std::string& to, const auto& pem) {
    const std::unique_ptr<BIO, void (*)(BIO*)> out(BIO_new_file(to.c_str(), "w"), BIO_free_all);
    ASSERT_EQ(pem(out.get()), 1);
  };
  write(file, [&](BIO* out) { return PEM_write_bio_X509(out, made.get()); });
  write(key_file, [&](BIO* out) {
    return PEM_write_bio_PrivateKey(out, key.get(), nullptr, nullptr, 0, nullptr, nullptr);
  });
}

TEST_F(Redises, AreBelievedByTheirCertificateAlone) {
  const Folder folder;
  const auto made = [&](const std::string& name, const std::string& of) {
    write_certificate(name, folder.file(of + ".crt"), folder.file(of + ".key"));
    return folder.file(of + ".crt");
  };
  const std::string right = made("IP:127.0.0.1", "right"), other = made("DNS:other", "other");
  for (const std::string& used : {right, other}) {
    const std::string key = used.substr(0, used.size() - 3) + "key";
    const int port = free_port();
    RedisServer server(
        false, {"--tls-port", std::to_string(port), "--tls-cert-file", used, "--tls-key-file", key,
                "--tls-ca-cert-file", used, "--tls-auth-clients", "no"});
    auto options = server.options();
    options.at.is_tls = true, options.at.port = port, options.ca_file = used;
    if (used == right) {
      server::Redis redis(options);
      EXPECT_EQ(redis.call({"PING"}).words, "PONG");
      const std::string large(1 << 20, 'x');
      EXPECT_EQ(redis.call({"ECHO", large}).words, large);
      options.ca_file = other;
    }
    EXPECT_THROW(server::Redis(options).call({"PING"}), StorageAway) << "of another name, or CA";
  }
}

}  // namespace
}  // namespace tia::test
