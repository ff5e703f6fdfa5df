// Compiled only. SPDX-License-Identifier: Apache-2.0
import {
  Context, Features, Jaw, Model, NONE, OutputFormat, Preset, Segmentation, Status, ToothMesh, ToothsegError, Unit, UsageError,
  Weights, fdiToPalmer,
} from 'toothseg';
import type { ToothInfo } from 'toothseg';

export async function separate(path: string, signal: AbortSignal): Promise<Uint32Array> {
  using context = new Context({ threads: 2, log: (level, text) => console.log(level, text) });
  using model = await Model.load(context, path, { unit: Unit.MM, weldTolerance: 1e-3, signal });
  const features = await Features.detect(model, { maxPoints: 8, occlusal: [0, 0, 1], onProgress: (f) => f < 2 });
  const segmentation = await Segmentation.create(features, {
    preset: Preset.PAPER, weights: Weights.CONCAVITY, rejectOutliers: true, memoryLimit: 10n ** 9n,
  });
  const click: number = await segmentation.click([1, 2, 3]);
  const statuses: Status[] = segmentation.clicksSync(new Float64Array(6), { onProgress: (f, stage) => stage.length > f });
  if (segmentation.clickInfo(click).neighbour === NONE || statuses[0] !== Status.OK) segmentation.undo();
  const tooth: ToothInfo = segmentation.tooth(0);
  segmentation.onChange((teeth) => console.log(teeth.length));
  segmentation.onChange(null);
  segmentation.assignNumbers({ jaw: Jaw.UPPER, mirrored: false });
  const mesh: ToothMesh = await segmentation.toothMesh(tooth.id, { closed: true });
  await mesh.save('tooth.stl', OutputFormat.STL);
  const x: number = segmentation.cut(tooth.id).points[0].position[0];
  console.log(x, fdiToPalmer(11).letters, segmentation.number(tooth.id).uncertain === true);
  const made = Model.createSync(context, { positions: new Float32Array(9), triangles: [0, 1, 2] });
  made.dispose();
  return segmentation.labels(new Uint32Array(10));
}

export function explain(error: unknown): string {
  if (error instanceof UsageError) return 'a bug';
  return error instanceof ToothsegError ? `${error.code} (${error.status}): ${error.message}` : 'something else';
}

export function wrong(context: Context, model: Model): void {
  // @ts-expect-error a model is not made by new
  new Model();
  // @ts-expect-error no such option
  Features.detectSync(model, { maxPoint: 8 });
  // @ts-expect-error no such unit
  Model.loadSync(context, 'scan.stl', { unit: 9 });
  // @ts-expect-error positions are typed arrays
  Model.createSync(context, { positions: [0, 0, 0] });
  // @ts-expect-error a promise is no segmentation
  const segmentation: Segmentation = Segmentation.create(new Features(model));
  segmentation.dispose();
}
