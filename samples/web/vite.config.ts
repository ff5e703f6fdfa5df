// A static folder with relative addresses: it can lie anywhere. SPDX-License-Identifier: Apache-2.0
import { defineConfig } from 'vite';

export default defineConfig({
  base: './',
  // It looks for its .wasm beside itself.
  optimizeDeps: { exclude: ['toothseg-wasm'] },
  worker: { format: 'es' },
  build: { target: 'es2022', chunkSizeWarningLimit: 1200 },
});
