// The parameters of what is asked of a job.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "server/contract/text_form.h"
#include "server/jobs/job.h"

namespace tia::server {

/// How the results of a job come that has several.
enum class ResultsAs { zip };

}  // namespace tia::server

template <>
struct tia::Names<tia::server::ResultsAs> {
  static constexpr std::array<std::string_view, 1> names{"zip"};
};

namespace tia::server {

/// ResultQuery: the parameters of /jobs/{id}/result.
struct ResultQuery {
  static constexpr std::string_view schema_name = "job_result_query";
  std::optional<ResultsAs> format;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit(
        "format", &ResultQuery::format,
        Spec{.about = "zip: of several pictures an archive, 00000.png and so on; else their list"});
  }
};

/// JobsQuery: the parameters of GET /jobs.
struct JobsQuery {
  static constexpr std::string_view schema_name = "jobs_query";
  static constexpr int page = 100;
  int first = 0;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("first", &JobsQuery::first,
          Spec{.about = "the place in the list from which on they are told", .min = 0, .max = 1e6});
  }
};

/// PartsQuery: the parameters of /jobs/{id}/parts.
struct PartsQuery {
  static constexpr std::string_view schema_name = "job_parts_query";
  std::optional<PartState> state;
  int first = 0;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("state", &PartsQuery::state, Spec{.about = "those alone; else all"});
    visit(
        "first", &PartsQuery::first,
        Spec{
            .about = "the number from which on they are told, 1000 at most", .min = 0, .max = 1e9});
  }
};

}  // namespace tia::server
