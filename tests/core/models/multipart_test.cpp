// Bodies as curl, Chromium and Firefox send them.
#include "core/models/multipart.h"

#include <gtest/gtest.h>

#include "tests/core/models/multipart_reading.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::ExpectedPart;
using test::file_bytes;
using test::form_with;
using test::FormParts;
using test::parts_of_form;

// ---- the boundary -------------------------------------------------------------------------------

TEST(BoundaryOf, IsReadQuotedOrNot) {
  using Boundary = std::optional<std::string>;
  EXPECT_EQ(boundary_of("multipart/form-data; boundary=----WebKitFormBoundaryV9moV3CoysoyAvjU"),
            Boundary("----WebKitFormBoundaryV9moV3CoysoyAvjU"));
  EXPECT_EQ(boundary_of("Multipart/Form-Data ;charset=utf-8; BOUNDARY=\"a b:c\" "),
            Boundary("a b:c"));
  EXPECT_EQ(boundary_of("multipart/form-data;boundary=----=_Part_1.2;"),
            Boundary("----=_Part_1.2"));
  EXPECT_EQ(boundary_of("multipart/form-data; boundary=aZ09'()+_,-./:=?"),
            Boundary("aZ09'()+_,-./:=?"));
  EXPECT_EQ(boundary_of("multipart/form-data; boundary=" + std::string(70, 'x')),
            Boundary(std::string(70, 'x')));
}

TEST(BoundaryOf, IsNothingWhereTheTypeNamesNone) {
  for (const std::string type : {"",
                                 "multipart/form-data",
                                 "multipart/mixed; boundary=b",
                                 "multipart/form-data; boundary=",
                                 "multipart/form-data; boundary=\"\"",
                                 "multipart/form-data; boundary=\"b",
                                 "multipart/form-data; boundary=\"b \"",
                                 "multipart/form-data; boundary=a b",
                                 "multipart/form-data; boundary= b",
                                 "multipart/form-data; boundary =b",
                                 "multipart/form-data; boundary=a; boundary=a",
                                 "multipart/form-data; boundary=\"a\"b",
                                 "multipart/form-data; boundary=a\r\nb",
                                 "multipart/form-data; boundary=\"a\\b\"",
                                 "multipart/form-data; boundary=é",
                                 "multipart/form-data; boundary=a&b",
                                 "multipart/form-data, boundary=b",
                                 "; boundary=b",
                                 "boundary=b",
                                 ";",
                                 "=",
                                 ";=",
                                 ";a=\"\\"})
    EXPECT_EQ(boundary_of(type), std::nullopt) << type;
  EXPECT_EQ(boundary_of("multipart/form-data; boundary=" + std::string(71, 'x')), std::nullopt);
}

// ---- bodies as they come ------------------------------------------------------------------------

// curl 7.88: -F model=@chair.obj -F 'wood=@q"b.png;filename=textures/q"b.png' -F e=@empty.bin
// -F note=hi
TEST(Multipart, TakesWhatCurlSends) {
  const std::string boundary = "------------------------0debbf0f307f12a5", line = "--" + boundary;
  const std::string body =
      line +
      "\r\nContent-Disposition: form-data; name=\"model\"; "
      "filename=\"chair.obj\"\r\nContent-Type: application/octet-stream\r\n"
      "\r\nv 0 0 0\nv 0 0 0\n\r\n" +
      line +
      "\r\nContent-Disposition: form-data; name=\"wood\"; "
      "filename=\"textures/q%22b.png\"\r\nContent-Type: image/png\r\n\r\n"
      "a\r\n" +
      line +
      "\r\nContent-Disposition: form-data; name=\"e\"; "
      "filename=\"empty.bin\"\r\nContent-Type: application/octet-stream\r\n"
      "\r\n\r\n" +
      line + "\r\nContent-Disposition: form-data; name=\"note\"\r\n\r\nhi\r\n" + line + "--\r\n";
  EXPECT_EQ(parts_of_form(body, boundary),
            (FormParts{{"model", "chair.obj", "application/octet-stream", "v 0 0 0\nv 0 0 0\n"},
                       {"wood", "textures/q\"b.png", "image/png", "a"},
                       {"e", "empty.bin", "application/octet-stream", ""},
                       {"note", std::nullopt, "", "hi"}}));
}

// A FormData of a blob named t/d"\é%22.png, a text and a file that was not chosen; and an empty
// one.
TEST(Multipart, TakesWhatChromiumSends) {
  const std::string boundary = "----WebKitFormBoundaryV9moV3CoysoyAvjU", line = "--" + boundary;
  const std::string body =
      line +
      "\r\nContent-Disposition: form-data; name=\"a%22b%0D%0Ac\"; "
      "filename=\"t/d%22\\é%22.png\"\r\nContent-Type: model/gltf-binary\r\n\r\nx\r\n" +
      line + "\r\nContent-Disposition: form-data; name=\"t\"\r\n\r\nhi\r\n" + line +
      "\r\nContent-Disposition: form-data; name=\"none\"; filename=\"\"\r\n"
      "Content-Type: application/octet-stream\r\n\r\n\r\n" +
      line + "--\r\n";
  EXPECT_EQ(parts_of_form(body, boundary),
            (FormParts{{"a\"b\r\nc", "t/d\"\\é\".png", "model/gltf-binary", "x"},
                       {"t", std::nullopt, "", "hi"},
                       {"none", "", "application/octet-stream", ""}}));
  EXPECT_EQ(parts_of_form(line + "--\r\n", boundary), FormParts());
}

TEST(Multipart, TakesWhatFirefoxSends) {
  const std::string boundary = "---------------------------9051914041544843365972754266";
  const std::string line = "--" + boundary;
  EXPECT_EQ(parts_of_form(line +
                              "\r\nContent-Disposition: form-data; name=\"file1\"; "
                              "filename=\"a.txt\"\r\nContent-Type: text/plain\r\n\r\n"
                              "Content of a.txt.\n\r\n" +
                              line + "--\r\n",
                          boundary),
            (FormParts{{"file1", "a.txt", "text/plain", "Content of a.txt.\n"}}));
}

TEST(Multipart, BytesAreViewsIntoTheBody) {
  const std::string body = form_with("Content-Disposition: form-data; name=a", "bytes");
  Faults faults;
  const auto parts = parse_multipart(file_bytes(body), "b", faults);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].bytes.data(), file_bytes(body).data() + body.find("bytes"));
}

TEST(Multipart, WhatStandsBeforeAndAfterIsPassedOver) {
  const std::string part = form_with("Content-Disposition: form-data; name=\"a\"");
  const FormParts parts{{"a", std::nullopt, "", "x"}};
  for (const std::string before : {"", "\r\n", "a preamble\r\n", "--bb\r\n", "--b is it\r\n"})
    for (const std::string after : {"", "\r\n--b\r\nan epilogue", "--b\r\n--b--"})
      EXPECT_EQ(parts_of_form(before + part + after), parts) << before << ", " << after;
  EXPECT_EQ(parts_of_form(part.substr(0, part.size() - 2)), parts);
  EXPECT_EQ(parts_of_form(part.substr(0, part.size() - 2) + " \t"), parts);
}

TEST(Multipart, BlanksMayFollowABoundary) {
  EXPECT_EQ(
      parts_of_form("--b \t\r\nContent-Disposition: form-data; name=a\r\n\r\nx\r\n--b--  \r\n"),
      (FormParts{{"a", std::nullopt, "", "x"}}));
}

TEST(Multipart, BytesThatLookLikeBoundariesAreBytes) {
  for (const std::string bytes :
       {"\r\n", "\n--b", "--bb", "x--b\r\n", "\r\n--", "\r\n-b\r\n", "\r\n--c\r\n", "\r\n--bb\r\n",
        "\r\n--b-\r\n", "\r\n--b--x", "\r\n--b x\r\n", "\r\n--B\r\n", "\r\r\n--b\n", "\r\n--b\r",
        "\r\n\r\n--a", "\r\n\r\n"})
    EXPECT_EQ(parts_of_form(form_with("Content-Disposition: form-data; name=a", bytes)),
              (FormParts{{"a", std::nullopt, "", bytes}}));
}

TEST(Multipart, RandomBytesComeBack) {
  test::Random random(9320);
  for (int i = 0; i < 300; ++i) {
    FormParts parts;
    std::string body;
    for (int left = random.below(5); left >= 0; --left) {
      ExpectedPart part{"n" + std::to_string(left), std::to_string(left) + ".bin", "x/y", ""};
      for (int n = random.below(60); n > 0; --n)
        part.bytes +=
            random.chance(0.5) ? "\r\n-b"[random.below(4)] : static_cast<char>(random.below(256));
      if (("\r\n" + part.bytes).find("\r\n--b") != std::string::npos) part.bytes.clear();
      body += "--b\r\nContent-Disposition: form-data; name=\"" + part.name + "\"; filename=\"" +
              *part.filename + "\"\r\nContent-Type: x/y\r\n\r\n" + part.bytes + "\r\n";
      parts.push_back(part);
    }
    ASSERT_EQ(parts_of_form(body + "--b--"), parts) << i;
  }
}

// ---- headers ------------------------------------------------------------------------------------

TEST(Multipart, NamesAreReadAsTheyAreWritten) {
  const auto filename = [](const std::string& parameters) {
    const FormParts parts =
        parts_of_form(form_with("CONTENT-disposition:Form-Data;name=a;" + parameters));
    return parts.at(0).filename;
  };
  using Name = std::optional<std::string>;
  EXPECT_EQ(filename("filename=\"a \\\"b\\\" \\\\ c\""), Name("a \"b\" \\ c"));
  EXPECT_EQ(filename("filename=\"textures\\wood.png\""), Name("textures\\wood.png"));
  EXPECT_EQ(filename("filename=\"100%25 %2F %0d%0A%22%\""), Name("100%25 %2F \r\n\"%"));
  EXPECT_EQ(filename("filename=a.png"), Name("a.png"));
}

TEST(Multipart, ParametersWithAStarAndOtherHeadersArePassedOver) {
  EXPECT_EQ(parts_of_form(
                form_with("X-Other: 1\r\nX-Other: 2\r\nContent-Disposition: form-data; name=\"a\"; "
                          "filename*=UTF-8''b.png; size=3;\r\nContent-Transfer-Encoding: Binary")),
            (FormParts{{"a", std::nullopt, "", "x"}}));
}

TEST(Multipart, PartsMayHaveHeadersOnly) {
  EXPECT_EQ(parts_of_form("--b\r\nContent-Disposition: form-data; name=a\r\n\r\n--b--"),
            (FormParts{{"a", std::nullopt, "", ""}}));
}

}  // namespace
}  // namespace tia
