// What the tests of pages share: Chromium, pages whose problems are collected, accessibility.
import fs from 'node:fs';
import {createRequire} from 'node:module';

const {chromium} = createRequire(import.meta.url)('playwright-core');
const kAxe = fs.readFileSync(createRequire(import.meta.url).resolve('axe-core'), 'utf8');

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
