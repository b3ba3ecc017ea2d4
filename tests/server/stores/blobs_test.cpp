// What every place of blobs holds, by the same text for all; and what each does where it fails.
#include "server/stores/blobs.h"

#include <filesystem>
#include <fstream>

#include "server/contract/problem.h"
#include "server/stores/aws_signature.h"
#include "server/stores/digest.h"
#include "tests/server/redis_support.h"
#include "tests/server/s3_support.h"

namespace tia::test {
namespace {

using server::AwsRequest;
using server::AwsScope;
using server::Blobs;

// AWS, "Signature calculations for the Authorization header" of the S3 API reference: its four
// examples; and of the Signature Version 4 test suite (aws-sig-v4-test-suite) get-vanilla,
// post-vanilla and get-vanilla-query-order-key-case.
TEST(AwsSignature, IsThatOfTheirExamples) {
  const std::string empty = server::sha256_hex("");
  const AwsScope s3{"AKIAIOSFODNN7EXAMPLE", "wJalrXUtnFEMI/K7MDENG/bPxRfiCYEXAMPLEKEY",
                    "20130524T000000Z", "us-east-1", "s3"};
  const AwsScope suite{"AKIDEXAMPLE", "wJalrXUtnFEMI/K7MDENG+bPxRfiCYEXAMPLEKEY",
                       "20150830T123600Z", "us-east-1", "service"};
  const std::pair<std::string, std::string> s3_host{"host", "examplebucket.s3.amazonaws.com"},
      s3_date{"x-amz-date", s3.time}, host{"host", "example.amazonaws.com"},
      date{"x-amz-date", suite.time}, of_nothing{"x-amz-content-sha256", empty};
  const std::string welcome = server::sha256_hex("Welcome to Amazon S3.");
  struct Example {
    AwsRequest request;
    const AwsScope& scope;
    std::string signature;
  };
  const std::vector<Example> examples{
      {{"GET", "/test.txt", {}, {s3_host, {"range", "bytes=0-9"}, of_nothing, s3_date}, empty},
       s3,
       "f0e8bdb87c964420e857bd35b5d6ed310bd44f0170aba48dd91039c6036bdb41"},
      {{"PUT",
        "/test%24file.text",
        {},
        {{"date", "Fri, 24 May 2013 00:00:00 GMT"},
         s3_host,
         {"x-amz-content-sha256", welcome},
         s3_date,
         {"x-amz-storage-class", "REDUCED_REDUNDANCY"}},
        welcome},
       s3,
       "98ad721746da40c64f1a55b78f14c238d841ea1380cd77a1b5971af0ece108bd"},
      {{"GET", "/", {{"lifecycle", ""}}, {s3_host, of_nothing, s3_date}, empty},
       s3,
       "fea454ca298b7da1c68078a5d1bdbfbbe0d65c699e0f91ac7a200a0136783543"},
      {{"GET", "/", {{"prefix", "J"}, {"max-keys", "2"}}, {of_nothing, s3_date, s3_host}, empty},
       s3,
       "34b48302e7b5fa45bde8084f4b7868a86f0a534bc59db6670ed5711ef69dc6f7"},
      {{"GET", "/", {}, {host, date}, empty},
       suite,
       "5fa00fa31553b73ebf1942676e86291e8372ff2a2260956d9b8aae1d763fbf31"},
      {{"POST", "/", {}, {host, date}, empty},
       suite,
       "5da7c1a2acd57cee7505fc6676e4e544621c30862966e37dddb68e92efbe5d6b"},
      {{"GET", "/", {{"Param2", "value2"}, {"Param1", "value1"}}, {host, date}, empty},
       suite,
       "b97d918cfa904a5beff61c982a1b6f458b799221646efd99d3219ec94cdf2500"},
  };
  for (const Example& each : examples)
    EXPECT_THAT(aws_authorization(each.request, each.scope),
                testing::EndsWith(",Signature=" + each.signature));
}

/// BlobsOf: a place of each kind, empty.
class BlobsOf : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const std::string kind = GetParam();
    if (kind == "Folder") blobs = server::blobs_at("dir:" + folder.file(""), {});
    if (kind == "S3") blobs = server::blobs_at("s3://tia-test/a/b", s3.options());
    if (kind != "Redis") return;
    if (RedisServer::program().empty()) GTEST_SKIP() << "redis-server is not installed";
    redis.emplace(empty_redis().options());
    blobs = server::blobs_in_redis(*redis, "{tia}:test:");
  }
  Folder folder;
  S3StandIn s3;
  std::optional<server::Redis> redis;
  std::unique_ptr<Blobs> blobs;
};
INSTANTIATE_TEST_SUITE_P(Places, BlobsOf, testing::Values("Folder", "S3", "Redis"),
                         [](const auto& info) { return std::string(info.param); });

TEST_P(BlobsOf, GivesBackWhatItWasGivenUntilItIsTakenAway) {
  std::string bytes(300'000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * i >> 3U);
  EXPECT_FALSE(blobs->find("x/one"));
  blobs->put("x/one", bytes);
  blobs->put("x/two", "");
  blobs->put("x/one", bytes);  // as who has not heard that it is there
  EXPECT_TRUE(blobs->find("x/one") == bytes);
  EXPECT_EQ(blobs->find("x/two"), "");
  EXPECT_TRUE(checked_blob(*blobs, "x/one", server::sha256_hex(bytes)));
  EXPECT_FALSE(checked_blob(*blobs, "x/one", server::sha256_hex("other")));
  blobs->remove("x/one");
  blobs->remove("x/one");
  EXPECT_FALSE(blobs->find("x/one"));
}

TEST_P(BlobsOf, ListsWhatIsThere) {
  if (GetParam() == std::string("Redis")) GTEST_SKIP() << "it lists none";
  EXPECT_THAT(blobs->names("x/"), testing::IsEmpty());
  for (const char* name : {"x/1", "x/2", "x/3", "x/4", "x/5", "y/1"}) blobs->put(name, "a");
  EXPECT_THAT(blobs->names("x/"), testing::UnorderedElementsAre("x/1", "x/2", "x/3", "x/4", "x/5"));
  for (const std::string& name : blobs->names("x/")) blobs->remove(name);
  blobs->remove("y/1");
  EXPECT_THAT(blobs->names("x/"), testing::IsEmpty());
  EXPECT_TRUE(std::filesystem::is_empty(folder.file("")));
  EXPECT_TRUE(s3.kept().empty());
}

TEST(S3Blobs, AreAskedForAgainWhereS3Fails) {
  S3StandIn s3;
  const auto blobs = server::blobs_at("s3://tia-test", s3.options());
  using Fault = S3StandIn::Fault;
  s3.fail("PUT", Fault::answers_500, 2);
  blobs->put("a", "bytes");
  for (const Fault fault : {Fault::answers_500, Fault::flips_a_bit, Fault::cuts_the_body}) {
    s3.fail("GET", fault, 2);
    EXPECT_EQ(checked_blob(*blobs, "a", server::sha256_hex("bytes")), "bytes");
  }
  s3.fail("GET", Fault::flips_a_bit, 100);
  EXPECT_FALSE(checked_blob(*blobs, "a", server::sha256_hex("bytes"))) << "never used";
  s3.fail("PUT", Fault::answers_500, 100);
  EXPECT_THROW(blobs->put("b", "bytes"), server::StorageAway);
  s3.fail("PUT", Fault::is_full, 1);
  EXPECT_THROW(blobs->put("b", "bytes"), server::HttpError);
  EXPECT_FALSE(s3.kept().contains("b"));
  EXPECT_EQ(s3.refused(), 0);
}

TEST(S3Blobs, SayWhyTheyAreRefused) {
  S3StandIn s3;
  server::S3Options other = s3.options();
  other.key_secret = "another";
  try {
    server::blobs_at("s3://tia-test", other)->put("a", "bytes");
    FAIL() << "with another secret";
  } catch (const server::StorageError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("403, SignatureDoesNotMatch"));
  }
  EXPECT_TRUE(s3.kept().empty());
}

TEST(FolderBlobs, AreThereWholeOrNotAtAll) {
  const Folder folder;
  const auto blobs = server::blobs_at("dir:" + folder.file(""), {});
  blobs->put("a/one", "bytes");
  std::ofstream(folder.file("a/two.part-0"), std::ios::binary) << "by";  // who was killed meanwhile
  EXPECT_FALSE(blobs->find("a/two"));
  EXPECT_EQ(blobs->names("a/").size(), 2U) << "so that it is swept";
  std::filesystem::create_directory(folder.file("a/three"));  // in whose place no file can be
  EXPECT_THROW(blobs->put("a/three", "bytes"), server::StorageAway);
  EXPECT_EQ(blobs->names("a/").size(), 3U) << "nothing of it is left";
}

TEST(BlobsAt, RefusesWhatIsNoPlace) {
  for (const char* url : {"", "s3:/bucket", "s3://", "s3://ab", "s3://Bucket", "s3://bucket/a b",
                          "dir:", "dir:relative", "dir:/nowhere/at/all", "file:///tmp"})
    EXPECT_THROW(server::blobs_at(url, {}), std::invalid_argument) << url;
}

}  // namespace
}  // namespace tia::test
