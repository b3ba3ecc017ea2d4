// Jobs that are asked for: by POST /jobs, or by a request that prefers not to wait.
#pragma once

#include <optional>
#include <string_view>

#include "server/contract/contract.h"
#include "server/handlers/service.h"
#include "server/http/message.h"
#include "server/jobs/job_request.h"
#include "server/requests/picture_request.h"

namespace tia::server {

/// Keeps the job and says where it is: 202. `body`: what asked for it, which an Idempotency-Key
/// stands for. Errors: InputError, pointers into the job; as JobStore::submit.
Response submitted(const JobRequest& asked, std::string_view body, const Request& request,
                   Service& service);

/// Whether the client would rather have a job than wait for the picture, which can be one.
bool prefers_job(const Request& request, const PictureRequest& picture);
/// The picture as a job; none where its objects are so large that its recipe does not tell them:
/// then it is drawn as ever. Errors: as submitted(), plan_of.
std::optional<Response> submitted_picture(const PictureRequest& picture, const Request& request,
                                          Service& service);

/// What the documents say of such an answer, and of a job's status.
Answer submitted_answer(std::string_view about);
Value job_status_schema(Definitions& named);

}  // namespace tia::server
