// Files that come together as a model: which may belong to one, which of them is the model, and the
// text that the SHA-256 of is its id. Source: core/models/bundle.h; RFC 8785.

const MODEL = /\.(gltf|glb|obj|ply|stl)$/i;
const NAMED = /\.(bin|mtl|png|jpe?g|webp)$/i; // what a model's file may name
const CLUTTER = /(^|\/)__MACOSX\//;

/** Of [{ path, file }] what may be a model and what it names; an archive counts where it came alone. */
export function partsOf(files) {
  const parts = files.filter(({ path }) => (MODEL.test(path) || NAMED.test(path)) && !CLUTTER.test(path));
  return files.length === 1 ? files : parts;
}

/** The paths of those that could be the model; none where one came alone, whatever it is called. */
export function modelsAmong(files) {
  return files.length === 1 ? [files[0].path] : files.map(({ path }) => path).filter((path) => MODEL.test(path));
}

/** The files that are sent for the model at `main`: it and what is none, without the folder around them all. */
export function bundleOf(files, main) {
  const sent = files.filter(({ path }) => path === main || !MODEL.test(path));
  const folder = loneFolder(sent.map(({ path }) => path)).length;
  return { files: sent.map(({ path, file }) => ({ path: path.slice(folder), file })), main: main.slice(folder) };
}

function loneFolder([first, ...others]) {
  const same = (i) => others.every((path) => path[i] === first[i]);
  let end = 0;
  while (end < first.length && same(end)) end += 1;
  return first.slice(0, first.lastIndexOf('/', end - 1) + 1);
}

/** The text whose SHA-256 is the id of several files, [{ path, sha256 }]. */
export function bundleText(files, main) {
  const sorted = [...files].sort((a, b) => (a.path < b.path ? -1 : 1)); // by UTF-16 units, as the source has it
  const entries = sorted.map(({ path, sha256 }) => `${JSON.stringify(path)}:"${sha256}"`);
  return `{"files":{${entries.join(',')}},"main":${JSON.stringify(main)}}`;
}
