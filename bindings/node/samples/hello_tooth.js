// The shortest way to a tooth: the cut around the first one that the library proposes, x y z a line.
// SPDX-License-Identifier: Apache-2.0
import { Context, Features, Model, Segmentation } from 'toothseg';

const context = new Context();
const model = await Model.load(context, process.argv[2]);
const features = await Features.detect(model);
const segmentation = await Segmentation.create(features);

const click = await segmentation.click(segmentation.proposeClicks()[0]);
const { target } = segmentation.clickInfo(click);
for (const { position } of segmentation.cut(target).points) console.log(position.map((x) => x.toFixed(4)).join(' '));

for (const object of [segmentation, features, model, context]) object.dispose();
