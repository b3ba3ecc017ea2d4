// What the tests of /explain share: asking, and taking the answer's hits apart.
#pragma once

#include <string>
#include <vector>

#include "tests/server/support.h"

namespace tia::test {

struct ExplainedAt {
  double t;
  std::string object, type;
  Vec3d point, normal;
  bool front;
};

Vec3d vec(const Value& value);
Value array(const Vec3d& v);

Value answer_to(const Value::Object& asked);
std::vector<ExplainedAt> hits_of(const Value& answer);
std::vector<ExplainedAt> along(const std::string& scene, const Vec3d& from, const Vec3d& way);

void expect_near(const Vec3d& is, const Vec3d& expected, double within);
void expect_hit(const ExplainedAt& hit, double t, const char* object, bool front);

}  // namespace tia::test
