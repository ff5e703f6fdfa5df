// SPDX-License-Identifier: Apache-2.0
#nullable enable
using System;

namespace Toothseg
{
    /// <summary>Feature points of the teeth in groups, one a tooth, with the occlusal direction and the arch curve.</summary>
    public sealed unsafe class Features : IDisposable
    {
        internal readonly FeaturesHandle Handle;

        internal Features(FeaturesHandle handle) { Handle = handle; }

        /// <summary>An empty set, to be filled by hand.</summary>
        public Features(Model model)
        {
            if (model == null) throw new ArgumentNullException("model");
            Handle = Toothseg.Handle.Make(new FeaturesHandle(model.Handle.Hooks), null,
                made => Native.ts_features_create(model.Handle, made));
        }

        /// <summary>Finds the features of a model.</summary>
        public static Features Detect(Model model, FeatureOptions? options = null, Job? job = null)
        {
            if (model == null) throw new ArgumentNullException("model");
            ts_feature_options native = (options ?? new FeatureOptions()).Value;
            ts_feature_options* given = &native;
            return new Features(Toothseg.Handle.Make(new FeaturesHandle(model.Handle.Hooks), job,
                made => Native.ts_detect_features(model.Handle, given, Job.Of(job), made)));
        }

        /// <summary>A copy to be edited.</summary>
        public Features Clone()
        {
            return new Features(Toothseg.Handle.Make(new FeaturesHandle(Handle.Hooks), null,
                made => Native.ts_features_clone(Handle, made)));
        }

        public void Dispose() { Handle.Dispose(); }

        public FeaturesInfo GetInfo()
        {
            var info = new FeaturesInfo { StructSize = (uint)sizeof(FeaturesInfo) };
            ToothsegException.Check(Native.ts_features_get_info(Handle, &info));
            return info;
        }

        /// <summary>The unit vector from the gums to the biting surface.</summary>
        public Point Occlusal
        {
            get
            {
                Point direction;
                ToothsegException.Check(Native.ts_features_get_occlusal(Handle, &direction));
                return direction;
            }
            set { ToothsegException.Check(Native.ts_features_set_occlusal(Handle, &value)); }
        }

        /// <summary>The arch curve from one end to the other.</summary>
        public Point[] GetArch()
        {
            return Elements.All<Point>((to, room, count) => Native.ts_features_get_arch(Handle, (double*)to, room, count));
        }

        /// <summary>All points, in the order of their groups.</summary>
        public FeaturePoint[] GetPoints()
        {
            return Elements.All<FeaturePoint>((to, room, count) => Native.ts_features_get_points(Handle, (FeaturePoint*)to, room, count));
        }

        /// <summary>All groups, in the order of the arch.</summary>
        public FeatureGroup[] GetGroups()
        {
            return Elements.All<FeatureGroup>((to, room, count) => Native.ts_features_get_groups(Handle, (FeatureGroup*)to, room, count));
        }

        /// <summary>Adds a point to a group, or to a new one; returns the id of the point.</summary>
        public uint AddPoint(Point position, uint group = Library.None)
        {
            uint unused;
            return AddPoint(position, group, out unused);
        }

        public uint AddPoint(Point position, uint group, out uint groupOfPoint)
        {
            uint point, its;
            ToothsegException.Check(Native.ts_features_add_point(Handle, &position, group, &point, &its));
            groupOfPoint = its;
            return point;
        }

        public void MovePoint(uint point, Point position)
        {
            ToothsegException.Check(Native.ts_features_move_point(Handle, point, &position));
        }

        /// <summary>Puts a point into another group, or a new one; returns the group.</summary>
        public uint SetGroup(uint point, uint group = Library.None)
        {
            uint its;
            ToothsegException.Check(Native.ts_features_set_group(Handle, point, group, &its));
            return its;
        }

        public void RemovePoint(uint point) { ToothsegException.Check(Native.ts_features_remove_point(Handle, point)); }

        public void RemoveGroup(uint group) { ToothsegException.Check(Native.ts_features_remove_group(Handle, group)); }
    }
}
