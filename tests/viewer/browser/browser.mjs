// What the tests of pages share: Chromium, pages whose problems are collected, accessibility.
import fs from 'node:fs';
import {createRequire} from 'node:module';

const {chromium, firefox} = createRequire(import.meta.url)('playwright-core');
const kAxe = fs.readFileSync(createRequire(import.meta.url).resolve('axe-core'), 'utf8');

/** Starts $FIREFOX, a Firefox as distributions have it: the driver speaks WebDriver BiDi with it, which has no color schemes, and tells
 * nothing of workers. */
export function launchFirefox() {
  return firefox.launch({channel: 'moz-firefox', executablePath: process.env.FIREFOX});
}

/** Starts $CHROMIUM. */
export function launch() {
  const args = ['--disable-gpu', ...(process.getuid() === 0 ? ['--no-sandbox'] : [])];
  return chromium.launch({executablePath: process.env.CHROMIUM, args});
}

/**
 * Opens a page; `problems` collects console messages, errors, and requests of URLs that `allowed` does not match. The page
 * collects violations of its policy in window.violations.
 * @param {import('playwright-core').Browser} browser @param {string} url @param {RegExp} allowed
 */
export async function openPage(browser, url, allowed, options = {}) {
  const context = await browser.newContext({viewport: {width: 1280, height: 800}, colorScheme: 'dark', ...options});
  const page = await context.newPage();
  const problems = [];
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && problems.push(message.text()));
  page.on('pageerror', (error) => problems.push(error.stack));
  page.on('request', (request) => !allowed.test(request.url()) && problems.push(`request of ${request.url()}`));
  await page.addInitScript(() => {
    window.violations = [];
    document.addEventListener('securitypolicyviolation', (event) => window.violations.push(event.violatedDirective));
  });
  await page.goto(url);
  return {page, problems, context};
}

/** What axe finds in the page, a line for each rule. @param {object} options of axe.run() */
export async function accessibilityViolations(page, options = {}) {
  await page.evaluate(kAxe);
  const {violations} = await page.evaluate((given) => window.axe.run(given), options);
  return violations.map(({id, nodes}) => `${id}: ${nodes.map(({html, failureSummary}) => `${html.slice(0, 160)} ${failureSummary}`).join(' ')}`);
}

/** Widths of windows, telephones to large screens, and those around which the layout changes. */
export const kWidths = [320, 360, 390, 480, 600, 768, 900, 901, 1000, 1060, 1200, 1280, 1350, 1366, 1440, 1500, 1501, 1920, 2560];

/** What of the toolbar and its menu is outside the window at each of these widths, and how many rows the buttons take.
 * @returns {Promise<{outside: string[], rows: Record<number, number>}>} */
export async function toolbarLayout(page, widths = kWidths) {
  const outside = [];
  const rows = {};
  for (const width of widths) {
    await page.setViewportSize({width, height: width < 700 ? 800 : Math.round(width * 0.6)});
    await page.waitForTimeout(50);
    await page.locator('.menu summary').click();
    const found = await page.evaluate(() => {
      const {clientWidth, clientHeight} = document.documentElement;
      const inside = ({left, right, top, bottom}, vertical) => left >= 0 && right <= clientWidth && (!vertical || (top >= 0 && bottom <= clientHeight));
      const buttons = [...document.querySelectorAll('.controls .button')].filter((button) => button.offsetParent).map((button) => button.getBoundingClientRect());
      const body = document.querySelector('.menu-body').getBoundingClientRect();
      const problems = buttons.filter((button) => !inside(button, false)).map(() => 'a button');
      if (!inside(body, true) || body.height < 100) problems.push(`the menu (${[body.left, body.top, body.right, body.bottom].map(Math.round).join(' ')})`);
      if (document.documentElement.scrollWidth > clientWidth) problems.push('the page');
      return {problems, rows: new Set(buttons.map(({top}) => Math.round(top))).size};
    });
    outside.push(...found.problems.map((problem) => `${problem} at ${width}`));
    rows[width] = found.rows;
    await page.keyboard.press('Escape');
  }
  return {outside, rows};
}
