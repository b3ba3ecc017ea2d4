// What an explanation as JSON may be.
#include "core/input/object_schema.h"
#include "core/render/explain.h"
#include "core/render/explain_paths.h"

namespace tia {
namespace {

using Pair = std::array<double, 2>;

Value triple_schema() { return plain_schema<Vec3d>(); }
Value number_schema(const Spec& spec = {}) { return plain_schema<double>(spec); }
Value name_schema() { return plain_schema<std::string>(); }
Value copy_schema() { return list_schema(plain_schema<std::array<int, 3>>({.min = 0})); }

Value ray_schema(Definitions& named) {
  return schema_called("ray", named, [] {
    return object_schema(
        {{"origin", triple_schema()},
         {"direction", triple_schema(), "of length 1"},
         {"raster", plain_schema<Pair>(), "a pixel's: where it goes through, in pixels", false},
         {"ndc", plain_schema<Pair>(), "the same from 0 to 1, y down", false},
         {"screen", plain_schema<Pair>(), "the same from -1 to 1, y up", false}});
  });
}

Value hit_schema() {
  const Value root = object_schema(
      {{"bracket", plain_schema<Pair>(), "the interval of t that was told to hold the root alone"},
       {"how", name_schema(), "how that was told"},
       {"degree", count_schema(1), "of the equation", false}});
  return object_schema(
      {{"t", number_schema(), "the distance along the ray"},
       {"object", name_schema(), "its name, or a JSON Pointer into the scene"},
       {"id", count_schema(1), "which of objects it is"},
       {"type", name_schema(), "of its shape"},
       {"point", triple_schema()},
       {"normal", triple_schema(), "of length 1"},
       {"uv", plain_schema<Pair>(), "where on the surface"},
       {"front", plain_schema<bool>(), "whether it is met from outside"},
       {"copy", copy_schema(),
        "of an object in groups that are repeated: which copy of each, the outermost first, along "
        "x, y and z from 0",
        false},
       {"root", root, "of a surface that is an equation's: how it was found", false}});
}

Value object_entry_schema() {
  return object_schema({{"id", count_schema(1), "its number in the image of the integrator object"},
                        {"name", name_schema(), "its name, or its pointer"},
                        {"pointer", name_schema(), "a JSON Pointer into the scene"},
                        {"type", name_schema(), "of its shape"}});
}

Value view_schema() {
  return object_schema({{"number", count_schema()},
                        {"name", name_schema()},
                        {"pixel", plain_schema<std::array<int, 2>>({.min = 0})}});
}

Value note_schema() {
  return object_schema({{"pointer", name_schema(), "a JSON Pointer into the scene"},
                        {"about", name_schema(), "what is noted of it"}});
}

Value node_schema(Definitions& named);

Value term_schema(Definitions& named) {
  return object_schema(
      {{"name", plain_schema<TermName>()},
       {"weight", number_schema()},
       {"value", triple_schema(), "linear RGB; weight * value is what the term adds"},
       {"light", name_schema(), "diffuse, specular: the light's name", false},
       {"light_id", count_schema(1), "which of objects it is, where it is one", false},
       {"light_copy", copy_schema(), "which copy of that, as a hit's", false},
       {"distance", nullable_schema(number_schema({.min = 0})), "null where it is infinite", false},
       {"direction", triple_schema(), "towards the light", false},
       {"n_dot_l", number_schema(), "the cosine between normal and direction", false},
       {"visible", number_schema({.min = 0, .max = 1}), "the share of the light that is seen",
        false},
       {"fade", number_schema({.min = 0}), "what distance and direction leave of the light", false},
       {"blocker", nullable_schema(name_schema()), "what takes light first, null: nothing", false},
       {"blocker_id", count_schema(1), "which of objects that is", false},
       {"blocker_copy", copy_schema(), "which copy of that, as a hit's", false},
       {"node", node_schema(named), "reflection, refraction, straight: the ray that follows",
        false}});
}

Value node_schema(Definitions& named) {
  return schema_called("node", named, [&] {
    return object_schema(
        {{"ray", ray_schema(named)},
         {"depth", count_schema(), "how often it has been mirrored or refracted"},
         {"winner", nullable_schema(name_schema()), "what it meets first, null: nothing"},
         {"winner_id", count_schema(1), "which of objects that is", false},
         {"winner_copy", copy_schema(), "which copy of that, as a hit's", false},
         {"terms", list_schema(term_schema(named)), "in the order in which they are added"},
         {"color", triple_schema(), "linear RGB: the sum of the terms"},
         {"t", number_schema(), "of the hit: the distance along the ray", false},
         {"point", triple_schema(), "of the hit", false},
         {"normal", triple_schema(), "of the hit", false},
         {"transmittance", triple_schema(), "what a medium has left of the light on the way",
          false}});
  });
}

}  // namespace

Value explanation_schema(Definitions& named) {
  return schema_called("explanation", named, [&] {
    std::vector<SchemaMember> members{
        {"pixel", plain_schema<std::array<int, 2>>({.min = 0}), "x and y, of a pixel's ray", false},
        {"sample", count_schema(), "which of the pixel's rays", false},
        {"view", view_schema(),
         "of a picture of several views: which of them, what it is called, and the pixel there",
         false},
        {"ray", ray_schema(named), "in double"},
        {"hits", list_schema(hit_schema()), "all along the ray, the nearest first, in double"},
        {"tree", node_schema(named),
         "what makes the colour, in the picture's own arithmetic; not of path", false},
        {"objects", list_schema(object_entry_schema()),
         "all that the others name, each once: names need not be unique, ids and pointers are; "
         "copies of an object share its entry"},
        {"notes", list_schema(note_schema()),
         "what the integrator leaves out of the scene, and the first 20 luminous objects that path "
         "meets by chance alone, for it asks no such shape for light, and no more than 32768 areas "
         "of all objects",
         false}};
    for (SchemaMember& each : paths_schema(named)) members.push_back(std::move(each));
    members.push_back({"mix", list_schema(triple_schema()),
                       "of a view that shares the pixel with others, as an eye's of an anaglyph: "
                       "the rows that make red, green and blue of its colour; the sum is shown",
                       false});
    members.push_back({"others", list_schema(explanation_schema(named)),
                       "what the other views see that share the pixel", false});
    return object_schema(std::move(members));
  });
}

}  // namespace tia
