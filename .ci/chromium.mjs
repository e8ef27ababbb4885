// What every script that opens pages in Chromium begins with. `.ci/browser --install` installs what this imports.

import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const root = dirname(dirname(fileURLToPath(import.meta.url)));
export const require = createRequire(join(root, "target/browser/here.js"));

// Chromium without a window, without sandbox and network of its own; `CHROMIUM=path` is the program.
export const launched = () => require("playwright-core").chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: [
        "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
        "--disable-background-networking", "--disable-component-update", "--disable-sync",
    ],
});

// In the page: the lines of a picture's words that a search does not find in it, or cannot mark.
export function wordsNotFound() {
    const svg = document.querySelector("svg");
    const lines = Array.from(svg.querySelectorAll("text"), (text) => text.textContent);
    const found = (line) => {
        getSelection().removeAllRanges();
        while (window.find(line)) {
            if (svg.contains(getSelection().anchorNode) && getSelection().toString().trim() === line) return true;
        }
        return false;
    };
    const lost = lines.length > 3 ? lines.filter((line) => !found(line)) : ["any words"];
    getSelection().removeAllRanges();
    return lost;
}
