// Other ways to see the picture: for red and blue glasses, as a display of many views, all around, and
// with as many rays as an eye can use.

import { fetchPicture } from '../picture/server.js';
import { Latest } from '../studio/latest.js';
import { t } from '../words/words.js';
import { cover, imageOf, stale, uncover } from './cover.js';
import { element } from './element.js';
import { showProblem } from './problem_view.js';
import { anaglyph, panorama, quilt } from './views_flat.js';
import { gaze } from './views_gaze.js';
import { look } from './views_look.js';
import { wiggle } from './views_wiggle.js';

export const style = 'panels/views.css';

/**
 * What can be chosen. A way of seeing is made of a stage and has `name`, `request(base)`, `show(image, picture)`,
 * which gives the nodes to lay over the picture, and may have `controls` for the panel and `begin()`.
 */
const WAYS = [anaglyph, quilt, wiggle, panorama, look, gaze];

export default function mountViews(studio, panel) {
  const { model } = studio;
  const told = element('p', { class: 'told', role: 'status' });
  const about = element('p', { class: 'note' });
  const controls = element('div', { class: 'view-controls' });
  const again = () => way && latest.ask(way);
  const stage = { studio, again, tell: (words) => (told.textContent = words), cover: (...nodes) => cover(leave, ...nodes) };
  const ways = WAYS.map((make) => make(stage));
  const latest = new Latest(draw, showProblem);
  let way = null;
  let image = null; // that lies over the picture

  const radio = (name, chosen) => element('label', {}, element('input', { type: 'radio', name: 'view-way', value: name,
    checked: name === 'flat', onchange: () => choose(chosen) }), t(`views.${name}`));
  const choices = element('fieldset', { class: 'choices' }, element('legend', {}, t('views.ways')),
    radio('flat', null), ways.map((one) => radio(one.name, one)));
  panel.append(choices, about, controls, told);

  function choose(chosen) {
    way = chosen;
    told.textContent = '';
    about.textContent = way ? t(`views.about_${way.name}`) : '';
    controls.replaceChildren(...(way?.controls ?? []));
    latest.leave();
    if (!way) return uncover(leave);
    way.begin?.();
    again();
  }

  // Somebody else covers the picture.
  function leave() {
    way = null;
    latest.leave();
    controls.replaceChildren();
    about.textContent = '';
    choices.querySelector('input').checked = true;
  }

  async function draw(mine, signal) {
    const base = studio.inScene.scene ? { ...studio.final, ...(model.request.model && studio.inScene) } : studio.final;
    const picture = await fetchPicture(mine.request(base), signal);
    const next = await imageOf(picture.blob);
    if (way !== mine) return URL.revokeObjectURL(next.src);
    if (image) URL.revokeObjectURL(image.src);
    image = next;
    image.alt = t(`views.${mine.name}`);
    cover(leave, ...[mine.show(image, picture)].flat());
  }

  // The gallery opens some scenes in one of these ways, once they are known.
  function arrive() {
    const opened = ways.find(({ name }) => name === studio.way);
    studio.way = null;
    if (!opened) return again();
    choices.querySelector(`[value=${opened.name}]`).checked = true;
    choose(opened);
  }

  model.on('want', () => way && stale(leave));
  model.on('rest', arrive);
  if (model.world) arrive();
}
