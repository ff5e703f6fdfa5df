// SPDX-License-Identifier: Apache-2.0
// The C API in C#. Made by generate.py from abi/toothseg.json.
#nullable enable
using System;
using System.Runtime.InteropServices;

namespace Toothseg
{
    /// <summary>What came of a call. Values are fixed for ever; new ones are added within their block.</summary>
    public enum Status : int
    {
        /// <summary>done</summary>
        Ok = 0,
        /// <summary>a value outside its stated range</summary>
        InvalidArgument = 100,
        /// <summary>a pointer that must not be NULL is</summary>
        Null = 101,
        /// <summary>struct_size is 0, or no size that any release had</summary>
        StructSize = 102,
        /// <summary>capacity is less than the number of elements</summary>
        BufferTooSmall = 103,
        /// <summary>no such group, point, click, tooth, loop or contour</summary>
        NotFound = 104,
        /// <summary>objects that do not belong together (features of another model)</summary>
        Mismatch = 105,
        /// <summary>an allocation failed, or memory_limit is too small for any way of work</summary>
        OutOfMemory = 200,
        /// <summary>the job was cancelled, by ts_job_cancel or its callback</summary>
        Cancelled = 201,
        /// <summary>a fault in the library: please report the message</summary>
        Internal = 202,
        /// <summary>cannot be opened or read</summary>
        FileOpen = 300,
        /// <summary>not STL, PLY, OBJ or OFF, or a variant that is not read</summary>
        FileFormat = 301,
        /// <summary>ends before what its header or its last statement promises</summary>
        FileTruncated = 302,
        /// <summary>goes on after what its header promises</summary>
        FileTrailing = 303,
        /// <summary>a count that the file's size contradicts</summary>
        FileCount = 304,
        /// <summary>text where a number or keyword belongs; the message has the line</summary>
        FileSyntax = 305,
        /// <summary>cannot be written; nothing is left half written</summary>
        FileWrite = 306,
        /// <summary>a session of a later format than this library reads</summary>
        FileNewer = 307,
        /// <summary>no face, or none that is not degenerate</summary>
        MeshEmpty = 400,
        /// <summary>NaN or infinity among the coordinates</summary>
        MeshNonFinite = 401,
        /// <summary>a triangle names a vertex that is not there</summary>
        MeshIndexRange = 402,
        /// <summary>too small or too large for a scan in mm: probably in other units</summary>
        MeshUnits = 403,
        /// <summary>more than 2^30 faces or vertices, or coordinates beyond 1e9 mm</summary>
        MeshTooLarge = 404,
        /// <summary>nothing on the mesh looks like a tooth</summary>
        NoTeeth = 500,
        /// <summary>no group with a point: there is nothing to separate</summary>
        NoConstraint = 501,
        /// <summary>the click is further from the surface than click_reach</summary>
        ClickOffSurface = 600,
        /// <summary>the click lies on gingiva or base, not on a tooth</summary>
        ClickOnGingiva = 601,
        /// <summary>no contour of the field separates the tooth</summary>
        NoCut = 602,
        /// <summary>the linear system could not be factorised</summary>
        Solver = 603,
        /// <summary>the tooth is locked, and the call would change it</summary>
        Locked = 604,
        /// <summary>what is asked for is so already</summary>
        NoChange = 605,
        /// <summary>nothing to undo, or to redo</summary>
        NoHistory = 606,
        /// <summary>the edit would change nothing: a drag to where the point is, a stroke of no length</summary>
        EditNothing = 650,
        /// <summary>the new line would run on another tooth, or take in its feature points</summary>
        EditOnTooth = 651,
        /// <summary>the new line would cross the rest of the cut, or part the tooth's feature points from it</summary>
        EditCrossing = 652,
        /// <summary>the edit does not come near the cut that it is to change</summary>
        EditOffCut = 653,
        /// <summary>a loop of the cut would vanish, or become several</summary>
        EditNoLoop = 654,
        /// <summary>more teeth along the arch than the 16 that a jaw has</summary>
        TooManyTeeth = 700,
        /// <summary>a number of the other jaw</summary>
        NumberJaw = 701,
        /// <summary>the number has been set for another tooth</summary>
        NumberTaken = 702,
        /// <summary>numbers would not rise along the arch, or leave none for the teeth between</summary>
        NumberOrder = 703,
        /// <summary>a rim cannot be closed without the mesh running through itself</summary>
        NotClosed = 750,
    }

    /// <summary>How much a line of the log matters.</summary>
    public enum LogLevel : int
    {
        /// <summary>not used so far: a call that fails says so in its status</summary>
        Error = 0,
        /// <summary>the call did its work, and something about it is odd</summary>
        Warning = 1,
        /// <summary>what was found and how long it took</summary>
        Info = 2,
    }

    /// <summary>Type of the caller's coordinates.</summary>
    public enum Scalar : int
    {
        /// <summary>float</summary>
        Float32 = 0,
        /// <summary>double</summary>
        Float64 = 1,
    }

    /// <summary>Unit of the caller's coordinates. TS_UNIT_CHECKED_MM: mm, and TS_E_MESH_UNITS if the size of the mesh
    /// contradicts it (bounding box diagonal under 9 or over 400); the others convert without a check of the size, as
    /// long as coordinates stay within 1e9 mm. Distances of the library are of teeth in mm, whatever the size: on a
    /// surface over 400 mm across no teeth are found (TS_E_NO_TEETH), and parts under 0.5 mm are not closed
    /// (TS_E_NOT_CLOSED).</summary>
    public enum Unit : int
    {
        /// <summary>mm, checked</summary>
        CheckedMm = 0,
        /// <summary>mm, whatever the size</summary>
        Mm = 1,
        /// <summary>10 mm</summary>
        Cm = 2,
        /// <summary>1000 mm</summary>
        M = 3,
        /// <summary>25.4 mm</summary>
        Inch = 4,
    }

    /// <summary>Formats that are read.</summary>
    public enum FileFormat : int
    {
        /// <summary>told from the content, not from the name</summary>
        Auto = 0,
        /// <summary>binary or ASCII</summary>
        Stl = 1,
        /// <summary>ASCII, or binary of either byte order</summary>
        Ply = 2,
        /// <summary>`v` and `f` lines; the rest is passed over</summary>
        Obj = 3,
        /// <summary>ASCII; [ST][C][N]OFF</summary>
        Off = 4,
    }

    /// <summary>What the detection found odd about the scan as a whole. Results are there all the same, and may be
    /// wrong or not all there is.</summary>
    [Flags]
    public enum FeaturesWarnings : uint
    {
        None = 0,
        /// <summary>the faces look inwards: harmless</summary>
        InsideOut = 1,
        /// <summary>teeth look both ways: two jaws in occlusion, or the direction is wrong</summary>
        Opposed = 2,
        /// <summary>much that is as rough as teeth lies off the arch, or the arch is longer than any jaw's: two jaws
        /// side by side</summary>
        SeveralArches = 4,
    }

    /// <summary>What options are initialised to.</summary>
    public enum Preset : int
    {
        /// <summary>the best we know: docs/method.md</summary>
        Default = 0,
        /// <summary>the paper to the letter</summary>
        Paper = 1,
    }

    /// <summary>Weights of the Laplacian (paper, "Selection of weighting scheme"; Fig. 10).</summary>
    public enum Weights : int
    {
        /// <summary>beta + (1 - beta) exp(-c / c0), c the concavity at a physical radius</summary>
        Concavity = 0,
        /// <summary>Eq. 8 with the test of Eq. 9</summary>
        Paper = 1,
        /// <summary>paper ref. 39, negative cotangents clamped</summary>
        Cotangent = 2,
        /// <summary>1</summary>
        Uniform = 3,
        /// <summary>feature-preserving, as paper ref. 40: Eq. 8 without its test, so that every bend counts, convex or
        /// concave (the paper does not print the formula of ref. 40)</summary>
        Feature = 4,
    }

    /// <summary>What is held at the background value beside the neighbour tooth.</summary>
    public enum Background : int
    {
        /// <summary>nothing: the paper's pair</summary>
        Neighbour = 0,
        /// <summary>vertices far from every feature point</summary>
        Gingiva = 1,
        /// <summary>these, and the points of all other groups</summary>
        All = 2,
    }

    /// <summary>How the contour of a tooth is chosen.</summary>
    public enum CutRule : int
    {
        /// <summary>the paper's: largest mean gradient in [0, V_med] and (V_med, 1]</summary>
        Gradient = 0,
        /// <summary>the component around the seeds with the best concavity x gradient, and a tooth's area</summary>
        Component = 1,
        /// <summary>the contour half way between the tooth's value and the background's</summary>
        Half = 2,
    }

    /// <summary>What looks wrong about a tooth.</summary>
    [Flags]
    public enum ToothWarnings : uint
    {
        None = 0,
        /// <summary>under area_min</summary>
        AreaSmall = 1,
        /// <summary>over area_max</summary>
        AreaLarge = 2,
        /// <summary>the crown runs into a border of the scan</summary>
        OpenAtBorder = 4,
        /// <summary>the cut is not one closed line</summary>
        SeveralLoops = 8,
        /// <summary>no neighbour was there to be background</summary>
        NoNeighbour = 16,
        /// <summary>a feature point contradicted the field and was not used</summary>
        SeedRejected = 32,
        /// <summary>wider or narrower along the arch than a tooth is, or than its stretch of the arch</summary>
        Width = 64,
        /// <summary>a feature point of another group lies on it, before overlaps are resolved</summary>
        TwoGroups = 128,
        /// <summary>its top is one plane: a scan body or a post, not a crown</summary>
        FlatTop = 256,
        /// <summary>no feature group lies on it: the click alone says that it is a tooth</summary>
        MadeByClick = 512,
    }

    /// <summary>The jaw of a scan.</summary>
    public enum Jaw : int
    {
        /// <summary>not known</summary>
        Unknown = 0,
        /// <summary>maxilla</summary>
        Upper = 1,
        /// <summary>mandible</summary>
        Lower = 2,
    }

    /// <summary>What an edit did.</summary>
    public enum EditKind : int
    {
        /// <summary>ts_cut_drag</summary>
        Drag = 1,
        /// <summary>ts_cut_draw</summary>
        Draw = 2,
        /// <summary>ts_cut_offset</summary>
        Offset = 3,
        /// <summary>ts_cut_smooth</summary>
        Smooth = 4,
    }

    /// <summary>What a vertex is.</summary>
    [Flags]
    public enum MeshVertexFlags : uint
    {
        None = 0,
        /// <summary>shared with another part</summary>
        OnCut = 1,
        /// <summary>on a rim of the scan</summary>
        OnRim = 2,
        /// <summary>made to close the mesh</summary>
        OfFill = 4,
    }

    /// <summary>Formats that are written.</summary>
    public enum OutputFormat : int
    {
        /// <summary>binary; floats</summary>
        Stl = 0,
        /// <summary>binary; floats; red, green, blue (uchar) and label (int) a triangle</summary>
        Ply = 1,
        /// <summary>a group a part, of shared vertices</summary>
        Obj = 2,
        /// <summary>glTF 2.0 binary, in m as it has to be: a mesh and a node a part, floats</summary>
        Glb = 3,
    }

    /// <summary>What intake found and repaired. Counts of the caller's elements unless said otherwise.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct IntakeReport
    {
        internal uint StructSize;
        /// <summary>as given (a soup: 3 a face)</summary>
        public uint InputVertices;
        /// <summary>as given; polygons count once</summary>
        public uint InputFaces;
        /// <summary>input faces with more than 3 corners, triangulated</summary>
        public uint Polygons;
        /// <summary>input vertices merged into another</summary>
        public uint WeldedVertices;
        /// <summary>used by no face: dropped</summary>
        public uint UnreferencedVertices;
        /// <summary>fewer than 3 distinct corners, or no area: dropped</summary>
        public uint DegenerateFaces;
        /// <summary>same corners as another face: dropped</summary>
        public uint DuplicateFaces;
        /// <summary>wound against the majority of their piece: turned round</summary>
        public uint FlippedFaces;
        /// <summary>edges of more than 2 faces: split</summary>
        public uint NonManifoldEdges;
        /// <summary>vertices where several fans met: split</summary>
        public uint NonManifoldVertices;
        /// <summary>edges cut open because no winding fits both sides (Moebius)</summary>
        public uint UnorientableEdges;
        /// <summary>of the model</summary>
        public uint Vertices;
        /// <summary>of the model</summary>
        public uint Faces;
        /// <summary>connected pieces of the model</summary>
        public uint Components;
        /// <summary>open rims of the model</summary>
        public uint BoundaryLoops;
        /// <summary>of the bounding box, mm</summary>
        public double Diagonal;
        /// <summary>mm^2</summary>
        public double Area;
        /// <summary>mm</summary>
        public double MeanEdge;
    }

    /// <summary>A point on the surface: a model face and the weights of its three corners (sum 1).</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct SurfacePoint
    {
        /// <summary>of the model</summary>
        public uint Face;
        /// <summary>the corner with the largest weight</summary>
        public uint NearestVertex;
        /// <summary>weights of its corners, in their order</summary>
        public Point Barycentric;
        /// <summary>mm</summary>
        public Point Position;
        /// <summary>from the query position, or along the ray from its origin, mm</summary>
        public double Distance;
    }

    /// <summary>Counts of a set of features, and what the detection saw of the scan.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct FeaturesInfo
    {
        internal uint StructSize;
        /// <summary>number of groups</summary>
        public uint Groups;
        /// <summary>number of points in all of them</summary>
        public uint Points;
        internal uint inside_out;
        /// <summary>1 if the detection found that the faces look inwards; everything works all the same</summary>
        public bool InsideOut { get { return inside_out != 0; } }
        /// <summary>sum of ts_features_warning</summary>
        public FeaturesWarnings Warnings;
        internal uint Reserved;
        /// <summary>roughness that faces against the occlusal direction over that which faces with it: under .05 on
        /// most scans of one jaw, at most .33; .5 to 1 for two jaws in occlusion</summary>
        public double Opposed;
        /// <summary>share of the roughness within 14 mm of the arch curve: .9 and more on scans of one jaw</summary>
        public double Coverage;
        /// <summary>of the arch curve, mm: up to 180 on scans of one jaw</summary>
        public double ArchLength;
    }

    /// <summary>A feature point: where a tooth is held.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct FeaturePoint
    {
        /// <summary>stays the same while the point exists</summary>
        public uint Id;
        /// <summary>id of its group</summary>
        public uint Group;
        /// <summary>nearest model vertex</summary>
        public uint Vertex;
        internal uint by_hand;
        /// <summary>1 if the caller set it</summary>
        public bool ByHand { get { return by_hand != 0; } }
        /// <summary>mm</summary>
        public Point Position;
        /// <summary>dimensionless: 0 on a plane, 0.25 to 0.4 on a cusp; 0 for a point set by hand</summary>
        public double Convexity;
    }

    /// <summary>The feature points of a tooth.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct FeatureGroup
    {
        /// <summary>stays the same while the group exists</summary>
        public uint Id;
        /// <summary>number of points</summary>
        public uint Points;
        /// <summary>id of the neighbour group along the arch, TS_NONE at an end</summary>
        public uint Previous;
        /// <summary>the other one</summary>
        public uint Next;
        /// <summary>mean of its points, mm</summary>
        public Point Centre;
        /// <summary>where its tooth begins along the arch curve, mm; 0 if made by hand</summary>
        public double ArchFrom;
        /// <summary>where it ends, mm; 0 if made by hand</summary>
        public double ArchTo;
        /// <summary>0 to 1: how sure the detection is that this is one tooth; 1 if made by hand</summary>
        public double Confidence;
    }

    /// <summary>Milliseconds a stage took (paper, Fig. 11). With the default preset the field is solved where the cut
    /// looks at it: then `field` is the share of that in `cut` and `label`, and not added to `total` again.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ClickTimes
    {
        /// <summary>click to groups</summary>
        public double Pick;
        /// <summary>solve; of the slower of the two teeth where they are worked out at the same time</summary>
        public double Field;
        /// <summary>contours, selection, refinement</summary>
        public double Cut;
        /// <summary>lines and labels</summary>
        public double Label;
        /// <summary>of the call, but for its entry in the history</summary>
        public double Total;
    }

    /// <summary>What came of a click.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ClickInfo
    {
        internal uint StructSize;
        /// <summary>tooth clicked: id of its group</summary>
        public uint Target;
        /// <summary>tooth beside it; TS_NONE if there is but one. Where no cut was found for it, ts_get_tooth says
        /// TS_E_NOT_FOUND: the tooth clicked stands alone</summary>
        public uint Neighbour;
        /// <summary>the surface point taken, mm</summary>
        public Point Position;
        /// <summary>along the surface to the closest point of each, in the metric of the options</summary>
        public double TargetDistance;
        /// <summary>this and v_med are worked out when a click's info is first asked for</summary>
        public double NeighbourDistance;
        /// <summary>centre of the fullest bin (Fig. 4C)</summary>
        public double VMed;
        /// <summary>chosen iso-values</summary>
        public double TargetIso;
        /// <summary>NaN if there is no neighbour</summary>
        public double NeighbourIso;
        /// <summary>how long it took</summary>
        public ClickTimes Ms;
    }

    /// <summary>One iso-value's contour of a click's field (Fig. 4A).</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ContourInfo
    {
        /// <summary>the value</summary>
        public double Iso;
        /// <summary>mean of |grad u| along it, 1/mm</summary>
        public double Gradient;
        /// <summary>share of it in concave valleys, 0 to 1</summary>
        public double Concavity;
        /// <summary>mm</summary>
        public double Length;
        /// <summary>in all its polylines</summary>
        public uint Points;
        /// <summary>number of these</summary>
        public uint Polylines;
        /// <summary>1 = cut of the target, 2 = of the neighbour, 0 = neither</summary>
        public uint Chosen;
    }

    /// <summary>A point of a contour or cut: on the edge from model vertex `a` to `b`, at (1 - t) a + t b.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct EdgePoint
    {
        /// <summary>model vertex</summary>
        public uint A;
        /// <summary>model vertex</summary>
        public uint B;
        /// <summary>0 at a, 1 at b</summary>
        public double T;
        /// <summary>mm</summary>
        public Point Position;
    }

    /// <summary>A separated tooth. Its id is the id of its feature group, or of the group that a click made
    /// (ts_segment_click).</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ToothInfo
    {
        internal uint StructSize;
        /// <summary>of the tooth</summary>
        public uint Id;
        /// <summary>what ts_get_labels writes: place of its feature group along the arch counted from 1; of the n-th
        /// group made by a click the number of feature groups + n; not an FDI number</summary>
        public uint Label;
        /// <summary>the click that separated it (last)</summary>
        public uint Click;
        /// <summary>model faces</summary>
        public uint Faces;
        /// <summary>model vertices of these</summary>
        public uint Vertices;
        /// <summary>closed polylines of its cut</summary>
        public uint Loops;
        /// <summary>constraint points used</summary>
        public uint Seeds;
        /// <summary>mm^2</summary>
        public double Area;
        /// <summary>iso-value of the cut</summary>
        public double Iso;
        /// <summary>mean of |grad u| along it, 1/mm</summary>
        public double Gradient;
        /// <summary>0 to 1</summary>
        public double Confidence;
        /// <summary>sum of ts_tooth_warning</summary>
        public ToothWarnings Warnings;
        internal uint Reserved;
    }

    /// <summary>A loop of a cut.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct CutInfo
    {
        internal uint StructSize;
        /// <summary>number of these</summary>
        public uint Points;
        internal uint closed;
        /// <summary>1: the last point is joined to the first</summary>
        public bool Closed { get { return closed != 0; } }
        /// <summary>mm</summary>
        public double Length;
        /// <summary>iso-value it was chosen at</summary>
        public double Iso;
        /// <summary>mean of |grad u| along it, 1/mm</summary>
        public double Gradient;
        /// <summary>share of it in concave valleys, 0 to 1</summary>
        public double Concavity;
    }

    /// <summary>Milliseconds of the preparation.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct PrepareTimes
    {
        internal uint StructSize;
        internal uint Reserved;
        /// <summary>of the model</summary>
        public double Intake;
        /// <summary>of the detection; 0 if set by hand</summary>
        public double Features;
        /// <summary>curvature, concavity, weights</summary>
        public double Weights;
        /// <summary>constraints, ordering, factorisation</summary>
        public double Factorise;
    }

    /// <summary>Bytes that are kept. Most of them come from the context's allocator.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct MemoryInfo
    {
        internal uint StructSize;
        internal uint Reserved;
        /// <summary>of the model, which segmentations share</summary>
        public ulong Model;
        /// <summary>of what a segmentation keeps beside it, the factor included: what memory_limit bounds</summary>
        public ulong Segmentation;
        /// <summary>of the factor, as far as it is kept</summary>
        public ulong Factor;
        /// <summary>of the factor if all of it were</summary>
        public ulong FactorWhole;
        /// <summary>of the work space of one tooth; as many are kept as teeth were cut at the same time</summary>
        public ulong Click;
    }

    /// <summary>A tooth that wants a look.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ReviewItem
    {
        /// <summary>id of its group</summary>
        public uint Tooth;
        internal uint separated;
        /// <summary>0: no cut has been made for this group so far</summary>
        public bool Separated { get { return separated != 0; } }
        /// <summary>sum of ts_tooth_warning</summary>
        public ToothWarnings Warnings;
        internal uint Reserved;
        /// <summary>of the tooth, 0 to 1; 0 where it is not separated</summary>
        public double Confidence;
        /// <summary>that the group is exactly one tooth; 1 for groups made by hand</summary>
        public double GroupConfidence;
    }

    /// <summary>Faces that two teeth hold. In ts_get_labels they go to the tooth that is locked, or, where neither or
    /// both are, to the one whose nearest seed is nearer to the middle of the face; ts_get_tooth_faces has them for
    /// both.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Overlap
    {
        /// <summary>id of the tooth that they go to</summary>
        public uint Winner;
        /// <summary>id of the other one</summary>
        public uint Loser;
        /// <summary>of the model</summary>
        public uint Faces;
        internal uint Reserved;
        /// <summary>mm^2</summary>
        public double Area;
    }

    /// <summary>The steps that are kept.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct HistoryInfo
    {
        internal uint StructSize;
        /// <summary>steps that can be taken back</summary>
        public uint Undo;
        /// <summary>steps that can be brought again</summary>
        public uint Redo;
        internal uint complete;
        /// <summary>1: back to the beginning; 0: the limit has dropped the oldest</summary>
        public bool Complete { get { return complete != 0; } }
        /// <summary>about what the steps keep</summary>
        public ulong Bytes;
        /// <summary>how much they may (ts_set_history_limit)</summary>
        public ulong Limit;
    }

    /// <summary>The number of a tooth.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct NumberInfo
    {
        internal uint StructSize;
        /// <summary>the most probable, also where it is uncertain</summary>
        public uint Fdi;
        internal uint set_by_hand;
        /// <summary>1: by ts_set_number</summary>
        public bool SetByHand { get { return set_by_hand != 0; } }
        internal uint uncertain;
        /// <summary>1: confidence under least_confidence: to be shown to a person before it is used</summary>
        public bool Uncertain { get { return uncertain != 0; } }
        /// <summary>probability of this number, the jaw's included, under the model; 1 if set by hand</summary>
        public double Confidence;
    }

    /// <summary>The jaw that the numbers are of.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct JawInfo
    {
        internal uint StructSize;
        /// <summary>the more probable, also where it is uncertain</summary>
        public Jaw Jaw;
        internal uint given;
        /// <summary>1: by the options or by a number set by hand</summary>
        public bool Given { get { return given != 0; } }
        internal uint uncertain;
        /// <summary>1: confidence under least_confidence</summary>
        public bool Uncertain { get { return uncertain != 0; } }
        /// <summary>.5 where nothing tells; 1 if given</summary>
        public double Confidence;
    }

    /// <summary>A number as Palmer's notation has it.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct Palmer
    {
        internal uint StructSize;
        /// <summary>as in FDI: 1 upper right, 2 upper left, 3 lower left, 4 lower right</summary>
        public uint Quadrant;
        /// <summary>1 (central incisor) to 8</summary>
        public uint Position;
        internal fixed byte letters[4];
        /// <summary>"UR6"</summary>
        public string Letters { get { fixed (byte* text = letters) return Text.Decode(text, 4); } }
        internal fixed byte symbol[8];
        /// <summary>UTF-8: the position in the angle of its quadrant, as on a chart that faces the patient</summary>
        public string Symbol { get { fixed (byte* text = symbol) return Text.Decode(text, 8); } }
    }

    /// <summary>An edit that is kept.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct CutEdit
    {
        /// <summary>which of them</summary>
        public EditKind Kind;
        /// <summary>TS_OK: it shows in the cut; else why it was dropped when the tooth was last separated again. A
        /// dropped edit is tried again the next time</summary>
        public Status Status;
        /// <summary>2 of a drag, those of a stroke, 0 of the others</summary>
        public uint Points;
        internal uint Reserved;
        /// <summary>reach, mm or strength as given; 0 of a stroke</summary>
        public double Amount;
        /// <summary>of a drag where the cut was taken, of a stroke its first point, mm</summary>
        public Point From;
        /// <summary>of a drag where it was taken to, of a stroke its last point, mm</summary>
        public Point To;
    }

    /// <summary>Counts and measures of a mesh.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct MeshInfo
    {
        internal uint StructSize;
        /// <summary>ts_tooth_info::label, 0 of the gingiva</summary>
        public uint Label;
        /// <summary>number of vertices</summary>
        public uint Vertices;
        /// <summary>number of triangles</summary>
        public uint Triangles;
        /// <summary>of these, at the end: those that close it</summary>
        public uint FillTriangles;
        /// <summary>that it shares with other parts</summary>
        public uint CutVertices;
        /// <summary>0: watertight</summary>
        public uint OpenRims;
        /// <summary>rims that were closed</summary>
        public uint ClosedRims;
        /// <summary>connected pieces</summary>
        public uint Components;
        /// <summary>triangles left out at its rims, because the scan crosses itself there, or every membrane would
        /// cross them; only of closed meshes, up to 3 % of the area</summary>
        public uint Trimmed;
        /// <summary>of all triangles, mm^2</summary>
        public double Area;
        /// <summary>of those that close it, mm^2</summary>
        public double FillArea;
        /// <summary>mm^3; 0 while a rim is open</summary>
        public double Volume;
        /// <summary>of a tooth: what its cuts enclose and another tooth or the gingiva has, mm^2</summary>
        public double Lost;
    }

    /// <summary>Which way a tooth looks, and its extent that way over the faces of ts_get_tooth_faces.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe struct ToothFrame
    {
        internal uint StructSize;
        internal uint from_arch;
        /// <summary>1: mesial is along the arch curve; 0: there is none (features made by hand), and mesial is the
        /// direction in which the tooth is widest, to either side</summary>
        public bool FromArch { get { return from_arch != 0; } }
        /// <summary>of the area of its faces, mm</summary>
        public Point Centre;
        /// <summary>unit vector: that of the features</summary>
        public Point Occlusal;
        /// <summary>unit vector along the arch, at right angles to occlusal, towards the middle of the arch curve's
        /// length: the midline, where the scan is of a whole arch</summary>
        public Point Mesial;
        /// <summary>unit vector at right angles to both, away from the middle between the ends of the arch</summary>
        public Point Buccal;
        /// <summary>mesial-distal extent, mm</summary>
        public double Width;
        /// <summary>buccal-lingual extent, mm</summary>
        public double Depth;
        /// <summary>occlusal-gingival extent of what the scan shows of the crown, mm</summary>
        public double Height;
    }

    /// <summary>How a mesh is taken in.</summary>
    public sealed unsafe class IntakeOptions
    {
        internal ts_intake_options Value;

        public IntakeOptions()
        {
            ts_intake_options value;
            ToothsegException.Check(Native.ts_intake_options_init(&value, (uint)sizeof(ts_intake_options)));
            Value = value;
        }
        /// <summary>default TS_UNIT_CHECKED_MM</summary>
        public Unit Unit { get { return Value.unit; } set { Value.unit = value; } }
        /// <summary>vertices closer than this become one, mm. Default 0: only exactly equal ones</summary>
        public double WeldTolerance { get { return Value.weld_tolerance; } set { Value.weld_tolerance = value; } }
    }

    /// <summary>How features are found.</summary>
    public sealed unsafe class FeatureOptions
    {
        internal ts_feature_options Value;

        public FeatureOptions()
        {
            ts_feature_options value;
            ToothsegException.Check(Native.ts_feature_options_init(&value, (uint)sizeof(ts_feature_options)));
            Value = value;
        }
        /// <summary>most points a tooth. Default 8</summary>
        public uint MaxPoints { get { return Value.max_points; } set { Value.max_points = value; } }
        /// <summary>a direction to use instead of the estimated one; 0,0,0 = estimate (default)</summary>
        public Point Occlusal { get { return Value.occlusal; } set { Value.occlusal = value; } }
        /// <summary>r of the convexity measure, mm. Default 2.0: about half a cusp's width</summary>
        public double Radius { get { return Value.radius; } set { Value.radius = value; } }
    }

    /// <summary>Defaults are given as: default preset / paper preset.</summary>
    public sealed unsafe class SegmentOptions
    {
        internal ts_segment_options Value;

        public SegmentOptions() : this(default(Preset)) { }
        public SegmentOptions(Preset preset)
        {
            ts_segment_options value;
            ToothsegException.Check(Native.ts_segment_options_init(&value, (uint)sizeof(ts_segment_options), preset));
            Value = value;
        }
        /// <summary>what the options were initialised to; informative</summary>
        public Preset Preset { get { return Value.preset; } set { Value.preset = value; } }
        /// <summary>CONCAVITY / PAPER</summary>
        public Weights Weights { get { return Value.weights; } set { Value.weights = value; } }
        /// <summary>ALL / NEIGHBOUR</summary>
        public Background Background { get { return Value.background; } set { Value.background = value; } }
        /// <summary>COMPONENT / GRADIENT</summary>
        public CutRule CutRule { get { return Value.cut_rule; } set { Value.cut_rule = value; } }
        /// <summary>number of iso-values sampled in (0, 1) (Fig. 4A). 100 / 100</summary>
        public uint Contours { get { return Value.contours; } set { Value.contours = value; } }
        /// <summary>of Fig. 4C. 50 / 50</summary>
        public uint HistogramBins { get { return Value.histogram_bins; } set { Value.histogram_bins = value; } }
        /// <summary>most constraint points used a tooth (Figs. 2, 3); 0 = all. 0 / 0</summary>
        public uint PointsPerGroup { get { return Value.points_per_group; } set { Value.points_per_group = value; } }
        /// <summary>penalty of Eq. 6; 0 = exact constraints. 1e8 / 1e8</summary>
        public double Alpha { get { return Value.alpha; } set { Value.alpha = value; } }
        /// <summary>factor of a concave edge (Eq. 8), least weight of CONCAVITY. 1e-3 / 0.01</summary>
        public double Beta { get { return Value.beta; } set { Value.beta = value; } }
        /// <summary>added to the divisor of Eq. 8. 1e-4 / 1e-4</summary>
        public double Gamma { get { return Value.gamma; } set { Value.gamma = value; } }
        /// <summary>threshold of Eq. 9. 0.2 / 0.001</summary>
        public double Theta { get { return Value.theta; } set { Value.theta = value; } }
        /// <summary>decay of the CONCAVITY weights, 1/mm. 0.07</summary>
        public double C0 { get { return Value.c0; } set { Value.c0 = value; } }
        /// <summary>r of the smoothed normals, mm. 0.15</summary>
        public double NormalRadius { get { return Value.normal_radius; } set { Value.normal_radius = value; } }
        /// <summary>a constraint point is a disc of this radius, mm; 0 = one vertex. 0.7 / 0</summary>
        public double SeedRadius { get { return Value.seed_radius; } set { Value.seed_radius = value; } }
        /// <summary>from every feature point, mm, at which gingiva begins for certain. 13</summary>
        public double GingivaDistance { get { return Value.gingiva_distance; } set { Value.gingiva_distance = value; } }
        /// <summary>least area of a tooth, mm^2, for COMPONENT and for warnings. 25 / 25</summary>
        public double AreaMin { get { return Value.area_min; } set { Value.area_min = value; } }
        /// <summary>largest area of a tooth, mm^2. 330 / 330</summary>
        public double AreaMax { get { return Value.area_max; } set { Value.area_max = value; } }
        /// <summary>holes in a tooth's region up to this are filled, mm^2. 40 / 0</summary>
        public double HoleArea { get { return Value.hole_area; } set { Value.hole_area = value; } }
        /// <summary>half width of the band of the min-cut refinement, mm; 0 = none. 2.5 / 0</summary>
        public double RefineBand { get { return Value.refine_band; } set { Value.refine_band = value; } }
        /// <summary>smoothing of the final line, mm; 0 = none. 0.2 / 0</summary>
        public double SmoothRadius { get { return Value.smooth_radius; } set { Value.smooth_radius = value; } }
        /// <summary>a click further from the surface than this is off it, mm. 2 / 2</summary>
        public double ClickReach { get { return Value.click_reach; } set { Value.click_reach = value; } }
        /// <summary>geodesic cost |e| (1 + this * concavity) from click to points. 60 / 0</summary>
        public double ClickConcavity { get { return Value.click_concavity; } set { Value.click_concavity = value; } }
        /// <summary>1 = free feature points that contradict the field. 1 / 0</summary>
        public bool RejectOutliers { get { return Value.reject_outliers != 0; } set { Value.reject_outliers = value ? 1u : 0u; } }
        /// <summary>bytes that the segmentation may keep beside the model, clicks' results and work space left out
        /// (ts_get_memory); 0 = no limit. What does not fit of the factor is worked out again by each click that needs
        /// it: slower, the same bytes. 0 / 0</summary>
        public ulong MemoryLimit { get { return Value.memory_limit; } set { Value.memory_limit = value; } }
    }

    /// <summary>How numbers are told.</summary>
    public sealed unsafe class NumberOptions
    {
        internal ts_number_options Value;

        public NumberOptions()
        {
            ts_number_options value;
            ToothsegException.Check(Native.ts_number_options_init(&value, (uint)sizeof(ts_number_options)));
            Value = value;
        }
        /// <summary>UNKNOWN (default): estimated</summary>
        public Jaw Jaw { get { return Value.jaw; } set { Value.jaw = value; } }
        /// <summary>1: the scan is a mirror image of the patient, so left and right change places. No scan shows
        /// whether it is one. Default 0</summary>
        public bool Mirrored { get { return Value.mirrored != 0; } set { Value.mirrored = value ? 1u : 0u; } }
        /// <summary>0 to 1: a number or a jaw under it is uncertain. Default 0.9</summary>
        public double LeastConfidence { get { return Value.least_confidence; } set { Value.least_confidence = value; } }
    }

    /// <summary>How meshes of teeth are made.</summary>
    public sealed unsafe class ToothMeshOptions
    {
        internal ts_tooth_mesh_options Value;

        public ToothMeshOptions()
        {
            ts_tooth_mesh_options value;
            ToothsegException.Check(Native.ts_tooth_mesh_options_init(&value, (uint)sizeof(ts_tooth_mesh_options)));
            Value = value;
        }
        /// <summary>1: all rims are closed by smooth membranes, those of the scan (holes, open ends) as well. Default
        /// 0</summary>
        public bool Closed { get { return Value.closed != 0; } set { Value.closed = value ? 1u : 0u; } }
    }

    /// <summary>How a segmentation is written.</summary>
    public sealed unsafe class SaveOptions
    {
        internal ts_save_options Value;

        public SaveOptions()
        {
            ts_save_options value;
            ToothsegException.Check(Native.ts_save_options_init(&value, (uint)sizeof(ts_save_options)));
            Value = value;
        }
        /// <summary>1: the model's faces as they are, each of the tooth that ts_get_labels says. Default 0: split along
        /// the cuts</summary>
        public bool WholeFaces { get { return Value.whole_faces != 0; } set { Value.whole_faces = value ? 1u : 0u; } }
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ts_context_options
    {
        internal uint struct_size;
        internal uint threads;
        internal IntPtr alloc;
        internal IntPtr free;
        internal void* alloc_user;
        internal IntPtr log;
        internal void* log_user;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ts_mesh_input
    {
        internal uint struct_size;
        internal Scalar scalar;
        internal void* positions;
        internal uint vertex_count;
        internal uint stride;
        internal uint* triangles;
        internal uint triangle_count;
        internal uint reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ts_intake_options
    {
        internal uint struct_size;
        internal Unit unit;
        internal double weld_tolerance;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ts_feature_options
    {
        internal uint struct_size;
        internal uint max_points;
        internal Point occlusal;
        internal double radius;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ts_segment_options
    {
        internal uint struct_size;
        internal Preset preset;
        internal Weights weights;
        internal Background background;
        internal CutRule cut_rule;
        internal uint contours;
        internal uint histogram_bins;
        internal uint points_per_group;
        internal double alpha;
        internal double beta;
        internal double gamma;
        internal double theta;
        internal double c0;
        internal double normal_radius;
        internal double seed_radius;
        internal double gingiva_distance;
        internal double area_min;
        internal double area_max;
        internal double hole_area;
        internal double refine_band;
        internal double smooth_radius;
        internal double click_reach;
        internal double click_concavity;
        internal uint reject_outliers;
        internal ulong memory_limit;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ts_number_options
    {
        internal uint struct_size;
        internal Jaw jaw;
        internal uint mirrored;
        internal uint reserved;
        internal double least_confidence;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ts_tooth_mesh_options
    {
        internal uint struct_size;
        internal uint closed;
    }

    [StructLayout(LayoutKind.Sequential)]
    internal unsafe struct ts_save_options
    {
        internal uint struct_size;
        internal uint whole_faces;
    }

    internal sealed class ContextHandle : Handle
    {
        internal ContextHandle(Hooks? hooks) : base(hooks) { }
        protected override void Destroy(IntPtr native) { Native.ts_context_destroy(native); }
    }

    internal sealed class JobHandle : Handle
    {
        internal JobHandle(Hooks? hooks) : base(hooks) { }
        protected override void Destroy(IntPtr native) { Native.ts_job_destroy(native); }
    }

    internal sealed class ModelHandle : Handle
    {
        internal ModelHandle(Hooks? hooks) : base(hooks) { }
        protected override void Destroy(IntPtr native) { Native.ts_model_destroy(native); }
    }

    internal sealed class FeaturesHandle : Handle
    {
        internal FeaturesHandle(Hooks? hooks) : base(hooks) { }
        protected override void Destroy(IntPtr native) { Native.ts_features_destroy(native); }
    }

    internal sealed class SegmentationHandle : Handle
    {
        internal SegmentationHandle(Hooks? hooks) : base(hooks) { }
        protected override void Destroy(IntPtr native) { Native.ts_segmentation_destroy(native); }
    }

    internal sealed class MeshHandle : Handle
    {
        internal MeshHandle(Hooks? hooks) : base(hooks) { }
        protected override void Destroy(IntPtr native) { Native.ts_mesh_destroy(native); }
    }

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal unsafe delegate void* ts_alloc_fn(UIntPtr bytes, void* user);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal unsafe delegate void ts_free_fn(void* memory, void* user);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal unsafe delegate void ts_log_fn(LogLevel level, byte* text, void* user);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal unsafe delegate int ts_progress_fn(double fraction, byte* stage, void* user);

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    internal unsafe delegate void ts_change_fn(void* user, uint* teeth, uint count);

    internal static unsafe class Native
    {
        private const string Library = "toothseg";

        internal const uint TS_VERSION_MAJOR = 0u;
        internal const uint TS_VERSION_MINOR = 1u;
        internal const uint TS_VERSION_PATCH = 0u;
        internal const uint TS_NONE = 4294967295u;

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern byte* ts_version();

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern byte* ts_status_name(Status status);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern byte* ts_last_error_message();

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_context_options_init(ts_context_options* options, uint struct_size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_context_create(ts_context_options* options, IntPtr* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ts_context_destroy(IntPtr context);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_job_create(ContextHandle context, IntPtr progress, void* user, IntPtr* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ts_job_cancel(JobHandle job);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ts_job_reset(JobHandle job);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern double ts_job_progress(JobHandle job);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ts_job_destroy(IntPtr job);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_mesh_input_init(ts_mesh_input* input, uint struct_size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_intake_options_init(ts_intake_options* options, uint struct_size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_model_create(ContextHandle context, ts_mesh_input* input, ts_intake_options* options, JobHandle job, IntPtr* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_model_load(ContextHandle context, byte* path, ts_intake_options* options, JobHandle job, IntPtr* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_model_read(ContextHandle context, void* bytes, UIntPtr size, FileFormat format, ts_intake_options* options, JobHandle job, IntPtr* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ts_model_destroy(IntPtr model);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_model_get_report(ModelHandle model, IntakeReport* report);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_model_get_positions(ModelHandle model, double* xyz, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_model_get_triangles(ModelHandle model, uint* triangles, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_model_get_face_sources(ModelHandle model, uint* input_face, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_model_get_vertex_map(ModelHandle model, uint* model_vertex, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_model_nearest(ModelHandle model, Point* position, SurfacePoint* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_model_raycast(ModelHandle model, Point* origin, Point* direction, SurfacePoint* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_feature_options_init(ts_feature_options* options, uint struct_size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_detect_features(ModelHandle model, ts_feature_options* options, JobHandle job, IntPtr* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_features_create(ModelHandle model, IntPtr* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_features_clone(FeaturesHandle features, IntPtr* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ts_features_destroy(IntPtr features);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_features_get_info(FeaturesHandle features, FeaturesInfo* info);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_features_get_occlusal(FeaturesHandle features, Point* direction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_features_set_occlusal(FeaturesHandle features, Point* direction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_features_get_arch(FeaturesHandle features, double* xyz, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_features_get_points(FeaturesHandle features, FeaturePoint* points, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_features_get_groups(FeaturesHandle features, FeatureGroup* groups, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_features_add_point(FeaturesHandle features, Point* position, uint group, uint* point, uint* group_out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_features_move_point(FeaturesHandle features, uint point, Point* position);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_features_set_group(FeaturesHandle features, uint point, uint group, uint* group_out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_features_remove_point(FeaturesHandle features, uint point);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_features_remove_group(FeaturesHandle features, uint group);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_segment_options_init(ts_segment_options* options, uint struct_size, Preset preset);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_segmentation_create(FeaturesHandle features, ts_segment_options* options, JobHandle job, IntPtr* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ts_segmentation_destroy(IntPtr segmentation);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_segment_click(SegmentationHandle segmentation, Point* position, JobHandle job, uint* click);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_segment_clicks(SegmentationHandle segmentation, double* positions, uint count, JobHandle job, Status* statuses);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_propose_clicks(SegmentationHandle segmentation, double* positions, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_click_count(SegmentationHandle segmentation, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_click(SegmentationHandle segmentation, uint click, ClickInfo* info);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_field(SegmentationHandle segmentation, uint click, double* u, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_histogram(SegmentationHandle segmentation, uint click, uint* bins, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_contours(SegmentationHandle segmentation, uint click, ContourInfo* contours, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_contour_points(SegmentationHandle segmentation, uint click, uint contour, EdgePoint* points, uint capacity, uint* count, uint* starts, byte* closed);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_teeth(SegmentationHandle segmentation, uint* teeth, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_tooth(SegmentationHandle segmentation, uint tooth, ToothInfo* info);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_tooth_faces(SegmentationHandle segmentation, uint tooth, uint* faces, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_tooth_vertices(SegmentationHandle segmentation, uint tooth, uint* vertices, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_tooth_seeds(SegmentationHandle segmentation, uint tooth, uint* vertices, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_cut(SegmentationHandle segmentation, uint tooth, uint loop, CutInfo* info, EdgePoint* points, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_labels(SegmentationHandle segmentation, uint* labels, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_prepare_times(SegmentationHandle segmentation, PrepareTimes* times);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_memory(SegmentationHandle segmentation, MemoryInfo* info);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_segment_all(SegmentationHandle segmentation, JobHandle job);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_review(SegmentationHandle segmentation, ReviewItem* items, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_tooth_include(SegmentationHandle segmentation, uint tooth, Point* position, JobHandle job);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_tooth_exclude(SegmentationHandle segmentation, uint tooth, Point* position, JobHandle job);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_tooth_split(SegmentationHandle segmentation, uint tooth, Point* keep, Point* part, JobHandle job, uint* second);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_tooth_move_point(SegmentationHandle segmentation, uint tooth, Point* from, Point* to, JobHandle job);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_tooth_merge(SegmentationHandle segmentation, uint tooth, uint other, JobHandle job);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_tooth_remove(SegmentationHandle segmentation, uint tooth);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_tooth_set_locked(SegmentationHandle segmentation, uint tooth, uint locked);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_tooth_get_locked(SegmentationHandle segmentation, uint tooth, uint* locked);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_overlaps(SegmentationHandle segmentation, Overlap* overlaps, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_undo(SegmentationHandle segmentation);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_redo(SegmentationHandle segmentation);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_history(SegmentationHandle segmentation, HistoryInfo* info);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_set_history_limit(SegmentationHandle segmentation, ulong bytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_changes(SegmentationHandle segmentation, uint* teeth, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_set_change_callback(SegmentationHandle segmentation, IntPtr callback, void* user);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_session_write(SegmentationHandle segmentation, byte* text, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_session_save(SegmentationHandle segmentation, byte* path);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_session_read(ModelHandle model, byte* text, UIntPtr size, JobHandle job, IntPtr* features, IntPtr* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_session_load(ModelHandle model, byte* path, JobHandle job, IntPtr* features, IntPtr* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_number_options_init(ts_number_options* options, uint struct_size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_assign_numbers(SegmentationHandle segmentation, ts_number_options* options);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_set_number(SegmentationHandle segmentation, uint tooth, uint fdi);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_number(SegmentationHandle segmentation, uint tooth, NumberInfo* info);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_jaw(SegmentationHandle segmentation, JawInfo* info);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_fdi_to_universal(uint fdi, uint* universal);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_universal_to_fdi(uint universal, uint* fdi);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_fdi_to_palmer(uint fdi, Palmer* palmer);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_cut_drag(SegmentationHandle segmentation, uint tooth, uint loop, uint point, Point* to, double reach, JobHandle job);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_cut_draw(SegmentationHandle segmentation, uint tooth, double* points, uint count, JobHandle job);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_cut_offset(SegmentationHandle segmentation, uint tooth, double mm, JobHandle job);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_cut_smooth(SegmentationHandle segmentation, uint tooth, double strength, JobHandle job);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_cut_reset(SegmentationHandle segmentation, uint tooth);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_cut_edits(SegmentationHandle segmentation, uint tooth, CutEdit* edits, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_tooth_mesh_options_init(ts_tooth_mesh_options* options, uint struct_size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_tooth_mesh_create(SegmentationHandle segmentation, uint tooth, ts_tooth_mesh_options* options, JobHandle job, IntPtr* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_gingiva_mesh_create(SegmentationHandle segmentation, ts_tooth_mesh_options* options, JobHandle job, IntPtr* @out);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern void ts_mesh_destroy(IntPtr mesh);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_mesh_get_info(MeshHandle mesh, MeshInfo* info);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_mesh_get_positions(MeshHandle mesh, double* xyz, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_mesh_get_normals(MeshHandle mesh, double* xyz, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_mesh_get_triangles(MeshHandle mesh, uint* triangles, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_mesh_get_faces(MeshHandle mesh, uint* faces, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_mesh_get_vertex_flags(MeshHandle mesh, byte* flags, uint capacity, uint* count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_mesh_save(MeshHandle mesh, byte* path, OutputFormat format, JobHandle job);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_save_options_init(ts_save_options* options, uint struct_size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_segmentation_save(SegmentationHandle segmentation, byte* path, OutputFormat format, ts_save_options* options, JobHandle job);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        internal static extern Status ts_get_tooth_frame(SegmentationHandle segmentation, uint tooth, ToothFrame* frame);
    }
}
