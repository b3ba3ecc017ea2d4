// The path's panel: what is in it is loaded when it is first opened.

import { Problem } from '../picture/problem.js';
import { t } from '../words/words.js';
import { showProblem } from './problem_view.js';

export default function mountPath(studio, panel) {
  let asked = false;
  studio.model.on('tab', async () => {
    if (asked || studio.tab !== 'tab-path') return;
    asked = true;
    await import('./path_view.js').then(({ mountPathView }) => mountPathView(studio, panel))
      .catch(() => showProblem(new Problem({ title: t('trouble.unreachable') }), (asked = false)));
  });
}
