// Firefox and WebKit for tests, as their distributions have them: Firefox by WebDriver BiDi (puppeteer), WebKit (GTK) by WebDriver over HTTP. A page of
// either does what the helpers of `browser.mjs` ask of one of Playwright's.
import { spawn } from "node:child_process";
import { once } from "node:events";
import { existsSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import puppeteer from "puppeteer-core";
import { TIMEOUT } from "./browser.mjs";

/** How long WebKit may take for its first answer, milliseconds: it may never come. */
const FIRST = 120_000;
const SIZE = { width: 640, height: 480 };

/** Where Firefox is, or undefined. */
export const firefox = [process.env.FIREFOX, "/usr/bin/firefox-esr", "/usr/bin/firefox"].find((path) => path && existsSync(path));
/** Where WebKit's driver is, or undefined. */
export const webkit = [process.env.WEBKIT_DRIVER, "/usr/bin/WebKitWebDriver"].find((path) => path && existsSync(path));

/** Calls a function every now and then until what it gives is true. */
async function until(ask, what) {
  for (const end = Date.now() + TIMEOUT; ; ) {
    const found = await ask();
    if (found) return found;
    if (Date.now() > end) throw new Error(`${what}: nothing after ${TIMEOUT / 1000} s`);
    await new Promise((wake) => setTimeout(wake, 50));
  }
}

/** A handle of a value, as Playwright gives it. */
const handle = (value) => ({ jsonValue: async () => value });

/** Starts Firefox without a screen. */
export async function startFirefox() {
  const preferences = { "app.update.enabled": false, "browser.shell.checkDefaultBrowser": false };
  const browser = await puppeteer.launch({ browser: "firefox", executablePath: firefox, headless: true, defaultViewport: SIZE, extraPrefsFirefox: preferences, timeout: TIMEOUT, protocolTimeout: TIMEOUT });
  return {
    newPage: async () => {
      const page = await browser.newPage();
      page.setDefaultTimeout(TIMEOUT);
      return {
        on: (name, listener) => page.on(name, listener),
        setDefaultTimeout() {},
        goto: (address) => page.goto(address),
        evaluate: (ask, given) => page.evaluate(ask, given),
        waitForFunction: async (ask, given) => handle(await until(() => page.evaluate(ask, given), "a page of Firefox")),
        screenshot: ({ path }) => page.screenshot({ path }),
        press: (key) => page.keyboard.press(key),
        drag: async (from, to) => {
          await page.mouse.move(...from);
          await page.mouse.down();
          await page.mouse.move(...to, { steps: 5 });
          await page.mouse.up();
        },
        close: () => page.close(),
      };
    },
    version: () => browser.version(),
    close: () => browser.close(),
  };
}

/** A port that nobody has. */
function freePort() {
  return new Promise((found) => {
    const server = createServer().listen(0, "127.0.0.1", () => {
      const { port } = server.address();
      server.close(() => found(port));
    });
  });
}

/** Keys by their code points of WebDriver. */
const KEYS = { ArrowLeft: "\uE012", ArrowUp: "\uE013", ArrowRight: "\uE014", ArrowDown: "\uE015", Enter: "\uE007", Tab: "\uE004" };

/** A screen in memory for what needs one: the number of the display, and the process to end. */
async function startScreen() {
  const screen = spawn("Xvfb", ["-displayfd", "1", "-screen", "0", "1024x768x24"], { stdio: ["ignore", "pipe", "ignore"] });
  const [number] = await Promise.race([once(screen.stdout, "data"), once(screen, "exit").then(() => Promise.reject(new Error("Xvfb has ended")))]);
  return { display: `:${String(number).trim()}`, end: () => screen.kill() };
}

/** Ends a process and those that it has started. */
function endGroup(pid) {
  try {
    process.kill(-pid);
  } catch {
    // They have all ended.
  }
}

/** Starts WebKit's driver on a screen: how to ask it, and to end it with its browsers. */
async function startDriver({ display }) {
  for (let attempt = 1; ; attempt++) {
    const port = await freePort();
    const driver = spawn(webkit, [`--port=${port}`, "--host=127.0.0.1"], { stdio: "ignore", env: { ...process.env, DISPLAY: display }, detached: true });
    let isOver = false;
    driver.once("exit", () => (isOver = true));
    const ask = async (method, path, body) => {
      const patience = path === "/session" ? FIRST : TIMEOUT;
      const answer = await fetch(`http://127.0.0.1:${port}${path}`, { method, body: body && JSON.stringify(body), signal: AbortSignal.timeout(patience) });
      const { value } = await answer.json();
      if (value?.error) throw new Error(`${value.error}: ${value.message}`);
      return value;
    };
    await until(() => isOver || ask("GET", "/status").then(() => true, () => false), "WebKit's driver");
    // It ends at once where somebody else has taken the port meanwhile.
    if (!isOver) return { ask, end: () => endGroup(driver.pid) };
    if (attempt === 5) throw new Error("WebKit's driver has ended");
  }
}

/** Starts WebKit's driver, and with each page a browser. Its browser needs a screen, which it is given. */
export async function startWebkit() {
  const screen = await startScreen();
  let driver = await startDriver(screen);
  const ask = (...given) => driver.ask(...given);
  // Now and then a browser that the driver starts never answers it. Nothing of ours has run by then, so a driver of its own is asked once more.
  const newSession = async () => {
    const session = () => ask("POST", "/session", { capabilities: { alwaysMatch: {} } });
    try {
      return await session();
    } catch (problem) {
      console.log(`WebKit's driver gave no browser and is started again: ${problem.message}`);
      driver.end();
      driver = await startDriver(screen);
      return session();
    }
  };
  let version;
  return {
    newPage: async () => {
      const { sessionId, capabilities } = await newSession();
      version = `${capabilities.browserName} ${capabilities.browserVersion}`;
      const own = `/session/${sessionId}`;
      await ask("POST", `${own}/timeouts`, { script: TIMEOUT, pageLoad: TIMEOUT });
      await ask("POST", `${own}/window/rect`, { x: 0, y: 0, ...SIZE }).catch(() => {});
      const evaluate = (script, given) => ask("POST", `${own}/execute/sync`, { script: `return (${script})(...arguments)`, args: given === undefined ? [] : [given] });
      const act = (...actions) => ask("POST", `${own}/actions`, { actions });
      const move = ([x, y], duration = 0) => ({ type: "pointerMove", duration, origin: "viewport", x: Math.round(x), y: Math.round(y) });
      return {
        on() {},
        setDefaultTimeout() {},
        goto: (url) => ask("POST", `${own}/url`, { url }),
        evaluate,
        waitForFunction: async (script, given) => handle(await until(() => evaluate(script, given), "a page of WebKit")),
        screenshot: async ({ path }) => writeFileSync(path, Buffer.from(await ask("GET", `${own}/screenshot`), "base64")),
        press: (key) => act({ type: "key", id: "keys", actions: ["keyDown", "keyUp"].map((type) => ({ type, value: KEYS[key] ?? key })) }),
        drag: (from, to) => {
          const actions = [move(from), { type: "pointerDown", button: 0 }, move(to, 100), { type: "pointerUp", button: 0 }];
          return act({ type: "pointer", id: "mouse", parameters: { pointerType: "mouse" }, actions });
        },
        close: () => ask("DELETE", own),
      };
    },
    version: async () => version,
    close: async () => {
      driver.end();
      screen.end();
    },
  };
}
