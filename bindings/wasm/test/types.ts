// Compiled only. SPDX-License-Identifier: Apache-2.0
import { Context, Features, Model, OutputFormat, Segmentation, files, load, makeArch, memoryUse, saved } from 'toothseg-wasm';
import type { Arch } from 'toothseg-wasm';

export async function separate(wasm: WebAssembly.Module, scan: File): Promise<Uint8Array> {
  await load({ wasm });
  const context = new Context();
  const model = await Model.read(context, await scan.arrayBuffer());
  const stages: string[] = [];
  const features = await Features.detect(model, { onProgress: (f, stage) => void stages.push(`${stage} ${f}`) });
  const segmentation = await Segmentation.create(features);
  await segmentation.click([1, 2, 3]);
  files.write('/scan.stl', new Uint8Array(84));
  return saved((path) => segmentation.save(path, OutputFormat.GLB));
}

export async function synthetic(context: Context): Promise<number> {
  const arch: Arch = makeArch({ triangles: 60000, crowding: 0.35, missing: [16] });
  const model: Model = await Model.create(context, arch);
  return model.report().faces - arch.labels.length + memoryUse().inUse;
}

export function wrong(): void {
  // @ts-expect-error no such option
  makeArch({ triangle: 1 });
  // @ts-expect-error nor here
  void load({ url: 'toothseg.wasm' });
}
