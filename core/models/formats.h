// THE LIST of formats that models come in. A new one is one file beside this one and one row here.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/input/errors.h"
#include "core/models/model.h"
#include "core/models/model_files.h"

namespace tia {

/// ModelFormat: a row of the list.
struct ModelFormat {
  std::string_view name;
  std::string_view words;  ///< what people call it
  /// Whether a file is one, by its bytes alone.
  bool (*knows)(ModelBytes file);
  /// Reads the main file and what it names. Errors: as faults, with pointers into a JSON file or
  /// lines of a text; then the model is of no meaning.
  void (*read)(const ModelFiles& files, const ModelLimits& limits, Faults& faults, Model& model);
};

/// The formats in words.
std::string model_formats();

/// The row that knows a file, or null. The first one counts.
const ModelFormat* format_of(ModelBytes file);

/// Errors: InputError: with one fault `unknown_name` whose `got` is its first bytes where no row
/// knows the main file; of what read() finds; `missing` of a model without a triangle or point.
Model read_model(const ModelFiles& files, const ModelLimits& limits = {},
                 const std::stop_token& stop = {});

}  // namespace tia
