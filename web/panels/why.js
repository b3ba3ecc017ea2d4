// Why a pixel has its colour: asks the server about the pixel of the picture that is shown, each
// time that it has changed, and shows the answer here and over the picture.

import { plain } from '../picture/passes.js';
import { middleOf, sizeOf, windowOf } from '../state/window.js';
import { viewOf } from '../space/view.js';
import { t } from '../words/words.js';
import { raysLayer } from './rays.js';
import { makeView } from './why_view.js';

export default function mountWhy(studio, panel) {
  const { model } = studio;
  const layer = raysLayer(document.getElementById('overlay'));
  const view = makeView(panel, { stop, middle: () => model.ask(middleOf(model.request)), moved: tellRays });
  let about = null; // the pixel that the panel is about
  let explained = null; // what is told of it
  let newest = null; // the last question: { request, pixel, key }
  let asking = null; // the one that the server is at, with its way to be called back

  function stop() {
    model.ask(null);
    view.invite(true);
  }

  // Of questions about one pixel the newest waits for the one under way, so that the explanation
  // keeps up with a lamp that is dragged; a question about another pixel calls it back.
  async function ask(request) {
    const question = { request, pixel: model.asked, key: JSON.stringify([request, model.asked]) };
    if (question.key === newest?.key) return;
    newest = question;
    if (asking && asking.pixel !== question.pixel) asking.abort.abort();
    if (asking) return;
    while (newest && asking !== newest) await answer(newest);
    asking = null;
  }

  async function answer(question) {
    asking = question;
    question.abort = new AbortController();
    const { request, pixel, abort } = question;
    const told = await Promise.all([import('../picture/explain_pixel.js'), view.learn()])
      .then(([{ explainPixel }]) => explainPixel(request, pixel, studio.pivot, abort.signal))
      .catch((problem) => ({ problem }));
    if (model.asked !== pixel) return;
    if (told.problem) fail(told.problem);
    else show(told, question);
  }

  function show(told, { request, pixel }) {
    const { options } = model.source ?? {};
    const again = explained?.pixel === pixel;
    explained = { ...told, pixel };
    const said = (name) => request[name] ?? model.world?.options?.[name] ?? options?.[name];
    const transfer = said('exposure') || said('white_balance_kelvin') ? '' : said('transfer') ?? 'srgb';
    const many = plain(model.request, options) !== model.request;
    const why = view.show(told, { pixel, transfer, many, scene: model.world ?? model.source }, again);
    const [x, y] = pixel;
    if (!again) document.getElementById('said').textContent = t('why.told', { x, y, why });
    tellRays();
  }

  function fail(problem) {
    if (problem.name === 'AbortError') return;
    [explained, newest] = [null, null];
    view.fail(problem);
    tellRays();
  }

  // What is asked about has changed, or may have: a link and the gallery set it without a word.
  function turnTo() {
    if (model.asked === about) return draw();
    if (model.asked && !about && studio.tab !== 'tab-why') studio.openTab('tab-why');
    about = model.asked;
    newest = null;
    asking?.abort.abort();
    if (!about) view.invite(false);
    else if (outside(about)) view.refuse(t('why.outside', outside(about)));
    else if (!explained) view.busy();
    if (!about || outside(about)) explained = null;
    tellRays();
    if (about && model.source) askNow(studio.final);
  }

  function askNow(request) {
    if (model.asked && !outside(model.asked)) ask(request);
  }

  function outside([x, y]) {
    const [width, height] = sizeOf(model.request);
    const within = (value, length) => Number.isInteger(value) && value >= 0 && value < length;
    return within(x, width) && within(y, height) ? null : { x, y, width, height };
  }

  // ---- the rays, here and in the side views ---------------------------------------------------

  function tellRays() {
    const known = explained && explained.pixel === model.asked;
    model.rays = known ? view.rays : null;
    model.tell('rays');
    draw();
  }

  function draw() {
    if (!model.asked || outside(model.asked)) return layer.clear();
    const camera = { ...(model.world ?? model.source)?.camera, ...model.shown?.request.camera };
    layer.draw(viewOf(camera, ...sizeOf(model.request)), windowOf(model.request), model.asked, model.rays);
  }

  panel.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || !model.asked) return;
    event.stopPropagation(); // elsewhere it puts the lamp out
    stop();
  });
  for (const event of ['ask', 'want']) model.on(event, turnTo);
  for (const event of ['show', 'world']) model.on(event, draw);
  model.on('rest', () => askNow(model.shown.request));
}
