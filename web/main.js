// Wires the studio: one model, the passes that draw it, and the panels, each of which gets the
// studio and knows no other panel. Those behind tabs are listed in index.html.

import { mountAddress, firstState } from './panels/address.js';
import { mountGallery } from './panels/gallery.js';
import { mountHand } from './panels/hand.js';
import { mountMaps } from './panels/maps.js';
import { mountPicture } from './panels/picture.js';
import { loadPanels, mountTabs } from './panels/tabs.js';
import { learnIntegrators } from './picture/integrators.js';
import { Studio } from './studio/studio.js';
import { chooseLanguage, dress, languageNow, speak } from './words/words.js';

const [panels] = await Promise.all([loadPanels(), chooseLanguage(), learnIntegrators()]);
dress();
const chooser = document.getElementById('language');
chooser.value = languageNow();
chooser.addEventListener('change', () => speak(chooser.value));

const studio = new Studio();
for (const mount of [mountPicture, mountHand, mountMaps, mountGallery]) mount(studio);
mountTabs(studio, panels);
mountAddress(studio);
studio.begin(await firstState());
document.getElementById('hand').focus({ preventScroll: true });
