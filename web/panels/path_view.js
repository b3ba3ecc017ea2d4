// The lamp on its way: a film of still pictures, played here and saved as one animated picture. Loaded
// when its panel is first opened.

import { Problem } from '../picture/problem.js';
import { circlePath, curvePath } from '../space/light_path.js';
import { fileName, queryOf } from '../state/request.js';
import { lampWords, t } from '../words/words.js';
import { cover, uncover } from './cover.js';
import { element } from './element.js';
import { pathForm } from './path_form.js';
import { Film } from './path_player.js';
import { showProblem } from './problem_view.js';
import { save } from './carry.js';

/** Fills `panel`. */
export function mountPathView(studio, panel) {
  const { model } = studio;
  const place = () => studio.light;
  const form = pathForm({ place, changed: leave, play, pause, seek, keep, use, close: leave });
  const caption = element('span', { class: 'side left' });
  let film = null; // with `key`, what it was made of, `lights`, and the frame `seen`
  panel.append(...form.nodes);

  const frameMs = () => (form.state.seconds * 1000) / form.state.frames;

  /** The lamp's places; null with the reason told where there is no way. */
  function wayOf({ kind, frames, places, closed }) {
    if (kind === 'places') return places.length > 1 ? curvePath(places, frames, closed) : fault('morePlaces');
    if (!studio.light || !studio.pivot) return fault('lampOff');
    return circlePath(studio.pivot, studio.light, frames) ?? fault('onAxis');
  }

  function fault(name) {
    form.tell(t(`path.${name}`));
    return null;
  }

  // The film of what is wanted: the one in sight, or that of before while nothing has changed.
  function filmNow() {
    if (film?.showing) return film;
    form.tell('');
    const lights = wayOf(form.state);
    if (!lights) return null;
    const requests = lights.map((light) => ({ ...studio.final, ...studio.lightPatch(light) }));
    const key = requests.map(queryOf).join('\n');
    if (film?.key === key) return film;
    film?.drop();
    film = Object.assign(new Film(requests, { show, came: draw, failed: showProblem }), { key, lights });
    return film;
  }

  function show(image, index) {
    image.alt = t('path.frame', { at: index + 1, count: film.requests.length });
    caption.textContent = lampWords({}, film.lights[index]);
    [film.showing, film.seen] = [true, index];
    cover(leave, image, caption);
    form.at(index);
    draw();
  }

  function seek(index) {
    const now = filmNow();
    if (!now) return;
    now.pause();
    now.seek(index);
    now.load();
    draw();
  }

  function play() {
    const now = filmNow();
    if (!now) return;
    now.load();
    now.seek(now.at);
    now.play(frameMs());
    draw();
  }

  function pause() {
    film?.pause();
    draw();
  }

  // Somebody else covers the picture, or what it shows has changed: nothing comes any more, either.
  function leave() {
    film?.hold();
    if (film) film.showing = false;
    uncover(leave);
    draw();
  }

  function use() {
    studio.moveLight(film.lights[film.seen]);
  }

  async function keep() {
    const now = filmNow();
    if (!now) return;
    const all = await now.load();
    if (!all || film !== now) return;
    try {
      const { apngOf } = await import('../picture/apng.js');
      const pngs = await Promise.all(now.frames.map(({ blob }) => bytesOf(blob)));
      save(apngOf(pngs, frameMs()), `tia${fileName(model.request)}-path.png`);
      form.tell(t('path.saved', { count: pngs.length }));
    } catch (error) {
      showProblem(new Problem({ title: t('trouble.unreadable'), status: 502, detail: error.message }));
    }
  }

  function draw() {
    const { playing = false, showing = false, frames = [], requests = [] } = film ?? {};
    form.draw({ playing, showing, there: frames.length, count: requests.length });
  }

  model.on('want', leave);
}

async function bytesOf(blob) {
  return new Uint8Array(await blob.arrayBuffer());
}
