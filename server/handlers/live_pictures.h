// Pictures as they change, for one client who looks on: JPEGs, each in the place of the one before.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "server/handlers/service.h"
#include "server/http/message.h"
#include "server/operation/requester.h"
#include "server/requests/plan.h"

namespace tia::server {

/// LivePictures: one client's. Each picture is work of its own, as if it had been asked for by
/// itself, so that who looks on for long comes behind nobody, and holds no ticket meanwhile.
class LivePictures {
 public:
  /// All of them outlive it.
  LivePictures(Service& service, const Requester& requester, const SendPart& send)
      : service_(service), requester_(requester), send_(send) {}

  /// The picture as a JPEG; nothing where there is no place to draw it now and one has been shown
  /// before: then that stays. Domain: of a plan that takes codes. Errors: as picture_of.
  std::optional<std::string> draw(Plan& plan);
  /// Sends it. Once all that was sent is on its way, this returns: so a slow client has one to
  /// come. Errors: Stopped.
  void show(const std::string& jpeg, const Headers& fields, bool is_last = false);
  /// Waits until then, and looks round meanwhile. Errors: as look_round; Stopped.
  void wait_until(Clock::time_point then);
  /// What is to be done twice a second by who waits: a proxy between cuts off what it hears nothing
  /// of for long, so the last picture is sent again after some silence.
  /// Errors: Stopped; HttpError (draining) once the server goes down.
  void look_round();

 private:
  std::string drawn(Plan& plan);

  Service& service_;
  const Requester& requester_;
  const SendPart& send_;
  std::string last_;  // part; "" = none has been sent
  Clock::time_point sent_{};
};

/// The answer whose parts are live pictures, which `show` makes. It takes a place among the live
/// streams. Errors: as LiveStreams::take.
using ShowsLive = std::function<void(LivePictures& pictures)>;
Response live_response(ShowsLive show, const Request& request, Service& service);

}  // namespace tia::server
