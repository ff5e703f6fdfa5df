// A static folder with relative addresses: it can lie anywhere. SPDX-License-Identifier: Apache-2.0
import { readFileSync } from 'node:fs';
import { defineConfig, type Plugin } from 'vite';

/** The notices of what the page contains go with it. */
const notices: Plugin = {
  name: 'notices',
  generateBundle() {
    for (const fileName of ['LICENSE', 'THIRD_PARTY.md'])
      this.emitFile({ type: 'asset', fileName, source: readFileSync(new URL(`../../${fileName}`, import.meta.url)) });
  },
};

export default defineConfig({
  base: './',
  plugins: [notices],
  // It looks for its .wasm beside itself.
  optimizeDeps: { exclude: ['toothseg-wasm'] },
  worker: { format: 'es' },
  build: { target: 'es2022', chunkSizeWarningLimit: 1200 },
});
