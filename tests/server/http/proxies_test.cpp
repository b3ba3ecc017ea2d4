// Whose word for a client's address is taken, and on which addresses a server can be reached.
#include "server/http/proxies.h"

#include "tests/server/http/wire.h"

namespace tia::test {
namespace {

struct Told {
  const char* law;
  std::string peer;
  std::vector<std::string> forwarded;  // the fields' values
  std::string client;
};
void PrintTo(const Told& told, std::ostream* out) { *out << told.law; }

bool is_ours(const std::string& address) {
  return address.starts_with("10.") || address == "fd00::1";
}

class ClientAddress : public testing::TestWithParam<Told> {};

TEST_P(ClientAddress, IsTheLastThatATrustedProxyTellsAndIsNone) {
  Headers headers{{"Host", "x"}};
  for (const std::string& value : GetParam().forwarded)
    headers.emplace_back("x-forwarded-for", value);
  EXPECT_EQ(client_address(GetParam().peer, headers, is_ours), GetParam().client);
}

const Told told_addresses[] = {
    {"ASocketsWithoutAWord", "9.9.9.9", {}, "9.9.9.9"},
    {"ASocketsWhoIsNoProxy", "9.9.9.9", {"1.1.1.1"}, "9.9.9.9"},
    {"AProxysWithoutAWord", "10.0.0.1", {}, "10.0.0.1"},
    {"AProxysWithAnEmptyWord", "10.0.0.1", {""}, "10.0.0.1"},
    {"OneBehindAProxy", "10.0.0.1", {"1.1.1.1"}, "1.1.1.1"},
    {"OneBehindAnIPv6Proxy", "fd00::1", {"2001:db8::5"}, "2001:db8::5"},
    {"OneWhoMadeUpAnother", "10.0.0.1", {"6.6.6.6, 1.1.1.1"}, "1.1.1.1"},
    {"OneWhoMadeUpAProxy", "10.0.0.1", {"10.0.0.9, 1.1.1.1"}, "1.1.1.1"},
    {"OneBehindTwoProxies", "10.0.0.1", {"1.1.1.1, 10.0.0.2"}, "1.1.1.1"},
    {"OneOfTwoFields", "10.0.0.1", {"6.6.6.6", "1.1.1.1, 10.0.0.2"}, "1.1.1.1"},
    {"AProxyOnly", "10.0.0.1", {"10.0.0.3, 10.0.0.2"}, "10.0.0.3"},
    {"NoAddress", "10.0.0.1", {"1.1.1.1, unknown"}, "10.0.0.1"},
    {"NothingBetweenCommas", "10.0.0.1", {"1.1.1.1, , 10.0.0.2"}, "10.0.0.2"},
    {"MarkUp", "10.0.0.1", {"<b>"}, "10.0.0.1"},
    {"OneWithItsPort", "10.0.0.1", {"1.2.3.4:5555"}, "1.2.3.4"},
    {"OneInBracketsWithItsPort", "10.0.0.1", {"[2001:db8::1]:99"}, "2001:db8::1"},
    {"OneInBrackets", "10.0.0.1", {"[2001:db8::1]"}, "2001:db8::1"},
    {"OneBehindAProxyWithItsPort", "10.0.0.1", {"1.1.1.1:1, 10.0.0.2:80"}, "1.1.1.1"},
    {"NoAddressButAPort", "10.0.0.1", {"unknown:80"}, "10.0.0.1"},
    {"NoPort", "10.0.0.1", {"1.2.3.4:"}, "10.0.0.1"},
    {"APortOfLetters", "10.0.0.1", {"1.2.3.4:x"}, "10.0.0.1"},
    {"TwoPorts", "10.0.0.1", {"1.2.3.4:5:6"}, "10.0.0.1"},
    {"IPv4InBrackets", "10.0.0.1", {"[1.2.3.4]:5"}, "10.0.0.1"},
    {"AnOpenBracket", "10.0.0.1", {"[2001:db8::1"}, "10.0.0.1"},
    {"WordsAfterABracket", "10.0.0.1", {"[2001:db8::1]x"}, "10.0.0.1"},
    {"BracketsOnly", "10.0.0.1", {"[]"}, "10.0.0.1"},
    {"ABracketOnly", "10.0.0.1", {"]"}, "10.0.0.1"},
    {"AZone", "10.0.0.1", {"fe80::1%anything"}, "10.0.0.1"},
    {"AZoneInBrackets", "10.0.0.1", {"[fe80::1%anything]:80"}, "10.0.0.1"},
    {"SpacesAround", "10.0.0.1", {" \t1.1.1.1 \t"}, "1.1.1.1"},
};
INSTANTIATE_TEST_SUITE_P(Of, ClientAddress, testing::ValuesIn(told_addresses), law_of);

// ---- over sockets ---------------------------------------------------------------------------

Application tells_peer() {
  return answering([](const Request& request) { return text(request.peer); });
}
const std::string spoofed =
    "GET / HTTP/1.1\r\nHost: x\r\nX-Forwarded-For: 6.6.6.6, 1.1.1.1\r\nREMOTE_ADDR: 7.7.7.7\r\n"
    "Connection: close\r\n\r\n";

std::string peer_seen(int port, const char* address = "127.0.0.1") {
  Wire wire(port, 0, address);
  wire.send(spoofed);
  return body_of(wire.rest());
}

TEST(Peer, IsTheSocketsWhereNobodyIsTrusted) {
  Serving serving(tells_peer());
  EXPECT_EQ(peer_seen(serving.port()), "127.0.0.1");
}

TEST(Peer, IsWhomATrustedProxyTells) {
  HttpOptions options = any_port();
  options.trusts_proxy = [](const std::string& address) { return address == "127.0.0.1"; };
  Serving serving(tells_peer(), options);
  EXPECT_EQ(peer_seen(serving.port()), "1.1.1.1");
}

class IPv6 : public testing::Test {
 protected:
  void SetUp() override {
    try {
      HttpServer({.host = "::1"}, tells_peer());
    } catch (const std::runtime_error&) {
      GTEST_SKIP() << "no IPv6 on this machine";
    }
  }
};

TEST_F(IPv6, AddressesAreListenedOn) {
  Serving serving(tells_peer(), {.host = "::1"});
  EXPECT_EQ(peer_seen(serving.port(), "::1"), "::1");
  EXPECT_THROW(Wire(serving.port(), 0, "127.0.0.1"), std::runtime_error);
}

TEST_F(IPv6, EveryAddressIncludesThoseOfIPv4WhichAreWrittenAsSuch) {
  Serving serving(tells_peer(), {.host = "::"});
  EXPECT_EQ(peer_seen(serving.port(), "::1"), "::1");
  EXPECT_EQ(peer_seen(serving.port(), "127.0.0.1"), "127.0.0.1");
}

TEST_F(IPv6, LocalhostIsBothAddressesOnOnePort) {
  Serving serving(tells_peer(), {.host = "localhost"});
  EXPECT_EQ(peer_seen(serving.port(), "127.0.0.1"), "127.0.0.1");
}

}  // namespace
}  // namespace tia::test
