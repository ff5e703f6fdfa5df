// What the layer costs: overhead SCAN prints JSON: ns of a call that does nothing, ms to read the labels back (median of 50), into
// a new array and into one that is there. SPDX-License-Identifier: Apache-2.0
using System;
using System.Diagnostics;
using System.Globalization;
using Toothseg;

static class Overhead
{
    static double Median(Action call)
    {
        var ms = new double[50];
        for (int i = 0; i < ms.Length; ++i)
        {
            var watch = Stopwatch.StartNew();
            call();
            ms[i] = watch.Elapsed.TotalMilliseconds;
        }
        Array.Sort(ms);
        return (ms[24] + ms[25]) / 2;
    }

    static double Nanoseconds(int calls, Action call)
    {
        call();
        var watch = Stopwatch.StartNew();
        for (int i = 0; i < calls; ++i) call();
        return 1e6 * watch.Elapsed.TotalMilliseconds / calls;
    }

    static void Main(string[] arguments)
    {
        double call = Nanoseconds(5000000, () => Fdi.ToUniversal(16));
        using (var context = new Context())
        using (Model model = Model.Load(context, arguments[0]))
        using (Features features = Features.Detect(model))
        using (var segmentation = new Segmentation(features))
        {
            segmentation.SegmentAll();
            uint[] labels = segmentation.GetLabels();
            uint count = 0;
            double withHandle = Nanoseconds(1000000, () => count = segmentation.ClickCount);
            double fresh = Median(() => segmentation.GetLabels());
            double reused = Median(() => segmentation.GetLabels(labels));
            Console.WriteLine("{" + string.Format(CultureInfo.InvariantCulture,
                "\"call_ns\": {0:F1}, \"call_with_handle_ns\": {1:F1}, \"faces\": {2}, \"labels_ms\": {3:F3}, \"labels_reused_ms\": {4:F3}",
                call, withHandle, labels.Length, fresh, reused) + "}");
        }
    }
}
