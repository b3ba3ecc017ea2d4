// All codecs: how numbers, words, lists and described structs stand in JSON.
#pragma once

// IWYU pragma: begin_exports
#include "core/input/containers.h"
#include "core/input/described.h"
#include "core/input/value_codecs.h"
// IWYU pragma: end_exports
