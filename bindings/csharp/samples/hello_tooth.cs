// The shortest way to a tooth: hello_tooth SCAN prints the cut around the first tooth the library proposes.
// SPDX-License-Identifier: Apache-2.0
using System;
using Toothseg;

static class HelloTooth
{
    static int Main(string[] arguments)
    {
        if (arguments.Length != 1)
        {
            Console.Error.WriteLine("usage: hello_tooth SCAN");
            return 2;
        }
        try
        {
            using (var context = new Context())
            using (var model = Model.Load(context, arguments[0]))
            using (var features = Features.Detect(model))
            using (var segmentation = new Segmentation(features))
            {
                uint click = segmentation.Click(segmentation.ProposeClicks()[0]);
                uint tooth = segmentation.GetClick(click).Target;
                foreach (EdgePoint point in segmentation.GetCut(tooth).Points) Console.WriteLine(point.Position);
            }
            return 0;
        }
        catch (ToothsegException e)
        {
            Console.Error.WriteLine("hello_tooth: {0}: {1}", e.Name, e.Message);
            return 1;
        }
    }
}
