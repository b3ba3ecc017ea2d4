// Arguments that several commands take.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/input/fields.h"
#include "core/scene/scene.h"
#include "server/commands/command_line.h"
#include "server/contract/text_form.h"

namespace tia::server {

inline void add_scene(Command& command, std::string& scene, bool required = true) {
  command.word("scene", scene, "a gallery scene's name, or a scene file: NAME.json or a path",
               required);
}

inline void add_output(Command& command, std::string& file, const std::string& files,
                       bool required = true) {
  command.option("-o,--output", file, files, required);
}

inline void add_plain(Command& command, bool& plain) {
  command.flag("--plain", plain,
               "trace one ray and one thing at a time: the same bytes, to compare with");
}

inline void add_model_files(Command& command, std::vector<std::string>& files) {
  command.words("files", files,
                "a GLB, glTF, OBJ, PLY or STL file, and others that it names; what it names "
                "beside it is found");
}

/// ParameterFlags: every parameter of a request but its scene, as a flag. What is given goes to
/// `settings`. For fields(), as of PictureRequest.
struct ParameterFlags {
  Command& command;
  std::vector<Setting>& settings;

  template <class Base>
  void operator()(std::string_view, std::variant<std::string, Scene> Base::*, const Spec&) {}
  template <class Base, class Member>
  void operator()(std::string_view field, Member Base::*, const Spec& spec) {
    const std::string name(field);
    const auto take = [this_settings = &settings, name](const std::string& text) {
      this_settings->push_back({name, text, "--" + name});
    };
    command.option(flag_of(name), take, spec.about + (": " + TextForm<Member>::allowed(spec)));
  }
};

}  // namespace tia::server
