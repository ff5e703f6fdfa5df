// toothseg for Node. What there is, is said in index.d.ts. SPDX-License-Identifier: Apache-2.0
export {
  Background, CutRule, EditKind, FeaturesWarning, FileFormat, Jaw, LogLevel, MeshVertexFlag, NONE, OutputFormat, Preset,
  Status, ToothWarning, Unit, Weights,
} from './lib/abi.js';
export { Context } from './lib/context.js';
export {
  EditError, FeatureError, FileError, MeshError, NumberError, ResourceError, SegmentationError, ToothMeshError,
  ToothsegError, UsageError,
} from './lib/errors.js';
export { Features } from './lib/features.js';
export { ToothMesh } from './lib/mesh.js';
export { Model } from './lib/model.js';
export { fdiToPalmer, fdiToUniversal, universalToFdi, version } from './lib/numbers.js';
export { Resource } from './lib/resource.js';
export { Segmentation } from './lib/segmentation.js';
