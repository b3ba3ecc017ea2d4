// Arguments that several commands take.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/input/fields.h"
#include "core/scene/scene.h"
#include "server/contract/text_form.h"
#include "server/operation/config.h"

namespace tia::server {

/// A word without a dash.
inline void add_word(CLI::App& command, const char* name, std::string& word, const char* about) {
  command.add_option(name, word, about)->required()->type_name("");
}

inline void add_scene(CLI::App& command, std::string& scene) {
  add_word(command, "scene", scene, "a gallery scene's name, or a scene file: NAME.json or a path");
}

inline void add_output(CLI::App& command, std::string& file, const std::string& files) {
  command.add_option("-o,--output", file, files)->required()->type_name("");
}

inline void add_plain(CLI::App& command, bool& plain) {
  command.add_flag("--plain", plain,
                   "trace one ray and one thing at a time: the same bytes, to compare with");
}

/// The files of a model.
inline void add_model_files(CLI::App& command, std::vector<std::string>& files) {
  command
      .add_option("files", files,
                  "a GLB, glTF, OBJ, PLY or STL file, and others that it names; what it names "
                  "beside it is found")
      ->required()
      ->type_name("");
}

/// ParameterFlags: every parameter of a request but its scene, as a flag. What is given goes to
/// `settings`. For fields(), as of PictureRequest.
struct ParameterFlags {
  CLI::App& command;
  std::vector<Setting>& settings;

  template <class Base>
  void operator()(std::string_view, std::variant<std::string, Scene> Base::*, const Spec&) {}
  template <class Base, class Member>
  void operator()(std::string_view field, Member Base::*, const Spec& spec) {
    const std::string name(field);
    const auto take = [this_settings = &settings, name](const std::string& text) {
      this_settings->push_back({name, text, "--" + name});
    };
    command
        .add_option_function<std::string>(flag_of(name), take,
                                          spec.about + (": " + TextForm<Member>::allowed(spec)))
        ->type_name("");
  }
};

}  // namespace tia::server
