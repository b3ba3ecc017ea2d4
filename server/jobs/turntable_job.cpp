// Jobs of a model that is turned: the views that /still puts on the sheet of its turntable, each a
// picture.
#include "core/input/json.h"
#include "server/jobs/kinds.h"
#include "server/requests/still_query.h"

namespace tia::server {
namespace {

constexpr int most_turned_views = 3600;

int views_of(const JobRequest& asked) {
  const Value& value = needed(asked.views, "/views", "how many views");
  Faults faults;
  int views = 0;
  const Place all;
  read_value(value, all.at("views"), Spec{.min = 1, .max = most_turned_views}, faults, views);
  faults.raise();
  return views;
}

StillQuery still_in(const Value& request, const Requester& requester) {
  auto asked = read_described<StillQuery>(request, {}, requester.stop);
  const auto refuse = [](const char* pointer, const Value& got, const char* allowed) {
    throw InputError({FaultKind::conflict, pointer, got, allowed});
  };
  if (asked.turntable) refuse("/turntable", *asked.turntable, "views, beside request");
  if (asked.StillRequest::camera)
    refuse("/camera", write_value(*asked.StillRequest::camera), "orbit, zoom and fov");
  if (asked.as == StillAs::scene) refuse("/as", "scene", "picture, which is drawn");
  if (asked.stream) refuse("/stream", write_value(*asked.stream), "GET /jobs/{id}/events");
  if (asked.budget_ms) refuse("/budget_ms", *asked.budget_ms, "no budget");
  if (asked.max_rays)
    refuse("/max_rays", static_cast<double>(*asked.max_rays), "max_rays beside request");
  return asked;
}

/// Turned: the views of a model. All but the cameras and lights of their scenes is the same.
class Turned : public JobParts {
 public:
  Turned(StillQuery asked, int views, const JobHost& host, const Requester& requester)
      : asked_(std::move(asked)) {
    const SharedModel model = find_model(asked_.id, host.context, requester);
    if (!model)
      throw InputError({FaultKind::missing, "/model", excerpt(Value(asked_.id)),
                        "a name of the gallery's models, or the id of one that is kept"});
    scenes_ = turned_stills_of(asked_, model, views, requester.stop);
    along_ = {asked_.id, model};
  }
  PictureRequest part(int n) const override {
    PictureRequest picture = asked_;
    picture.scene = scenes_.at(n);
    picture.along = along_;
    return picture;
  }
  std::string place(int n) const override { return "\"frame\":" + std::to_string(n); }

 private:
  StillQuery asked_;
  TurnedStills scenes_;
  ModelAlong along_;
};

JobPlan plan_turntable(const JobRequest& asked, const JobHost& host, const Requester& requester) {
  refuse_member(asked.requests, "/requests", "request, which is one: the kind is turntable");
  refuse_member(asked.grid, "/grid", "the kind batch, which has one");
  const Value& request = needed(asked.request, "/request", "what /still takes");
  const int views = views_of(asked);
  JobPlan made;
  at_place("/request", [&] {
    const Turned turned(still_in(request, requester), views, host, requester);
    for (int n = 0; n < views; ++n) {
      end_if_asked(requester.stop);
      const PictureRequest picture = turned.part(n);
      made.rays += checked_plan_of(picture, host.context, requester).sure_rays();
    }
  });
  made.parts = views;
  made.request = to_json(Value::Object{{"request", request}, {"views", views}});
  return made;
}

std::unique_ptr<JobParts> open_turntable(const Job& job, const JobHost& host,
                                         const Requester& requester) {
  const JobRequest asked = asked_again(job);
  return std::make_unique<Turned>(still_in(*asked.request, requester), views_of(asked), host,
                                  requester);
}

}  // namespace

const JobKind turntable_job{"turntable", plan_turntable, open_turntable};

}  // namespace tia::server
