#include "server/config.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "server/text_form.h"

namespace tia::server {
namespace {

std::string variable_of(std::string_view name) {
  std::string variable = "TIA_";
  for (const char c : name) variable += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return variable;
}

struct RowMaker {
  std::vector<OptionRow> rows;
  template <class Member>
  void operator()(std::string_view name, Member Config::*member, const Spec& spec) {
    const Value standard = write_value(Config{}.*member);
    const auto* text = standard.template as<std::string>();
    rows.push_back({std::string(name), flag_of(name), variable_of(name), spec.about,
                    TextForm<Member>::allowed(spec), text != nullptr ? *text : to_json(standard)});
  }
};

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

int Config::processors() {
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 64);
}

std::vector<OptionRow> option_rows() {
  RowMaker maker;
  Config::fields(maker);
  return maker.rows;
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
    const Fault& fault = error.faults().front();
    std::string source = fault.pointer;
    for (const Setting& setting : settings)
      if ("/" + setting.name == fault.pointer) source = setting.source;
    throw std::invalid_argument("option " + source + ": got " + to_json(*fault.got) +
                                ", allowed: " + fault.allowed);
  }
}

std::vector<Setting> environment_settings() {
  std::vector<Setting> settings;
  for (const OptionRow& row : option_rows())
    if (const char* text = std::getenv(row.variable.c_str()))
      settings.push_back({row.name, text, row.variable});
  return settings;
}

}  // namespace tia::server
