// Draws the picture of the first page, README.md, anew: node tests/browser/screenshot.mjs
// The edge of the ball's shadow was clicked; the second ray, towards the lamp, is chosen.

import { fileURLToPath } from 'node:url';
import { startChromium, visit } from './page.mjs';
import { startTia } from './tia.mjs';

const FILE = fileURLToPath(new URL('../golden/page.png', import.meta.url));
const VIEW = { viewport: { width: 1280, height: 1120 }, locale: 'en-GB', colorScheme: 'light' };

const [tia, browser] = await Promise.all([startTia(), startChromium()]);
try {
  await visit(browser, tia.base, async (page) => {
    await page.locator('#why-steps [role=treeitem], #panel-why li').nth(1).waitFor();
    await page.getByRole('button', { name: 'Next ray' }).click();
    await page.locator('.rays .ray.current').first().waitFor();
    await page.locator('.map image[href]').nth(1).waitFor();
    await page.screenshot({ path: FILE });
  }, { ...VIEW, path: '/?scene=thesis&key=a&pixel=440,452' });
} finally {
  await browser.close();
  await tia.stop();
}
