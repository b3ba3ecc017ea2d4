// Recipes taken out of pictures, and put into them, by no function of the server's.
#pragma once

#include <string>

#include "tests/server/support.h"

namespace tia::test {

/// The text of a PNG's recipe, which it must have.
std::string recipe_text(const std::string& png);

/// The picture with another recipe in the place of its own.
std::string with_recipe(const std::string& png, const std::string& text);

/// The picture without its recipe, as an editor may save it.
std::string without_recipe(const std::string& png);

}  // namespace tia::test
