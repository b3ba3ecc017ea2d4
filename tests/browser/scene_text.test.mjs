// The scene's text: reading it with places, laying it out, changing one value.

import { test } from 'node:test';
import { gallery, sceneStage } from './scene_stage.mjs';

const on = sceneStage();
const shared = on.shared(() => {}, { tab: false }); // what is called leaves no trace
const texts = Object.values(gallery());
const small = texts.filter((text) => text.length < 20_000);

const TOOLS = `
  const random = (seed) => () => ((seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32);
  const check = (holds, ...words) => { if (!holds) throw new Error(words.join(' ')); };
  const sorted = (value) => JSON.stringify(value, (_, one) => one && typeof one === 'object' && !Array.isArray(one)
    ? Object.fromEntries(Object.entries(one).sort(([a], [b]) => (a < b ? -1 : 1))) : one);`;

// Runs `work(modules, ...given)` with the page's own modules, in the browser that runs them.
const inPage = (work, ...given) => shared((page) => page.evaluate(`(async () => {${TOOLS}
  const modules = await Promise.all(['/state/scene_text.js', '/state/scene_history.js'].map((it) => import(it)));
  return (${work})(Object.assign({}, ...modules), ...${JSON.stringify(given)});
})()`));

test('every scene of the gallery reads as JSON.parse reads it, each value at its place', () =>
  inPage(({ parseScene, valueAt }, all) => {
    for (const text of all) {
      const { value, places, faults } = parseScene(text);
      check(JSON.stringify(value) === JSON.stringify(JSON.parse(text)) && !faults.length, text.slice(0, 40));
      const lines = text.split('\n');
      for (const [pointer, { start, end, line, column }] of places) {
        check(JSON.stringify(JSON.parse(text.slice(start, end))) === JSON.stringify(valueAt(value, pointer)), pointer);
        check(lines.slice(0, line - 1).join('\n').length + (line > 1) + column - 1 === start, 'place of', pointer);
        if (text.length > 100_000) break;
      }
    }
  }, texts));

test('laying out changes nothing that a scene means, fills lines and is stable', () =>
  inPage(({ parseScene, formatScene }, all) => {
    for (const text of all) {
      const laid = formatScene(JSON.parse(text));
      check(sorted(JSON.parse(laid)) === sorted(JSON.parse(text)), 'meaning');
      check(formatScene(parseScene(laid).value) === laid, 'stable');
      const long = laid.split('\n').filter((line) => line.length > 84 && !/"[^"]{30,}"/.test(line));
      check(!long.length, 'too long:', long[0]);
    }
  }, texts));

test('a value put in is the JSON patch, and all other letters stay', () =>
  inPage(({ parseScene, withValue, valueAt, tokens, difference }, all) => {
    const next = random(7);
    const values = [3.25, 'x"\u00e9', null, true, [1, 2, 3], { a: [1], b: {} }, []];
    for (const text of all) for (let i = 0; i < 40; i += 1) {
      const { places, value } = parseScene(text);
      const pointers = [...places.keys()].slice(1);
      const pointer = pointers[Math.floor(next() * pointers.length)];
      const put = values[Math.floor(next() * values.length)];
      const { start, end } = places.get(pointer);
      const out = withValue(text, pointer, put);
      check(out.startsWith(text.slice(0, start)) && out.endsWith(text.slice(end)), 'outside of', pointer);
      const patched = structuredClone(value);
      const names = tokens(pointer);
      valueAt(patched, pointer.slice(0, pointer.lastIndexOf('/')))[names.at(-1)] = put;
      check(sorted(JSON.parse(out)) === sorted(patched), pointer, out);
      const gone = withValue(text, pointer, undefined);
      const parent = valueAt(patched, pointer.slice(0, pointer.lastIndexOf('/')));
      if (Array.isArray(parent)) parent.splice(names.at(-1), 1);
      else delete parent[names.at(-1)];
      check(sorted(JSON.parse(gone)) === sorted(patched), 'without', pointer, gone);
      check(difference(text, gone).added === '', 'only taken away', pointer);
    }
  }, small));

test('what is missing is added, with the way to it, in the layout around it', () =>
  inPage(({ withValue, parseScene, formatScene, difference }, all) => {
    const cases = [
      ['{\n  "a": 1\n}', '/b', 2, '{\n  "a": 1,\n  "b": 2\n}'],
      ['{"a":1}', '/b', [1, 2], '{"a":1,"b":[1,2]}'],
      ['{ "a": 1 }', '/b/c', [1, 2], '{ "a": 1, "b": { "c": [1, 2] } }'],
      ['{}', '/a/0', 'x', '{ "a": ["x"] }'],
      ['{\n}', '/a', {}, '{\n  "a": {}\n}'],
      ['{ "l": [\n    1,\n    2\n  ] }', '/l/-', 3, '{ "l": [\n    1,\n    2,\n    3\n  ] }'],
      ['{ "l": [ ] }', '/l/0', 3, '{ "l": [3] }'],
      ['{ "a/b": { "~": 1 } }', '/a~1b/~0', 2, '{ "a/b": { "~": 2 } }'],
      ['{ "v": [ 1,2,  3 ] }', '/v', [1, 5, 3], '{ "v": [ 1,5,  3 ] }'],
      ['{ "a": 1.0 }', '/a', 1, '{ "a": 1.0 }'],
      ['{ "a": "x" }', '/a/b', 1, '{ "a": "x" }'],
      ['{ "a": ', '/a', 1, '{ "a": '],
    ];
    for (const [text, pointer, value, wanted] of cases) {
      const out = withValue(text, pointer, value);
      check(out === wanted, text, pointer, 'gave', out);
    }
    for (const text of all) {
      const out = withValue(text, '/objects/-', { type: 'sphere', center: [0, 1, 2], radius: 3 });
      const grown = JSON.parse(text);
      grown.objects.push({ type: 'sphere', center: [0, 1, 2], radius: 3 });
      check(sorted(JSON.parse(out)) === sorted(grown) && difference(text, out).removed === '', text.slice(0, 60));
    }
  }, small));

test('broken texts are told, whatever is broken, where the first break is', () =>
  inPage(({ parseScene, formatScene }, all) => {
    const next = random(11);
    for (const text of all) for (let i = 0; i < 60; i += 1) {
      const at = Math.floor(next() * text.length);
      const broken = text.slice(0, at) + text.slice(at + 1 + Math.floor(next() * 3));
      const { value, faults } = parseScene(broken);
      let fine = true;
      try { JSON.parse(broken); } catch { fine = false; }
      const twice = faults.some(({ reason }) => reason === 'twice');
      check(fine ? twice || !faults.length : faults.length > 0, broken.slice(at - 20, at + 20));
      check((value === undefined) === faults.length > 0);
      const lines = broken.split('\n');
      for (const { line, column, offset } of faults) {
        check(line >= 1 && line <= lines.length && column >= 1 && column <= lines[line - 1].length + 1, line, column);
        check(lines.slice(0, line - 1).join('\n').length + (line > 1) + column - 1 === offset, 'offset', line, column, offset);
      }
    }
  }, small));

test('each break has its reason and place', () =>
  inPage(({ parseScene }) => {
    const cases = {
      '{"a":1,}': 'trailing 1:7', '{"a" 1}': 'colon 1:6', '{"a":01}': 'number 1:6', '{"a":"x\n"}': 'string 1:6',
      '[1,\n2': 'open 1:1', '{"a":1\n "b":2}': 'comma 2:2', '{"a":tru}': 'word 1:6', '': 'value 1:1', '{"a":1}\nx': 'after 2:1',
      '{"a":1,\n"a":2}': 'twice 2:1', '{"a":"\\q"}': 'escape 1:7', "{'a':1}": 'name 1:2', '{"a":1e999}': 'number 1:6',
      '{"a":}': 'value 1:6',
    };
    cases['['.repeat(200)] = 'deep 1:102';
    for (const [text, wanted] of Object.entries(cases)) {
      const [{ reason, line, column }] = parseScene(text).faults;
      check(`${reason} ${line}:${column}` === wanted, text, 'gave', reason, line, column);
    }
  }));

test('undo and redo walk the same texts, and what follows at once is one step', () =>
  inPage(({ History }) => {
    const history = new History();
    const next = random(3);
    history.begin('{"a": 1}');
    const steps = [history.text];
    for (let i = 0; i < 200; i += 1) {
      const at = Math.floor(next() * steps.at(-1).length);
      const text = `${steps.at(-1).slice(0, at)}${'ab\n'[i % 3]}${steps.at(-1).slice(at + (i % 2))}`;
      history.record(text, null);
      if (text !== steps.at(-1)) steps.push(text);
    }
    for (const text of steps.toReversed().slice(1)) { history.undo(); check(history.text === text, 'undo'); }
    check(!history.canUndo && history.undo() === null);
    for (const text of steps.slice(1)) { history.redo(); check(history.text === text, 'redo'); }
    history.begin('');
    history.record('a', 'typing', 0);
    history.record('ab', 'typing', 500);
    history.record('abc', 'typing', 1600);
    history.undo();
    check(history.text === 'ab', history.text);
    history.undo();
    check(history.text === '' && history.canRedo, history.text);
  }));

