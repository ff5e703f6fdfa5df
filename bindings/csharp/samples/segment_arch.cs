// All teeth of a scan: segment_arch SCAN [--all] [--labels OUT.txt] [--teeth DIR]. Progress on stderr; Ctrl-C cancels.
// SPDX-License-Identifier: Apache-2.0
using System;
using System.IO;
using System.Text;
using Toothseg;

static class SegmentArch
{
    const string Usage =
        "usage: segment_arch SCAN [options]\n" +
        "  --all             every tooth at once, instead of the fewest clicks that cover all\n" +
        "  --labels OUT.txt  a number a face, in the order of the faces in SCAN; 0: no tooth\n" +
        "  --teeth DIR       a mesh a tooth, tooth_LABEL.stl, and gingiva.stl\n" +
        "Exit status: 0 done; 1 a click failed, the others are written; 2 nothing is written.";

    static string scan, labels, teeth;
    static bool all;
    static int failed;

    static bool Parse(string[] arguments)
    {
        for (int i = 0; i < arguments.Length; ++i)
        {
            string argument = arguments[i];
            if (argument == "--all") all = true;
            else if (argument == "--labels" && i + 1 < arguments.Length) labels = arguments[++i];
            else if (argument == "--teeth" && i + 1 < arguments.Length) teeth = arguments[++i];
            else if (scan == null && !argument.StartsWith("-", StringComparison.Ordinal)) scan = argument;
            else return false;
        }
        return scan != null;
    }

    static void Complain(string text) { Console.Error.WriteLine("segment_arch: " + text); }

    static bool Show(double fraction, string stage)
    {
        Console.Error.WriteLine("{0,3:0} % {1}", 100 * fraction, stage);
        return true;
    }

    // Proposed clicks until nothing is left, or until a round separates nothing more. One after the other, for the message
    // of each that fails.
    static void ClickAll(Segmentation segmentation, Job job)
    {
        for (int before = -1, now = 0; now > before; )
        {
            Point[] clicks = segmentation.ProposeClicks();
            if (clicks.Length == 0) return;
            foreach (Point click in clicks)
            {
                try
                {
                    segmentation.Click(click, job);
                }
                catch (SegmentationException e)
                {
                    Complain(click + ": " + e.Name + ": " + e.Message);
                    ++failed;
                }
            }
            before = now;
            now = segmentation.GetTeeth().Length;
        }
    }

    static void WriteLabels(Segmentation segmentation)
    {
        var text = new StringBuilder();
        foreach (uint label in segmentation.GetLabels()) text.Append(label).Append('\n');
        File.WriteAllText(labels, text.ToString(), new UTF8Encoding(false));
    }

    static void WriteTeeth(Segmentation segmentation, Job job)
    {
        Directory.CreateDirectory(teeth);
        foreach (uint tooth in segmentation.GetTeeth())
            using (ToothMesh mesh = segmentation.MakeToothMesh(tooth, null, job))
                mesh.Save(Path.Combine(teeth, "tooth_" + mesh.GetInfo().Label + ".stl"), OutputFormat.Stl, job);
        using (ToothMesh gingiva = segmentation.MakeGingivaMesh(null, job))
            gingiva.Save(Path.Combine(teeth, "gingiva.stl"), OutputFormat.Stl, job);
    }

    static void Run()
    {
        var options = new ContextOptions
        {
            Log = (level, text) => { if (level == LogLevel.Warning) Complain(scan + ": " + text); }
        };
        using (var context = new Context(options))
        using (var job = new Job(context, Show))
        {
            ConsoleCancelEventHandler cancel = (sender, key) => { key.Cancel = true; job.Cancel(); };
            Console.CancelKeyPress += cancel;
            try
            {
                using (Model model = Model.Load(context, scan, null, job))
                using (Features features = Features.Detect(model, null, job))
                using (var segmentation = new Segmentation(features, null, job))
                {
                    if (all) segmentation.SegmentAll(job);
                    else ClickAll(segmentation, job);
                    if (labels != null) WriteLabels(segmentation);
                    if (teeth != null) WriteTeeth(segmentation, job);
                    Console.WriteLine("{0}: {1} teeth, {2} clicks failed", scan, segmentation.GetTeeth().Length, failed);
                }
            }
            finally
            {
                Console.CancelKeyPress -= cancel;
            }
        }
    }

    static int Main(string[] arguments)
    {
        if (!Parse(arguments))
        {
            Complain(Usage);
            return 2;
        }
        try
        {
            Run();
            return failed == 0 ? 0 : 1;
        }
        catch (ToothsegException e)
        {
            Complain(scan + ": " + e.Name + ": " + e.Message);
        }
        catch (SystemException e) when (e is IOException || e is UnauthorizedAccessException)
        {
            Complain(e.Message);
        }
        return 2;
    }
}
