// Requests as bytes: the forms that must be read and those that must be refused.
#pragma once

#include "tests/server/http/bad_requests.h"
#include "tests/server/http/good_requests.h"
