#include "server/operation/config.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "server/contract/text_form.h"

namespace tia::server {
namespace {

constexpr std::string_view prefix = "TIA_";

std::string variable_of(std::string_view name) {
  std::string variable(prefix);
  for (const char c : name) variable += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return variable;
}

struct RowMaker {
  const Config& config;
  std::vector<OptionRow> rows = {};
  template <class Member>
  void operator()(std::string_view name, Member Config::*member, const Spec& spec) {
    rows.push_back({std::string(name), flag_of(name), variable_of(name), spec.about,
                    TextForm<Member>::allowed(spec), text_of(write_value(config.*member))});
  }
};

// Where a fault's setting came from: the last one of that name is the one that counts.
const Setting* setting_at(const std::string& pointer, const std::vector<Setting>& settings) {
  const Setting* found = nullptr;
  for (const Setting& setting : settings)
    if ((pointer + '/').starts_with('/' + setting.name + '/')) found = &setting;
  return found;
}

std::string refusal(const Fault& fault, const std::vector<Setting>& settings) {
  const Setting* setting = setting_at(fault.pointer, settings);
  std::string text = "option " + (setting != nullptr ? setting->source : fault.pointer) + ": got " +
                     to_json(*fault.got) + ", allowed: " + fault.allowed;
  if (setting != nullptr && setting->text.starts_with("tcp://"))
    text +=
        "; Kubernetes sets this variable beside a Service of that name: put "
        "\"enableServiceLinks: false\" into the pod's spec, or call the Service otherwise";
  return text;
}

}  // namespace

std::string flag_of(std::string_view name) {
  std::string flag = "--" + std::string(name);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

void Config::check(const Place& at, Faults& faults) const {
  if (host.empty())
    faults.add({FaultKind::out_of_range, at.at("host").pointer(), Value(host),
                "an address, such as 127.0.0.1 or 0.0.0.0"});
}

ModelLimits Config::model_limits() const {
  ModelLimits limits;
  limits.triangles = static_cast<std::uint64_t>(max_triangles);
  limits.vertices = 3 * limits.triangles;
  limits.texture_pixels = static_cast<std::uint64_t>(max_texture_pixels);
  return limits;
}

int Config::processors() {
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 64);
}

std::vector<OptionRow> option_rows(const Config& config) {
  RowMaker maker{config};
  Config::fields(maker);
  return maker.rows;
}

std::string env_file(const Config& config) {
  std::string text;
  for (const OptionRow& row : option_rows(config))
    text += "# " + row.about + ": " + row.allowed + '\n' + row.variable + '=' + row.value + '\n';
  return text;
}

Config read_config(const std::vector<Setting>& settings) {
  Value::Object object;
  for (const Setting& setting : settings) {
    std::erase_if(object, [&](const auto& member) { return member.first == setting.name; });
    object.emplace_back(setting.name, field_from_text<Config>(setting.name, setting.text));
  }
  try {
    return read_described<Config>(object);
  } catch (const InputError& error) {
    throw std::invalid_argument(refusal(error.faults().front(), settings));
  }
}

std::vector<Setting> environment_settings() {
  std::vector<Setting> settings;
  for (const OptionRow& row : option_rows())
    if (const char* text = std::getenv(row.variable.c_str()))
      settings.push_back({row.name, text, row.variable});
  return settings;
}

std::vector<std::string> unknown_variables() {
  const std::vector<OptionRow> rows = option_rows();
  std::vector<std::string_view> known;
  for (const OptionRow& row : rows) known.push_back(row.variable);
  std::vector<std::string> unknown;
  for (char** each = environ; *each != nullptr; ++each) {
    const std::string_view variable =
        std::string_view(*each).substr(0, std::string_view(*each).find('='));
    if (!variable.starts_with(prefix) || std::count(known.begin(), known.end(), variable) > 0)
      continue;
    const std::string nearest = nearest_name(variable, known);
    unknown.push_back(std::string(variable) + " is no option" +
                      (nearest.empty() ? "" : ", did you mean " + nearest + "?"));
  }
  return unknown;
}

}  // namespace tia::server
