#!/usr/bin/env python3
"""Moves each limit by one and runs the test that holds it, which must fail: a limit that can be
moved unseen is none.

  python3 tests/limits.py [NAME...]   those whose name holds a NAME, else all

The moves are all in one build, a copy of the tree in build/limits, each asleep until MOVED_LIMIT
names it: a hundred moves cost one compile, and with none awake every test must pass.
Source: Untch, Offutt and Harrold, "Mutation analysis using mutant schemata" (1993).
By hand: the build takes as long as the release build's, the tests a minute or two.
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COPY = ROOT / "build" / "limits" / "tree"
BUILD = ROOT / "build" / "limits" / "build"
CORE, SERVER = "core_tests", "server_tests"

# file, the declaration with its value between « and », program, the tests that hold it
CONSTANTS = [
    # What a text may be.
    ("core/input/json.h", "depth = «32»", CORE, "LimitNumbers.AJsonTextHas32Levels"),
    ("core/input/json.h", "values = «100'000»", CORE, "LimitNumbers.AJsonTextHas100000Values*"),
    ("core/input/errors.h", "longest_name = «256»", CORE, "Names.*"),
    ("core/input/errors.h", "Bulk::pixels: return «1 << 24»", CORE,
     "LimitNumbers.AnInputHas16777216Pixels*"),
    ("core/input/errors.h", "Bulk::scanned_pixels: return «1 << 27»", CORE,
     "ImageTexture.ScansOfAllPicturesTogetherAreBounded"),
    ("core/input/errors.h", "  return «1 << 25»;\n}\n\n/// Faults", CORE,
     "LimitNumbers.AnInputHas16777216Pixels*"),
    ("core/accel/world/compile.cpp", "few_lights = «64»", CORE, "FewBalls.UnderManyLights*"),
    ("core/input/errors.cpp", "most_edits = «5»", CORE, "NearestName.OfALongName*"),
    ("core/input/errors.h", "most = «20»", CORE, "LimitNumbers.TwentyFaultsAreKept"),
    ("core/input/errors.cpp", "longest_pointer = «512»", CORE, "LimitNumbers.APointerHas512*"),
    ("core/input/errors.cpp", "longest_allowed = «1024»", CORE, "LimitNumbers.APointerHas512*"),
    ("core/input/excerpt.cpp", "longest = «120»", CORE, "LimitNumbers.AFaultEchoes120Bytes"),
    # What a scene may be.
    ("core/film/decode.h", "most_picture_bytes = «1 << 20»", CORE, "LimitNumbers.APictureHas1048576*"),
    ("core/film/decode.h", "most_picture_pixels = «1 << 22»", CORE, "LimitNumbers.APictureHas4194304*"),
    ("core/film/decode.h", "most_picture_scans = «64»", CORE, "LimitNumbers.AJpegHas64*"),
    ("core/film/decode.h", "most_sequential_scans = «8»", CORE, "LimitNumbers.AJpegHas64*"),
    ("core/lights/sky_picture.h", "most_sky_bytes = «8 << 20»", CORE, "LimitNumbers.ASkyHas8388608*"),
    ("core/lights/sky_picture.h", "most_sky_pixels = «1 << 23»", CORE, "LimitNumbers.ASkyHas8388608*"),
    ("core/accel/world/path_lights.h", "most_areas = «1 << 15»", CORE, "LimitNumbers.PathAsks32768*"),
    ("core/accel/world/geometry.h", "most_told = «20»", SERVER, "Explain.NotesTwentyObjects*"),
    ("core/shapes/voxels/voxel_list.h", "most_cell_material = «255»", CORE, "LimitNumbers.OfLargeScenes"),
    ("core/shapes/voxels/voxel_list.h", "most_cells = «1 << 24»", CORE, "LimitNumbers.OfLargeScenes"),
    ("core/shapes/mesh/mesh.h", "most_triangles = «1 << 24»", CORE, "LimitNumbers.OfLargeScenes"),
    ("core/shapes/composite/group.h", "most = «16'777'216»", CORE, "LimitNumbers.AThingIsRepeated*"),
    ("core/lights/sphere_light.h", "most_light_samples = «4096»", CORE, "LimitNumbers.OfLargeScenes"),
    ("core/scene/scene.cpp", "most_lights = «4096»", CORE, "LimitNumbers.ASceneHas4096*"),
    ("core/scene/scene.cpp", "most_suns = «4»", CORE, "LightFaults.FiveSuns*"),
    ("core/scene/sheet.h", "most_views = «64»", CORE, "SheetText.*"),
    ("core/scene/scene.cpp", "most_numbered = «1 << 16»", CORE, "LimitNumbers.ASceneHas65536*"),
    ("core/scene/keys.cpp", "most_patches = «100»", CORE, "LimitNumbers.AScenesKeysHave*"),
    ("core/scene/keys.cpp", "most_bulk = «1 << 27»", CORE, "KeyCheck.CountsThePixels*"),
    ("core/scene/keys.cpp", "most_bytes = «16 << 20»", CORE, "LimitNumbers.AScenesKeysMerge*"),
    ("core/formulas/parse.h", "most_formula_bytes = «4096»", CORE, "LimitNumbers.AFormulaHas4096Bytes"),
    ("core/formulas/parse.h", "most_formula_depth = «100»", CORE, "LimitNumbers.AFormulaHas100*"),
    ("core/formulas/parse.h", "most_formula_cost = «4000»", CORE, "LimitNumbers.AFormulaCosts4000*"),
    ("core/accel/world/all_hits.h", "most_hits = «10'000»", CORE, "LimitNumbers.OfLargeScenes"),
    # What comes over a connection.
    ("server/http/head.h", "most_bytes = «16 << 10»", SERVER, "LimitNumbers.AHeadHas16384Bytes"),
    ("server/http/head.h", "most_fields = «100»", SERVER, "LimitNumbers.AHeadHas100Fields"),
    ("server/http/request_reader.cpp", "longest_target + «64»", SERVER, "LimitNumbers.AFirstLine*"),
    ("server/http/error.h", "longest_target = «4096»", SERVER, "LimitNumbers.ATargetHas4096Bytes"),
    ("server/http/chunks.h", "longest_line = «256»", SERVER, "LimitNumbers.ALineOfAChunks*"),
    ("server/http/chunks.h", "most_trailer = «4096»", SERVER, "LimitNumbers.ATrailerHas4096Bytes"),
    ("server/http/chunks.cpp", "most = «1ULL << 40U»", SERVER, "LimitNumbers.AChunkHas2To40Bytes"),
    ("server/http/timeouts.h", "seconds head{«5»}", SERVER, "LimitNumbers.OfTimeouts"),
    ("server/http/timeouts.h", "seconds body{«5»}", SERVER, "LimitNumbers.OfTimeouts"),
    ("server/http/timeouts.h", "seconds answer{«8»}", SERVER, "LimitNumbers.OfTimeouts"),
    ("server/http/timeouts.h", "seconds idle{«30»}", SERVER, "LimitNumbers.OfTimeouts"),
    ("server/http/timeouts.h", "seconds linger{«2»}", SERVER, "LimitNumbers.OfTimeouts"),
    ("server/http/timeouts.h", "seconds stuck{«1»}", SERVER, "LimitNumbers.OfTimeouts"),
    ("server/http/timeouts.h", "slowest_rate = «64 << 10»", SERVER, "LimitNumbers.OfTimeouts"),
    ("server/http/timeouts.h", "most_requests = «100'000»", SERVER, "LimitNumbers.OfAConnection"),
    ("server/http/request_reader.h", "longest_held_body = «1 << 20»", SERVER,
     "LongBody.OfAMegabyteStaysInMemory"),
    ("server/http/timeouts.h", "most_ahead = «64 << 10»", SERVER, "LimitNumbers.OfAConnection"),
    ("server/http/timeouts.h", "most_at_once = «256 << 10»", SERVER, "LimitNumbers.OfAConnection"),
    ("server/http/timeouts.h", "most_parts = «256 << 10»", SERVER, "LimitNumbers.OfAConnection"),
    # What is answered, kept and told.
    ("server/contract/problem.h", "longest_problem = «16 << 10»", SERVER, "LimitNumbers.OfWhatIsAnswered*"),
    ("server/contract/problem.cpp", "longest_detail = «2048»", SERVER, "LimitNumbers.AProblemsDetail*"),
    ("core/render/explanation_size.h", "longest_explanation = «4 << 20»", SERVER,
     "LimitNumbers.OfWhatIsAnswered*"),
    ("server/requests/recipe.h", "most_told_bytes = «256 << 10»", SERVER, "LimitNumbers.ARecipeTells*"),
    ("server/stores/known_targets.h", "most_bytes = «4 << 20»", SERVER, "LimitNumbers.OfWhatIsAnswered*"),
    ("server/stores/scene_store.h", "most_scenes = «10'000»", SERVER, "LimitNumbers.TenThousandScenes*"),
    ("server/stores/scene_file.h", "most_owners = «64»", SERVER, "LimitNumbers.OfWhatIsAnswered*"),
    ("server/operation/log.h", "most_bytes = «1 << 20»", SERVER, "LimitNumbers.OfAConnection"),
    ("server/operation/log.cpp", "most_target = «200»", SERVER, "Log.*"),
    ("server/operation/metrics.cpp", "most_keys = «100»", SERVER, "Keys.HaveMetricsOfTheirOwn*"),
    # What waits for what.
    ("server/operation/cost.h", "most_light_rays = «1 << 21»", SERVER,
     "LimitNumbers.LightWorkTurnsOutHeavy*"),
    ("server/operation/admission.h", "most_light_tests = «1 << 25»", SERVER,
     "LimitNumbers.LightWorkTurnsOutHeavy*"),
    ("server/operation/admission.h", "longest_short_text = «64 << 10»", SERVER,
     "LimitNumbers.AShortTextHas65536Bytes"),
    ("server/operation/cost_memory.h", "most_scenes = «4096»", SERVER, "LimitNumbers.OfWhatIsAnswered*"),
    ("server/operation/memory_account.h", "most_wait{«2»}", SERVER, "LimitNumbers.OfTimeouts"),
    ("server/operation/memory_account.h", "program_bytes = «64 << 20»", SERVER,
     "OptionLimits.ARequest*"),
]
# Options, which a test sets and then meets and passes by one. Not those of time, which no test can
# tell to a millisecond, and not max_data_bytes, which counts in pages of the database, nor
# model_memory_bytes, of which a process takes pages.
OPTIONS = [
    ("renders", SERVER, "OptionLimits.AsManyPictures*"),
    ("queue", SERVER, "OptionLimits.AsManyWait*"),
    ("connections", SERVER, "OptionLimits.AsManyConnections*"),
    ("max_body_bytes", SERVER, "OptionLimits.ABody*"),
    ("max_png_bytes", SERVER, "OptionLimits.ABody*"),
    ("max_nodes", SERVER, "OptionLimits.AText*"),
    ("max_scenes_bytes", SERVER, "OptionLimits.AScene*"),
    ("max_geometry_bytes", SERVER, "OptionLimits.ACompiledScene*"),
    ("cache_bytes", SERVER, "OptionLimits.APictureIsKept*"),
    ("max_model_bytes", SERVER, "OptionLimits.AModelMayHaveMaxModelBytes*"),
    ("max_models_bytes", SERVER, "OptionLimits.AModelIsKept*"),
    ("max_triangles", SERVER, "OptionLimits.AModelMayHaveMaxTriangles"),
    ("max_texture_pixels", SERVER, "OptionLimits.AModelsTextures*"),
    ("max_pixels", SERVER, "RenderLimits.MaxPixels*"),
    ("max_rays", SERVER, "RenderLimits.*Rays*"),
    ("max_work", SERVER, "OptionLimits.APictureMayTake*"),
    ("max_events", SERVER, "OptionLimits.AMotionMayHave*"),
    ("max_frames", SERVER, "FilmLimits.Frames*"),
    ("max_job_rays", SERVER, "JobLimits.Rays*"),
    ("max_jobs", SERVER, "JobLimits.Unfinished*"),
    ("memory_bytes", SERVER, "OptionLimits.ARequest*"),
]

MOVED = """#pragma once
#include <cstdlib>
#include <string_view>
namespace tia {
/// 1 for the limit that the environment names, else 0.
inline int moved(std::string_view limit) {
  const char* const name = std::getenv("MOVED_LIMIT");
  return name != nullptr && name == limit ? 1 : 0;
}
/// Visitor: moves the option that the environment names.
template <class Config>
struct Mover {
  Config& config;
  template <class Member, class Spec>
  void operator()(std::string_view name, Member Config::*member, const Spec&) const {
    if constexpr (std::is_integral_v<Member>) config.*member += moved(name);
  }
};
template <class Config>
Config with_moved_option(Config config) {
  Config::fields(Mover<Config>{config});
  return config;
}
}  // namespace tia
"""
# Where options begin to count: in a test's own house, and in the program.
OPTION_PLACES = [
    ("server/handlers/backend.cpp", "config(given),", "config(with_moved_option(given)),"),
    ("server/serve_command.cpp", "HttpOptions http_options(const Config& config) {",
     "HttpOptions http_options(const Config& given) {\n"
     "  static const Config config = with_moved_option(given);"),
]

# What the compiler must know no more, because it is made of what moves.
DEPENDENT = [
    ("core/input/errors.h", "constexpr std::int64_t most_of(", "inline std::int64_t most_of("),
    ("core/input/value_codecs.h", "inline constexpr Spec name_spec", "inline const Spec name_spec"),
    ("core/lights/sky_picture.h", "inline constexpr PictureLimits sky_picture_limits",
     "inline const PictureLimits sky_picture_limits"),
    ("core/lights/sphere_light.h", "inline constexpr Spec light_samples",
     "inline const Spec light_samples"),
    ("server/operation/cost.h", "static constexpr double most_light_seconds",
     "static inline const double most_light_seconds"),
    ("server/stores/scene_store.cpp", "constexpr JsonLimits any", "const JsonLimits any"),
]


def name_of(file, declaration):
    """server/http/head.h, "most_bytes = «16 << 10»" -> server/http/head.h:most_bytes"""
    before = declaration.split("«")[0]
    words = re.findall(r"\w+", before)
    return f"{file}:{words[-1] if words else declaration.strip(' :;«»')}"


def awake(text, declaration, name):
    """The text in which that value can move, and is no constant of the compiler's any more."""
    head, value, tail = re.split("[«»]", declaration)
    whole = head + value + tail
    if text.count(whole) != 1:
        sys.exit(f"{name}: {whole!r} stands there {text.count(whole)} times")
    at = text.index(whole)
    begin = max(text.rfind(";", 0, at), text.rfind("{\n", 0, at), text.rfind("}\n", 0, at)) + 1
    statement = text[begin:at]
    if "return" in statement:
        statement = statement.replace("constexpr", "inline")
    statement = statement.replace("static constexpr", "static inline const")
    statement = statement.replace("constexpr", "const")
    return (text[:begin] + statement + head + f'(({value}) + ::tia::moved("{name}"))' + tail +
            text[at + len(whole):])


def rewritten(files):
    """Writes what has changed into the copy: else all would be compiled again."""
    for file, text in files.items():
        to = COPY / file
        if not to.exists() or to.read_text() != text:
            to.parent.mkdir(parents=True, exist_ok=True)
            to.write_text(text)


def make_copy():
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, check=True,
                            capture_output=True, text=True).stdout.split("\n")
    changed = {}

    def text_of(file):
        return changed.get(file) or '#include "tests/moved.h"\n' + (ROOT / file).read_text()

    for file, declaration, *_ in CONSTANTS:
        changed[file] = awake(text_of(file), declaration, name_of(file, declaration))
    for file, old, new in OPTION_PLACES + DEPENDENT:
        text = text_of(file)
        if text.count(old) != 1:
            sys.exit(f"{file}: {old!r} stands there {text.count(old)} times")
        changed[file] = text.replace(old, new)
    changed["tests/moved.h"] = MOVED
    rewritten(changed)
    for old in [each for each in COPY.rglob("*") if each.is_file()]:
        name = str(old.relative_to(COPY))
        if name not in listed and name not in changed:
            old.unlink()
    for file in listed:
        if not file or file in changed or not (ROOT / file).is_file():
            continue
        to = COPY / file
        if not to.exists() or to.read_bytes() != (ROOT / file).read_bytes():
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / file, to)


def build():
    subprocess.run(["cmake", "--preset", "release", "-B", BUILD, "-DCMAKE_BUILD_TYPE=None",
                    "-DCMAKE_CXX_FLAGS=-O1 -DNDEBUG -w"], cwd=COPY, check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", BUILD, "--target", "tia", CORE, SERVER, "--", "-k0"],
                   cwd=COPY, check=True)


def passes(program, tests, moved=""):
    """Whether some of the tests run, and none of them fails."""
    done = subprocess.run([BUILD / "tests" / program, "--gtest_filter=" + tests, "--gtest_brief=1"],
                          cwd=COPY, env={**os.environ, "MOVED_LIMIT": moved}, capture_output=True,
                          text=True, errors="replace", timeout=600)
    if not re.search(r"\[==========\] [1-9]\d* tests? from", done.stdout) and done.returncode == 0:
        return None
    return done.returncode == 0


def main():
    make_copy()
    build()
    rows = [(name_of(file, declaration), *rest) for file, declaration, *rest in CONSTANTS]
    rows += OPTIONS
    wanted = sys.argv[1:]
    rows = [row for row in rows if not wanted or any(each in row[0] for each in wanted)]
    unseen = []
    for name, program, tests in rows:
        unmoved = passes(program, tests)
        seen = unmoved and passes(program, tests, name) is False
        what = "seen" if seen else "NO TEST" if unmoved is None else \
               "FAILS UNMOVED" if not unmoved else "UNSEEN"
        print(f"{what:14} {name}  ({tests})", flush=True)
        if not seen:
            unseen.append(name)
    print(f"{len(rows) - len(unseen)} passed, {len(unseen)} failed")
    return 1 if unseen else 0


if __name__ == "__main__":
    sys.exit(main())
