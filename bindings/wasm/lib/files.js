// Files of the module: in memory, until the page, worker or process ends. SPDX-License-Identifier: Apache-2.0
import { Status } from './abi.js';
import { FileError } from './errors.js';
import { loaded } from './module.js';
import { text } from './values.js';

function on(path, work) {
  try {
    return work(loaded().FS, text(path, 'path'));
  } catch (error) {
    if (error?.errno === undefined) throw error;
    throw new FileError(Status.E_FILE_OPEN, `'${path}': error ${error.errno} of the file system in memory`);
  }
}

/** What Model.load, save and saveSession read and write. Paths like '/scan.stl'. */
export const files = Object.freeze({
  write: (path, bytes) => on(path, (fs) => fs.writeFile(path, bytes)),
  read: (path) => on(path, (fs) => fs.readFile(path)),
  remove: (path) => on(path, (fs) => fs.unlink(path)),
  exists: (path) => on(path, (fs) => fs.analyzePath(path).exists),
});

let count = 0;

/** The bytes that `save(path)` writes: `await saved((path) => mesh.save(path, OutputFormat.STL))`. */
export async function saved(save) {
  const path = `/saved-${++count}`;
  try {
    await save(path);
    return files.read(path);
  } finally {
    if (files.exists(path)) files.remove(path);
  }
}
