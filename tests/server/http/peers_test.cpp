// Origins and networks: what is one, and which addresses a network holds.
#include "server/http/peers.h"

#include <gtest/gtest.h>

namespace tia::test {
namespace {

using server::Network;
using server::Origin;

TEST(Origin, IsASchemeAndAHostAndPerhapsAPort) {
  for (const char* text :
       {"*", "https://example.org", "http://localhost:3000", "https://a-b.example:8443",
        "http://127.0.0.1:1", "http://[::1]:65535", "https://[2001:db8::1]", "http://a:443"})
    EXPECT_TRUE(Origin::parse(text)) << text;
}

TEST(Origin, IsNothingThatNoBrowserSends) {
  for (const char* text : {"",
                           "example.org",
                           "https://",
                           "https://example.org/",
                           "https://example.org/a",
                           "null",
                           "https://Example.org",
                           "HTTPS://example.org",
                           "ftp://a",
                           "https://a:",
                           "https://a:0",
                           "https://a:65536",
                           "https://a:443",
                           "http://a:80",
                           "https://a:x",
                           "https://*.example.org",
                           "https://u@a",
                           "https://a b",
                           "**",
                           "https://a:01",
                           "http://:81"})
    EXPECT_FALSE(Origin::parse(text)) << text;
}

TEST(Network, IsAnAddressOrItsFirstBits) {
  for (const char* text : {"127.0.0.1", "10.0.0.0/8", "0.0.0.0/0", "192.168.1.128/25", "1.2.3.4/32",
                           "::1", "::/0", "fd00::/8", "2001:db8::1/128"})
    EXPECT_TRUE(Network::parse(text)) << text;
}

TEST(Network, IsNothingElse) {
  for (const char* text :
       {"", "/8", "10.0.0.0/", "10.0.0.0/33", "::/129", "10.0.0.0/-1", "10.0.0.0/+8", "10.0.0.0/08",
        "10.0.0.0/8 ", "10.0.0.0/8/8", "10.0.0/8", "256.0.0.1", "localhost", "10.0.0.1:80", "[::1]",
        "fe80::1%eth0", "10.0.0.1/8", "192.168.1.1/25", "fd00::1/8"})
    EXPECT_FALSE(Network::parse(text)) << text;
}

bool holds(const char* network, const char* address) {
  return Network::parse(network).value().contains(address);
}

TEST(Network, HoldsTheAddressesThatBeginAsItDoes) {
  EXPECT_TRUE(holds("10.0.0.0/8", "10.255.0.1"));
  EXPECT_FALSE(holds("10.0.0.0/8", "11.0.0.0"));
  EXPECT_TRUE(holds("192.168.1.128/25", "192.168.1.255"));
  EXPECT_FALSE(holds("192.168.1.128/25", "192.168.1.127"));
  EXPECT_TRUE(holds("127.0.0.1", "127.0.0.1"));
  EXPECT_FALSE(holds("127.0.0.1", "127.0.0.2"));
  EXPECT_TRUE(holds("fd00::/9", "fd7f::1"));
  EXPECT_FALSE(holds("fd00::/9", "fd80::1"));
  EXPECT_TRUE(holds("fe80::/10", "fe80::1%eth0"));
  EXPECT_TRUE(holds("::/0", "2001:db8::1"));
}

// A socket that takes both kinds gives IPv4 addresses as ::ffff:1.2.3.4.
TEST(Network, TakesIpv4AddressesInEitherSpelling) {
  EXPECT_TRUE(holds("10.0.0.0/8", "::ffff:10.1.2.3"));
  EXPECT_TRUE(holds("::ffff:10.0.0.0/104", "10.1.2.3"));
  EXPECT_TRUE(holds("0.0.0.0/0", "1.2.3.4"));
  EXPECT_FALSE(holds("0.0.0.0/0", "::1"));
}

TEST(Network, HoldsNothingThatIsNoAddress) {
  for (const char* text : {"", "localhost", "10.0.0.1:80", "unknown"})
    EXPECT_FALSE(holds("0.0.0.0/0", text)) << text;
}

}  // namespace
}  // namespace tia::test
