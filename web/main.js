// Wires the studio: one model, the passes that draw it, and the panels, each of which gets the
// studio and knows no other panel.

import { mountAddress, firstState } from './panels/address.js';
import { mountCompare } from './panels/compare.js';
import { mountGallery } from './panels/gallery.js';
import { mountHand } from './panels/hand.js';
import { mountLight } from './panels/light.js';
import { mountMaps } from './panels/maps.js';
import { mountNumbers } from './panels/numbers.js';
import { mountPath } from './panels/path.js';
import { mountPicture } from './panels/picture.js';
import { mountScene } from './panels/scene.js';
import { mountTabs } from './panels/tabs.js';
import { mountTake } from './panels/take.js';
import { mountWhy } from './panels/why.js';
import { learnIntegrators } from './picture/integrators.js';
import { Studio } from './studio/studio.js';
import { chooseLanguage, dress, languageNow, speak } from './words/words.js';

const PANELS = [mountPicture, mountHand, mountLight, mountMaps, mountWhy, mountScene, mountCompare,
  mountPath, mountNumbers, mountTake, mountGallery, mountTabs, mountAddress];

await Promise.all([chooseLanguage(), learnIntegrators()]);
dress();
const chooser = document.getElementById('language');
chooser.value = languageNow();
chooser.addEventListener('change', () => speak(chooser.value));

const studio = new Studio();
for (const mount of PANELS) mount(studio);
studio.begin(await firstState());
document.getElementById('hand').focus({ preventScroll: true });
