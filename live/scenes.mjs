// Scenes as JSON, as a page holds them and the module reads them: of a folder, from its live pages.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, parse } from 'node:path';

const target = new URL('../target', import.meta.url).pathname;
const binaries = ['release', 'debug'].map((profile) => join(target, profile, 'tracefig'));

/** What the pages of the scenes of a folder open the module with. `TRACEFIG=path` is the binary. */
export function requests(folder) {
    const pages = mkdtempSync(join(tmpdir(), 'tracefig-'));
    const binary = process.env.TRACEFIG ?? binaries.find((path) => existsSync(path));
    const options = ['--format', 'html', '--live=shared', '-o', pages];
    execFileSync(binary, ['render', folder, ...options], { stdio: 'ignore' });
    const isPage = (name) => name.endsWith('.html') && name !== 'index.html';
    const files = readdirSync(pages).filter(isPage).sort();
    const request = (name) => {
        const page = readFileSync(join(pages, name), 'utf8');
        return JSON.parse(/<script type="application\/json">(.*?)<\/script>/s.exec(page)[1]);
    };
    const all = new Map(files.map((name) => [parse(name).name, request(name)]));
    rmSync(pages, { recursive: true });
    return all;
}
