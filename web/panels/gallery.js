// The gallery: every scene that comes with the server, drawn by it, and any scene by its id.

import { fetchGallery } from '../picture/server.js';
import { opened, queryOf } from '../state/request.js';
import { t } from '../words/words.js';
import { element } from './element.js';
import { showProblem } from './problem_view.js';

const THUMB = { width: 160, height: 120, samples: 1, threshold: 0 };

// Scenes as the panel of views shows them, by the name of its way.
const QUILT = { width: 54, height: 40, camera: { display: { type: 'quilt', columns: 3, rows: 3 } } };
const SEEN = [
  { name: 'trefoil', way: 'quilt', thumb: QUILT, title: 'A quilt of the trefoil', description: 'Views from left to right, as a holographic display gets them.' },
  { name: 'voxels', way: 'quilt', thumb: QUILT, title: 'A quilt of the lighthouse', description: 'What is before the tower and behind it moves from view to view.' },
  { name: 'barth', way: 'gaze', thumb: { gaze: [80, 60] }, title: 'Barth\u2019s sextic for one gaze', description: 'Sharp where the eye looks, from a tenth of the rays; rings show how far from there.' },
];

export function mountGallery(studio) {
  const place = document.getElementById('scenes');
  const choose = (name, way) => {
    studio.model.asked = null;
    studio.way = way;
    const { width, height } = studio.model.request;
    studio.open({ ...opened(name), width, height });
    if (way) studio.openTab('tab-views');
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
  const mark = () => {
    const { model, scene = 'thesis' } = studio.model.request;
    for (const one of place.querySelectorAll('button'))
      one.setAttribute('aria-current', !model && one.dataset.scene === scene);
  };
  studio.model.on('want', mark);

  // The picture comes first. Where there is none, the gallery is the way on.
  let asked = false;
  const fill = async (trouble) => {
    if (asked) return;
    asked = true;
    try {
      const scenes = [...await fetchGallery(), ...SEEN];
      place.replaceChildren(element('ul', { class: 'thumbs' }, ...scenes.map((scene) => card(scene, choose))));
      mark();
    } catch (problem) {
      asked = false; // until the next picture
      trouble(problem);
    }
  };
  studio.model.on('rest', () => fill(showProblem));
  studio.model.on('fail', () => fill(() => {})); // that is told already
}

// Pictures are drawn for who looks at them: browsers' own laziness begins screens ahead.
const nearing = new IntersectionObserver((entries) => {
  for (const { isIntersecting, target } of entries) {
    if (!isIntersecting) continue;
    target.src = target.dataset.src;
    nearing.unobserve(target);
  }
}, { rootMargin: '200px' });

function card({ name, title, description, way, thumb }, choose) {
  const about = `about-${name}${way ?? ''}`;
  const picture = element('img', {
    dataset: { src: `render?${queryOf({ ...opened(name), ...THUMB, ...thumb })}` },
    alt: '', width: 160, height: 120, decoding: 'async',
  });
  nearing.observe(picture);
  return element('li', {},
    element('button', { type: 'button', dataset: way ? { way } : { scene: name }, 'aria-describedby': about, onclick: () => choose(name, way) },
      picture, element('strong', { lang: 'en' }, title)),
    element('p', { id: about, class: 'note', lang: 'en' }, description));
}
