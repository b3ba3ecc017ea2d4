#include "core/parallel/lone.h"

namespace tia {
namespace {

constinit thread_local Lone* lone = nullptr;

const std::function<void(int)> nothing{};  // its caller alone knows what is to be done

}  // namespace

Lone::Lone(Hands& hands, const std::stop_token& stop, Flow& flow)
    : hands_(hands), job_(hands, 1, 1, stop, nothing, flow, true) {
  hands_.enter(job_);
}

Lone::~Lone() {
  if (is_at_work_) rest();
  hands_.leave(job_);
}

Lone* Lone::present() { return lone; }

void Lone::work(const std::function<void()>& work) {
  take_turn();
  work();
}

void Lone::aside(const std::function<void()>& work) {
  rest();
  hands_.pause(job_);
  work();
  hands_.resume(job_);
  take_turn();
}

void Lone::take_turn() {
  hands_.begin_alone(job_);
  is_at_work_ = true;
  lone = this;
}

void Lone::rest() {
  hands_.end_alone(job_);
  is_at_work_ = false;
  lone = nullptr;
}

}  // namespace tia
