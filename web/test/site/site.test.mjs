// The site that `.ci/site` has built: links lead somewhere, and the first page shows a scene.
import assert from "node:assert/strict";
import { existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { test } from "node:test";
import { context, pictures, root, setUp, violations } from "../browser.mjs";
import { serve } from "../server.mjs";

const site = join(root, "target/site");
setUp();

/** Links and files that a page names, without those of other sites, that lead to nothing. */
function broken(html, page) {
  const tags = html.match(/<[a-z][^<>]*>/gi) ?? [];
  const links = tags.flatMap((tag) => [...tag.matchAll(/\s(?:href|src|poster)="([^"#?]+)/g)].map((match) => match[1].replaceAll("&amp;", "&")));
  const here = links.filter((link) => !/^[a-z][a-z+.-]*:|^\/\//i.test(link));
  return here.filter((link) => {
    const path = link.startsWith("/") ? join(site, link) : resolve(dirname(page), decodeURIComponent(link));
    return !existsSync(path) || (statSync(path).isDirectory() && !existsSync(join(path, "index.html")));
  });
}

test("no link leads nowhere", () => {
  // Rust's pages are checked by rustdoc.
  const pages = readdirSync(site, { recursive: true }).filter((path) => path.endsWith(".html") && !path.startsWith("api/rust/"));
  assert.ok(pages.length > 100, `${pages.length} pages`);
  for (const path of pages.filter((path) => path !== "404.html")) {
    const page = join(site, path);
    assert.deepEqual(broken(readFileSync(page, "utf8"), page), [], path);
  }
  for (const entry of ["api/rust/voxtrace/index.html", "api/typescript/index.html", "api/python/voxtrace.html"]) assert.ok(pages.includes(entry) || existsSync(join(site, entry)), entry);
  assert.deepEqual(broken('<a href="web/">', join(site, "index.html")), []);
  assert.deepEqual(broken('<a href="web/not-there/">', join(site, "index.html")), ["web/not-there/"]);
});

for (const [name, width, height, colorScheme] of [["desktop", 1280, 900, "light"], ["phone", 390, 800, "dark"]]) {
  test(`the first page shows a scene on a ${name}`, async (test) => {
    const server = await serve({ "/": site });
    test.after(() => server.end());
    const page = await context.browser.newPage({ viewport: { width, height }, colorScheme });
    const [failed, errors] = [[], []];
    page.on("response", (response) => response.status() >= 400 && failed.push(response.url()));
    page.on("request", (request) => request.url().startsWith("http") && !request.url().startsWith(server.address) && failed.push(request.url()));
    page.on("pageerror", (error) => errors.push(error.message));
    await page.goto(`${server.address}/index.html`);
    const viewer = page.locator("voxtrace-viewer").first();
    await viewer.evaluate((element) => new Promise((done) => (element.loaded ? done() : element.addEventListener("load", done))));
    assert.equal(await viewer.evaluate((element) => element.scene.name), "city");
    await page.waitForTimeout(3_000);
    await page.screenshot({ path: join(pictures, `site-${name}.png`) });
    // Of what the theme itself makes nothing is held here.
    const ours = (await violations(page)).filter((violation) => /voxtrace-viewer/.test(violation));
    assert.deepEqual([ours, errors, failed], [[], [], []]);
    await page.close();
  });
}
