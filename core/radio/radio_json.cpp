// The answer of radio_paths as JSON, and its schema.
#include <algorithm>
#include <cmath>

#include "core/math/deterministic.h"
#include "core/radio/decibels.h"
#include "core/radio/radio_paths.h"

namespace tia {
namespace {

constexpr double degrees = 180 / pi;

Value json_of(const std::optional<double>& number) { return number ? Value(*number) : Value(); }

Value strings_json(const std::vector<std::string>& texts) {
  Value::Array list;
  for (const std::string& each : texts) list.emplace_back(each);
  return list;
}

// By name, or by number.
Value name_json(const Antenna& antenna, std::size_t number) {
  return antenna.name.empty() ? Value(static_cast<double>(number)) : Value(antenna.name);
}

Value angles_json(const Vec3d& from, const Vec3d& to) {
  const Vec3d way = normalize(to - from);
  return Value::Object{{"azimuth", atan2_of(-way.z, way.x) * degrees},
                       {"elevation", asin_of(std::clamp(way.y, -1.0, 1.0)) * degrees}};
}

Value gain_json(const PathGain& gain, int receiver_ports, int transmitter_ports) {
  Value::Array rows;
  for (std::size_t r = 0; r < static_cast<std::size_t>(receiver_ports); ++r) {
    Value::Array row;
    for (std::size_t t = 0; t < static_cast<std::size_t>(transmitter_ports); ++t)
      row.emplace_back(Value::Array{gain[r][t].re, gain[r][t].im});
    rows.emplace_back(std::move(row));
  }
  return rows;
}

Value interaction_json(const RadioInteraction& at, const std::vector<RadioBody>& bodies) {
  const double aside = std::sqrt(std::max(0.0, 1 - at.cosine * at.cosine));
  return Value::Object{{"kind", name_of(at.kind)},
                       {"object", bodies[static_cast<std::size_t>(at.body)].name},
                       {"element", static_cast<double>(at.element)},
                       {"normal", write_value(at.normal)},
                       {"angle_degrees", atan2_of(aside, at.cosine) * degrees}};
}

Value channel_json(const std::vector<PathGain>& list, int to, int from) {
  Value::Array all;
  for (const PathGain& each : list) all.emplace_back(gain_json(each, to, from));
  return all;
}

/// PairText: writes pairs of one question.
class PairText {
 public:
  PairText(const RadioQuestion& question, const RadioAnswer& answer)
      : question_(question), answer_(answer) {}

  Value operator()(const RadioPair& pair) const {
    const Antenna& sender = question_.transmitters[pair.transmitter];
    const Antenna& taker = question_.receivers[pair.receiver];
    const int to = port_count(taker.polarization), from = port_count(sender.polarization);
    Value::Array paths;
    for (const RadioPath& path : pair.paths) {
      give_way();
      paths.push_back(path_json(path, sender, taker));
    }
    Value::Object is{{"transmitter", name_json(sender, pair.transmitter)},
                     {"receiver", name_json(taker, pair.receiver)},
                     {"paths", std::move(paths)},
                     {"total", total_json(pair.total)}};
    if (pair.channel)
      is.emplace_back("channel",
                      Value::Object{{"frequency", channel_json(pair.channel->frequency, to, from)},
                                    {"impulse", channel_json(pair.channel->impulse, to, from)}});
    return is;
  }

 private:
  Value path_json(const RadioPath& path, const Antenna& sender, const Antenna& taker) const {
    const int to = port_count(taker.polarization), from = port_count(sender.polarization);
    const LinkWave link{{question_.frequency_hz}, question_.unit_metres};
    Value::Array points{write_value(path.from)}, interactions;
    for (const RadioInteraction& at : path.interactions) {
      points.push_back(write_value(at.point));
      interactions.push_back(interaction_json(at, answer_.bodies));
    }
    points.push_back(write_value(path.to));
    const double metres = path.length * question_.unit_metres;
    return Value::Object{{"points", std::move(points)},
                         {"interactions", std::move(interactions)},
                         {"length_m", metres},
                         {"delay_s", metres / speed_of_light},
                         {"departure", angles_json(path.from, path.second())},
                         {"arrival", angles_json(path.to, path.last_but_one())},
                         {"gain", gain_json(path.gain, to, from)},
                         {"gain_db", decibels_of(power_of(path.gain, to, from))},
                         {"doppler_hz", doppler_of(path, link, sender, taker)}};
  }
  static Value total_json(const RadioTotal& total) {
    return Value::Object{{"coherent_db", json_of(total.coherent_db)},
                         {"incoherent_db", json_of(total.incoherent_db)},
                         {"mean_delay_s", json_of(total.mean_delay_s)},
                         {"delay_spread_s", json_of(total.delay_spread_s)},
                         {"k_factor_db", json_of(total.k_factor_db)}};
  }

  const RadioQuestion& question_;
  const RadioAnswer& answer_;
};

Value object_of(const Value::Object& properties, const Value::Array& needed) {
  return Value::Object{{"type", "object"}, {"properties", properties}, {"required", needed}};
}
Value list_of(const Value& items) { return Value::Object{{"type", "array"}, {"items", items}}; }
Value either(const char* type, const char* other) {
  return Value::Object{
      {"anyOf", Value::Array{Value::Object{{"type", type}}, Value::Object{{"type", other}}}}};
}
Value numbers_schema(double count) {
  return Value::Object{{"type", "array"},
                       {"items", Value::Object{{"type", "number"}}},
                       {"minItems", count},
                       {"maxItems", count}};
}

}  // namespace

Value radio_paths_json(const RadioQuestion& question, const RadioAnswer& answer) {
  const PairText text(question, answer);
  Value::Array pairs;
  for (const RadioPair& each : answer.pairs) pairs.push_back(text(each));
  const PathCounts& n = answer.counts;
  return Value::Object{{"frequency_hz", question.frequency_hz},
                       {"method", name_of(question.method)},
                       {"assumed", strings_json(answer.assumed)},
                       {"warnings", strings_json(answer.warnings)},
                       {"pairs", std::move(pairs)},
                       {"counts", Value::Object{{"rays", static_cast<double>(n.rays)},
                                                {"images", static_cast<double>(n.images)},
                                                {"candidates", static_cast<double>(n.candidates)},
                                                {"blocked", static_cast<double>(n.blocked)},
                                                {"doubles", static_cast<double>(n.doubles)}}}};
}

Value radio_paths_schema() {
  const Value number = Value::Object{{"type", "number"}}, text = Value::Object{{"type", "string"}};
  const Value maybe = either("number", "null");
  const Value place = numbers_schema(3), gain = list_of(list_of(numbers_schema(2)));
  const Value angles =
      object_of({{"azimuth", number}, {"elevation", number}}, {"azimuth", "elevation"});
  const Value interaction = object_of({{"kind", text},
                                       {"object", text},
                                       {"element", number},
                                       {"normal", place},
                                       {"angle_degrees", number}},
                                      {"kind", "object", "element", "normal", "angle_degrees"});
  const Value path = object_of({{"points", list_of(place)},
                                {"interactions", list_of(interaction)},
                                {"length_m", number},
                                {"delay_s", number},
                                {"departure", angles},
                                {"arrival", angles},
                                {"gain", gain},
                                {"gain_db", number},
                                {"doppler_hz", number}},
                               {"points", "interactions", "length_m", "delay_s", "departure",
                                "arrival", "gain", "gain_db", "doppler_hz"});
  const Value total =
      object_of({{"coherent_db", maybe},
                 {"incoherent_db", maybe},
                 {"mean_delay_s", maybe},
                 {"delay_spread_s", maybe},
                 {"k_factor_db", maybe}},
                {"coherent_db", "incoherent_db", "mean_delay_s", "delay_spread_s", "k_factor_db"});
  const Value channel = object_of({{"frequency", list_of(gain)}, {"impulse", list_of(gain)}},
                                  {"frequency", "impulse"});
  const Value name = either("string", "integer");
  const Value pair = object_of({{"transmitter", name},
                                {"receiver", name},
                                {"paths", list_of(path)},
                                {"total", total},
                                {"channel", channel}},
                               {"transmitter", "receiver", "paths", "total"});
  const Value counts = object_of({{"rays", number},
                                  {"images", number},
                                  {"candidates", number},
                                  {"blocked", number},
                                  {"doubles", number}},
                                 {"rays", "images", "candidates", "blocked", "doubles"});
  return object_of({{"frequency_hz", number},
                    {"method", text},
                    {"assumed", list_of(text)},
                    {"warnings", list_of(text)},
                    {"pairs", list_of(pair)},
                    {"counts", counts}},
                   {"frequency_hz", "method", "assumed", "warnings", "pairs", "counts"});
}

}  // namespace tia
