// The timeline's panel: what is in it is loaded when it is first opened.

import { Problem } from '../picture/problem.js';
import { t } from '../words/words.js';
import { showProblem } from './problem_view.js';

export default function mountTimeline(studio, panel) {
  let asked = false;
  studio.model.on('tab', async () => {
    if (asked || studio.tab !== 'tab-timeline') return;
    asked = true;
    await import('./timeline_view.js').then(({ mountTimelineView }) => mountTimelineView(studio, panel))
      .catch((error) => {
        asked = false;
        console.warn(error.message);
        showProblem(new Problem({ title: t('trouble.unreachable') }));
      });
  });
}
