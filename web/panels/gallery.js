// The gallery: every scene that comes with the server, drawn by it, and any scene by its id.

import { fetchGallery } from '../picture/server.js';
import { queryOf } from '../state/request.js';
import { t } from '../words/words.js';
import { element } from './element.js';
import { showProblem } from './problem_view.js';

const THUMB = { width: 160, height: 120, samples: 1, threshold: 0 };

export async function mountGallery(studio) {
  const place = document.getElementById('scenes');
  const choose = (name) => {
    studio.model.asked = null;
    const { width, height } = studio.model.request;
    studio.open({ scene: name, key: name === 'thesis' ? 'a' : undefined, width, height });
    document.getElementById('hand').focus();
    document.getElementById('frame').scrollIntoView({ block: 'nearest' });
  };
  const typed = element('input', { name: 'scene', spellcheck: 'false', 'aria-label': t('gallery.id') });
  place.after(
    element('form', { class: 'row byid', onsubmit: (event) => {
      event.preventDefault();
      if (typed.value.trim()) choose(typed.value.trim());
    } }, element('label', {}, t('gallery.id'), typed), element('button', { type: 'submit' }, t('gallery.open'))),
    element('p', { class: 'note' }, t('gallery.drop')));
  await new Promise((rested) => studio.model.on('rest', rested)); // the picture comes first
  try {
    const scenes = await fetchGallery();
    place.replaceChildren(element('ul', { class: 'thumbs' }, ...scenes.map((scene) => card(scene, choose))));
    const mark = () => {
      for (const one of place.querySelectorAll('button'))
        one.setAttribute('aria-current', one.dataset.scene === (studio.model.request.scene ?? 'thesis'));
    };
    studio.model.on('want', mark);
    mark();
  } catch (problem) {
    showProblem(problem);
  }
}

// Pictures are drawn for who looks at them: browsers' own laziness begins screens ahead.
const nearing = new IntersectionObserver((entries) => {
  for (const { isIntersecting, target } of entries) {
    if (!isIntersecting) continue;
    target.src = target.dataset.src;
    nearing.unobserve(target);
  }
}, { rootMargin: '200px' });

function card({ name, title, description }, choose) {
  const about = `about-${name}`;
  const picture = element('img', {
    dataset: { src: `render?${queryOf({ scene: name, key: name === 'thesis' ? 'a' : null, ...THUMB })}` },
    alt: '', width: 160, height: 120, decoding: 'async',
  });
  nearing.observe(picture);
  return element('li', {},
    element('button', { type: 'button', dataset: { scene: name }, 'aria-describedby': about, onclick: () => choose(name) },
      picture, element('strong', {}, title)),
    element('p', { id: about, class: 'note' }, description));
}
