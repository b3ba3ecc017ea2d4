// Comparing the picture: with one kept before, or with an image of what lies behind it.

import { plain } from '../picture/passes.js';
import { fetchPicture } from '../picture/server.js';
import { finalPicture } from '../studio/studio.js';
import { windowOf } from '../state/window.js';
import { lampWords, t, wordsOr } from '../words/words.js';
import { compareForm } from './compare_form.js';
import { differenceView, slidingView } from './compare_views.js';
import { cover, imageOf, stale, uncover } from './cover.js';
import { showProblem } from './problem_view.js';

function sizeWords(request) {
  const { width, height } = windowOf(request);
  return `${width} \u00d7 ${height}`;
}

export default function mountCompare(studio, panel) {
  const { model } = studio;
  const goBack = () => studio.open(kept.request, kept.source);
  const form = compareForm({ keep, clear, goBack, change: show, slide });
  const slider = slidingView((share) => form.slide(share));
  const difference = differenceView();
  let kept = null; // { blob, request, source, image, words }
  let feature = null; // { image, abort }
  panel.append(...form.nodes);

  async function keep() {
    const { source } = model;
    const words = lampWords(model.request, studio.light);
    const picture = await wanted(() => finalPicture(studio));
    const image = picture && await wanted(() => imageOf(picture.blob));
    if (!image) return;
    forget(kept);
    kept = { blob: picture.blob, request: picture.request, source, words, image };
    kept.image.alt = t('compare.a');
    form.kept(kept);
    form.choose('kept');
  }

  function clear() {
    forget(kept);
    kept = null;
    form.kept(null);
    form.choose('none');
  }

  // Somebody else covers the picture.
  function leave() {
    form.choose('none');
  }

  function slide(share) {
    slider.place(share);
  }

  function show() {
    const { partner, mode, factor } = form.state;
    dropFeature();
    form.tell('');
    if (partner === 'none') uncover(leave);
    else if (partner !== 'kept') showFeature(partner);
    else if (mode === 'difference') showDifference(factor);
    else showSlider(kept.image, t('compare.a'));
  }

  function showSlider(image, name) {
    slider.left(image);
    slider.name(name, t('compare.now'));
    slider.place(form.state.share);
    cover(leave, ...slider.nodes);
    if (form.state.partner === 'kept') tellSizes();
  }

  function tellSizes() {
    const [a, now] = [kept.request, model.shown.request].map(sizeWords);
    const same = a === sizeWords(studio.final);
    form.tell(same ? '' : t('compare.sizes', { a, now }));
    return same && a === now;
  }

  async function showDifference(factor) {
    if (!tellSizes()) return uncover(leave);
    const told = await wanted(() => difference.draw(kept.blob, model.shown.blob, factor));
    const { partner, mode } = form.state;
    if (!told || partner !== 'kept' || mode !== 'difference') return;
    form.tell(difference.words(told));
    cover(leave, difference.node);
  }

  // The image is drawn of what is wanted, once that rests.
  async function showFeature(integrator) {
    const mine = (feature = { abort: new AbortController() });
    const request = { ...plain(model.request, model.source?.options), integrator };
    const picture = await wanted(() => fetchPicture(request, mine.abort.signal));
    const image = picture && await imageOf(picture.blob);
    if (feature !== mine) return image && URL.revokeObjectURL(image.src);
    mine.image = image;
    if (!image) return;
    image.alt = wordsOr(`compare.${integrator}`, integrator);
    showSlider(image, image.alt);
  }

  function dropFeature() {
    feature?.abort.abort();
    forget(feature);
    feature = null;
  }

  async function wanted(ask) {
    try {
      return await ask();
    } catch (problem) {
      if (problem.name !== 'AbortError') showProblem(problem);
      return null;
    }
  }

  model.on('want', () => (form.state.partner !== 'kept' || form.state.mode === 'difference') && stale(leave));
  model.on('rest', () => form.state.partner !== 'none' && show());
}

function forget(one) {
  if (one?.image) URL.revokeObjectURL(one.image.src);
}
