#include "server/job_command.h"

#include <iostream>
#include <stdexcept>

#include "core/input/json.h"
#include "server/files.h"
#include "server/http/client.h"

namespace tia::server {
namespace {

std::string text_of(const Value& of, std::string_view name) {
  const auto* members = of.as<Value::Object>();
  const Value* member = members != nullptr ? find(*members, name) : nullptr;
  const auto* text = member != nullptr ? member->as<std::string>() : nullptr;
  return text != nullptr ? *text : "";
}

// What the server says in a problem document.
std::string told_in(const Response& answer) {
  try {
    if (const std::string detail = text_of(parse_json(answer.body), "detail"); !detail.empty())
      return detail;
  } catch (const InputError&) {  // it is no document
  }
  return "status " + std::to_string(answer.status);
}

Response asked(const JobWishes& wishes, const std::string& method, const std::string& path,
               const std::string& body = "", const Headers& headers = {}) {
  Response answer = Client(wishes.url).ask(method, path, body, headers);
  if (answer.status >= 400) throw std::runtime_error(wishes.url + ": " + told_in(answer));
  return answer;
}

std::string path_of(const JobWishes& wishes) { return "/jobs/" + wishes.id; }

// Errors: std::runtime_error where it has not ended well.
void wait_for_job(const JobWishes& wishes) {
  for (;;) {
    const Value status =
        parse_json(asked(wishes, "GET", path_of(wishes), "", {{"Prefer", "wait=30"}}).body);
    const std::string state = text_of(status, "state");
    if (state == "done") return;
    if (state != "queued" && state != "running")
      throw std::runtime_error("the job is " + state + ": " +
                               text_of(*find(*status.as<Value::Object>(), "problem"), "detail"));
  }
}

}  // namespace

void submit_job(const JobWishes& asked_for) {
  JobWishes wishes = asked_for;
  const Response accepted = asked(wishes, "POST", "/jobs", read_file(wishes.file));
  wishes.id = text_of(parse_json(accepted.body), "id");
  std::cerr << wishes.id << '\n';
  if (!wishes.waits && wishes.output.empty()) return;
  wait_for_job(wishes);
  if (wishes.output.empty()) return;
  const std::string format = wishes.output.ends_with(".zip") ? "?format=zip" : "";
  write_file(wishes.output, asked(wishes, "GET", path_of(wishes) + "/result" + format).body);
}

void tell_job(const JobWishes& wishes) {
  std::cout << asked(wishes, "GET", path_of(wishes)).body << std::endl;
}

void cancel_job(const JobWishes& wishes) { asked(wishes, "DELETE", path_of(wishes)); }

}  // namespace tia::server
