// Bodies that nobody should send, and the most that is taken.
#include "core/models/multipart.h"

#include <gtest/gtest.h>

#include "tests/core/models/multipart_reading.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::expect_form_refused;
using test::Expected;
using test::form_with;
using test::FormParts;
using test::parts_of_form;
using test::wrong_in_part;

// ---- headers ------------------------------------------------------------------------------------

TEST(MultipartRefused, PartsWithoutANameAreRefused) {
  for (const std::string headers :
       {"X: 1", "Content-Disposition: form-data", "Content-Disposition: attachment; name=a",
        "Content-Disposition: form-data; filename=a", "Content-Disposition: form-data; name=",
        "Content-Disposition: form-data; name=\"a", "Content-Disposition: form-data; name=\"a\\\"",
        "Content-Disposition: form-data; name=a; name=b",
        "Content-Disposition: form-data; name=a; filename=b; filename=b",
        "Content-Disposition: form-data; name=a b", "Content-Disposition: form-data; name",
        "Content-Disposition: form-data; name=a; filename=\"\xFF\"", "Content-Disposition:"})
    expect_form_refused(form_with(headers), {wrong_in_part("1", "form-data with a name")});
  expect_form_refused("--b\r\n\r\nx\r\n--b--", {wrong_in_part("1", "form-data with a name")});
  expect_form_refused("--b\r\n\r\n--b--", {wrong_in_part("1", "form-data with a name")});
}

TEST(MultipartRefused, HeadersThatAreNoneAreRefused) {
  const std::string good = "Content-Disposition: form-data; name=a";
  for (const std::string line : {"no colon", ": 1", "a b: 1", " folded: 1", "a : 1", "\xC3\xA9: 1"})
    expect_form_refused(form_with(good + "\r\n" + line), {wrong_in_part("1", "a name, : and a")});
  for (const std::string line : {"a: \n", "a: b\rc", "a: \x01"})
    expect_form_refused(form_with(good + "\r\n" + line), {wrong_in_part("1", "control")});
  expect_form_refused(form_with(good + "\r\n" + good), {wrong_in_part("1", "each header once")});
  expect_form_refused(form_with(good + "\r\nContent-Type: a/b\r\ncontent-type: a/b"),
                      {wrong_in_part("1", "each header once")});
  for (const std::string way : {"base64", "quoted-printable", ""})
    expect_form_refused(form_with(good + "\r\nContent-Transfer-Encoding: " + way),
                        {wrong_in_part("1", "no Content-Transfer-Encoding")});
  expect_form_refused("--b\r\n" + good + "\r\n--b--", {wrong_in_part("1", "an empty line")});
  expect_form_refused("--b\r\n" + good + "\n\nx\r\n--b--", {wrong_in_part("1", "an empty line")});
}

TEST(MultipartRefused, FaultsOfSeveralPartsAreAllTold) {
  const std::string good = "--b\r\nContent-Disposition: form-data; name=a\r\n\r\nx\r\n";
  expect_form_refused(
      "--b\r\n\r\n1\r\n" + good + "--b\r\nX\r\n\r\n\r\n" + good + "--b--",
      {wrong_in_part("1", "with a name"), wrong_in_part("3", "a name, : and a value")});
  expect_form_refused("--b\r\n\r\n1\r\n" + good,
                      {wrong_in_part("1", "with a name"), wrong_in_part("2", "the boundary")});
}

// ---- bodies that break off ----------------------------------------------------------------------

TEST(MultipartRefused, BodiesWithoutABoundaryAreRefused) {
  for (const std::string body : {"", "--", "--b", "--b-", "--b\r", "--b\r\n", "x--b--", "\n--b--",
                                 "--B--\r\n", "--b\n--b--\n", "--b\r\n--b--", "--b--x"})
    expect_form_refused(body, {wrong_in_part("1", "the boundary of the Content-Type")});
}

TEST(MultipartRefused, CutAnywhereItIsRefused) {
  const std::string body =
      "before\r\n--b\r\nContent-Disposition: form-data; name=a; filename=\"a.obj\"\r\n\r\nv\r\n"
      "--b\r\nContent-Disposition: form-data; name=b\r\nContent-Type: a/b\r\n\r\n\r\n--b--\r\n";
  for (std::size_t size = 0; size < body.size() - 2; ++size) {
    Faults faults;
    // The last line break alone may be lost, or its second half be something after the end.
    ASSERT_EQ(parts_of_form(body.substr(0, size), "b", faults), FormParts()) << size;
    ASSERT_FALSE(faults.empty()) << size;
  }
  EXPECT_EQ(parts_of_form(body.substr(0, body.size() - 2)).size(), 2U);
}

TEST(MultipartRefused, BytesThatAreWrongNeverLeadOutside) {
  const std::string body = form_with(
      "Content-Disposition: form-data; name=\"a\"; filename=\"a.obj\"\r\nContent-Type: a/b",
      "\r\n-");
  test::Random random(9321);
  for (int i = 0; i < 5000; ++i) {
    std::string wrong = body;
    for (int n = random.whole(1, 3); n > 0; --n) {
      const auto at = static_cast<std::size_t>(random.below(static_cast<int>(wrong.size())));
      wrong[at] = random.chance(0.5) ? "\r\n-b\";=: \\%"[random.below(11)]
                                     : static_cast<char>(random.below(256));
    }
    Faults faults;
    const FormParts parts = parts_of_form(wrong, "b", faults);
    ASSERT_TRUE(faults.empty() || parts.empty()) << i;
  }
}

// ---- limits -------------------------------------------------------------------------------------

TEST(MultipartLimits, TakesAtMost1024Parts) {
  std::string body;
  for (int i = 0; i < 1024; ++i)
    body += "--b\r\nContent-Disposition: form-data; name=a\r\n\r\n\r\n";
  EXPECT_EQ(parts_of_form(body + "--b--").size(), 1024U);
  body += "--b\r\nContent-Disposition: form-data; name=a\r\n\r\n\r\n";
  expect_form_refused(body + "--b--",
                      {{FaultKind::limit, "", "\"part 1025\"", "at most 1024 parts"}});
}

TEST(MultipartLimits, TakesAtMost16KiBOfHeaders) {
  const std::string good = "Content-Disposition: form-data; name=a\r\nX: ";
  const std::size_t most = 16'384 - good.size() - 4;
  EXPECT_EQ(parts_of_form(form_with(good + std::string(most, 'x'))),
            (FormParts{{"a", std::nullopt, "", "x"}}));
  const std::vector<Expected> too_long{
      {FaultKind::limit, "", "\"part 1\"", "at most 16384 bytes of headers"}};
  expect_form_refused(form_with(good + std::string(most + 1, 'x')), too_long);
  expect_form_refused(form_with(good + std::string(100'000, 'x')), too_long);
}

// A quadratic search would take minutes for this.
TEST(MultipartLimits, SearchesInLinearTime) {
  const std::string boundary(70, '-');
  std::string bytes;
  for (int i = 0; i < 30'000; ++i) bytes += "\r\n--" + boundary + " x";
  bytes += std::string(500'000, '\r') + std::string(500'000, ' ') + std::string(500'000, '-');
  EXPECT_EQ(parts_of_form("--" + boundary + "\r\nContent-Disposition: form-data; name=a\r\n\r\n" +
                              bytes + "\r\n--" + boundary + "--",
                          boundary),
            (FormParts{{"a", std::nullopt, "", bytes}}));
}

}  // namespace
}  // namespace tia
