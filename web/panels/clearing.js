// Below a picture that clears up by chance: how far it is, in words; pausing it; taking its noise off,
// and a line between noisy and not. Loaded with the first such picture.

import { pixelsOf as codesOf } from '../picture/difference.js';
import { errorsOf } from '../picture/errors.js';
import { isOfPaths, samplesOf } from '../picture/passes.js';
import { fetchPicture } from '../picture/server.js';
import { countOf } from '../picture/timing.js';
import { queryOf } from '../state/request.js';
import { pixelsOf } from '../state/window.js';
import { countWords, numberWords, t } from '../words/words.js';
import { slidingView } from './compare_views.js';
import { cover, imageOf, uncover } from './cover.js';
import { element } from './element.js';

const TOLD = [1 / 4, 1 / 2, 1]; // of the samples: then they are told aloud
const noisyOf = (request) => ({ ...request, denoise: null });

/** Fills `place`. */
export function mountClearing(studio, place) {
  const { model } = studio;
  const noise = noiseMeter();
  const words = element('p');
  const said = element('p', { class: 'spoken', role: 'status' });
  const bar = element('progress', { 'aria-label': t('clearing.bar') });
  const pause = element('button', { type: 'button', onclick: press });
  const denoise = element('input', { type: 'checkbox', role: 'switch',
    onchange: () => model.change({ denoise: denoise.checked || null }) });
  const switching = element('label', { class: 'check' }, denoise, t('clearing.denoise'));
  const line = noisyLine(studio);
  place.replaceChildren(pause, bar, switching, words, line.node, said);
  let [going, done] = [true, false];
  let told = 0;
  let measured = null; // what is shown, once it is

  function press() {
    if (going) studio.pause();
    else if (studio.paused) studio.goOn();
  }

  function draw() {
    const { request, source, asked } = model;
    const all = samplesOf(request, source?.options);
    place.hidden = Boolean(asked) || !isOfPaths(request, source?.options) || all < 2;
    if (place.hidden) return line.draw(false);
    const had = samplesShown(model);
    words.textContent = stateWords(had, all);
    [bar.max, bar.value] = [all, done ? all : had];
    pause.textContent = t(studio.paused ? 'clearing.goOn' : 'clearing.pause');
    pause.setAttribute('aria-disabled', !going && !studio.paused);
    denoise.checked = Boolean(request.denoise);
    line.draw(done);
  }

  function stateWords(had, all) {
    const samples = { samples: countWords(had), all: countWords(all) };
    const shown = model.shown?.request;
    return [t(done ? 'clearing.done' : 'clearing.going', samples), studio.paused && t('clearing.paused'),
      shown?.denoise && !going ? t('clearing.noNoise') : noise.percent > 0 && t('clearing.noise', { noise: numberWords(noise.percent, 2) }),
    ].filter(Boolean).join(', ');
  }

  // Not each round: those who listen have the picture before the hundredth.
  function tell() {
    const share = samplesShown(model) / samplesOf(model.request, model.source?.options);
    const due = TOLD.filter((each) => share >= each).length;
    if (going && due > told && due < TOLD.length) say();
    told = Math.max(told, due);
  }
  const say = () => !place.hidden && (said.textContent = words.textContent);

  async function came() {
    const { shown } = model;
    draw();
    await (measured = noise.take(shown, samplesShown(model)));
    if (shown !== model.shown) return;
    draw();
    tell();
  }

  async function settle(event) {
    [going, done] = [false, event === 'rest'];
    draw();
    await measured;
    if (going) return;
    draw();
    if (event === 'pause' || said.textContent) say();
  }

  model.on('want', () => {
    [going, done] = [true, false];
    if (!studio.paused) [told, said.textContent] = [0, ''];
    draw();
  });
  model.on('show', came);
  for (const event of ['rest', 'fail', 'pause']) model.on(event, () => settle(event));
  for (const event of ['source', 'ask']) model.on(event, draw);
  came();
}

function samplesShown({ shown, request }) {
  const pixels = pixelsOf(request);
  return shown && pixelsOf(shown.request) === pixels ? Math.floor(countOf(shown.rays, 'primary') / pixels) : 0;
}

// The noise of what is shown, in hundredths of white, by how far it is from the round before it.
function noiseMeter() {
  let before = null; // { samples, blob, of }
  const read = async (blob) => (await codesOf(blob)).data;
  const matterOf = ({ request }) => queryOf({ ...request, samples: null, threshold: null });
  const meter = { percent: 0, async take(shown, samples) {
    const now = samples > 1 && !shown.request.denoise ? { samples, blob: shown.blob, of: matterOf(shown) } : null;
    const pair = [before, now];
    if (now) before = now;
    const fits = pair.every(Boolean) && pair[0].of === now.of && pair[0].samples < samples;
    if (!fits) return pair[0]?.of === now?.of || (meter.percent = 0);
    const errors = await errorsOf(pair, read);
    meter.percent = 100 * errors[1].error;
  } };
  return meter;
}

// The line between the noisy picture on the left and the one whose noise is taken off: both are there
// before it can be moved.
function noisyLine(studio) {
  const { model } = studio;
  const view = slidingView((share) => slide(share));
  const range = element('input', { type: 'range', min: 0, max: 100, value: 0,
    oninput: () => slide(range.valueAsNumber / 100) });
  const node = element('label', { class: 'wide', hidden: true }, t('clearing.line'), range);
  let noisy = null; // { of, blob, image }
  let asking = null;
  const leave = () => place(0);

  function place(share) {
    range.value = Math.round(100 * share);
    range.setAttribute('aria-valuetext', t('clearing.share', { share: range.value }));
    view.place(share);
  }

  function slide(share) {
    place(share);
    if (share === 0 || node.hidden) return uncover(leave);
    view.left(noisy.image);
    view.name(t('clearing.noisy'), t('clearing.denoised'));
    cover(leave, ...view.nodes);
  }

  async function keep(of, blob) {
    const image = await imageOf(blob);
    image.alt = t('clearing.noisy');
    if (noisy) URL.revokeObjectURL(noisy.image.src);
    noisy = { of, image };
  }

  // At rest: `resting` tells whether what is shown is the picture wanted.
  async function draw(resting) {
    const { shown } = model;
    const of = shown && queryOf(noisyOf(shown.request));
    const there = noisy?.of === of;
    const has = resting && Boolean(shown.request.denoise);
    node.hidden = !(has && there);
    if (node.hidden) uncover(leave);
    else if (range.valueAsNumber) slide(range.valueAsNumber / 100);
    if (asking && (asking.of !== of || !resting)) asking = void asking.abort.abort();
    if (!resting || there || asking) return;
    const mine = (asking = { of, abort: new AbortController() });
    const blob = has ? await blobOf(shown.request, mine.abort.signal) : shown.blob;
    if (blob && asking === mine) await keep(of, blob);
    if (asking !== mine) return;
    asking = null;
    if (blob && has) draw(true);
  }

  const blobOf = (request, signal) => fetchPicture(noisyOf(request), signal).then(({ blob }) => blob)
    .catch((problem) => void (problem.name !== 'AbortError' && console.warn(problem.message)));

  place(0);
  return { node, draw };
}
