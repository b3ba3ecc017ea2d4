// `tia job`: jobs of a server elsewhere.
#include <iostream>
#include <stdexcept>

#include "core/input/json.h"
#include "server/commands/commands.h"
#include "server/commands/files.h"
#include "server/commands/flags.h"
#include "server/http/client.h"

namespace tia::server {
namespace {

/// JobWishes: what the command line wants of a server's job.
struct JobWishes {
  std::string url = "http://localhost:8080", file, id, output;
  bool waits = false;
};

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

// Sends FILE, or standard input for "-", and says the job's id.
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

void add_submit(Command submit, JobWishes& wishes) {
  submit.word("file", wishes.file, "a JSON file");
  submit.flag("--wait", wishes.waits, "wait for its end");
  submit.option("-o,--output", wishes.output,
                "wait, and write the result there; NAME.zip for that of several pictures");
}

}  // namespace

void add_job(CommandLine& line) {
  auto& wishes = line.keep<JobWishes>();
  Command job = line.add_group("job", "jobs of a server: submit, status, cancel");
  job.option("--url", wishes.url, "the server [" + wishes.url + "]");
  add_submit(
      line.add_to(job, "submit", "send one, as POST /jobs takes it", [&] { submit_job(wishes); }),
      wishes);
  const auto with_id = [&](const char* name, const char* about, void (*act)(const JobWishes&)) {
    line.add_to(job, name, about, [&wishes, act] { act(wishes); })
        .word("id", wishes.id, "the job's id");
  };
  with_id("status", "say how far it is, as JSON", tell_job);
  with_id("cancel", "cancel it, or let its result go", cancel_job);
}

}  // namespace tia::server
