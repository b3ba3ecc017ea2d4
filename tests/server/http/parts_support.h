// What tests of answers in parts share.
#pragma once

#include "server/http/request_reader.h"

#include "tests/server/http/wire.h"

namespace tia::test {

inline const std::string plain_get_1_0 = "GET / HTTP/1.0\r\n\r\n";

using MakesParts = std::function<void(const SendPart&)>;

inline Application in_parts(const MakesParts& parts) {
  return answering([parts](const Request&) {
    Response response{.status = 200, .content_type = "text/plain", .body = ""};
    response.parts = parts;
    return response;
  });
}

// A chunked body's data; nothing where it is cut. Read as a request's would be.
inline std::optional<std::string> data_of(const std::string& chunks) {
  RequestReader reader(1 << 30);
  reader.feed(forms::chunks(chunks));
  if (reader.read() != RequestReader::State::whole) return std::nullopt;
  return reader.take().body;
}

}  // namespace tia::test
