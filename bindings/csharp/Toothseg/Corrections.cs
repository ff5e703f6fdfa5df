// SPDX-License-Identifier: Apache-2.0
#nullable enable
using System;

namespace Toothseg
{
    // Corrections of a tooth and edits of its cut. Positions are mm, on the surface.
    public sealed unsafe partial class Segmentation
    {
        /// <summary>"This too".</summary>
        public void Include(uint tooth, Point position, Job? job = null)
        {
            Check(Native.ts_tooth_include(Handle, tooth, &position, Job.Of(job)), job);
        }

        /// <summary>"Not this".</summary>
        public void Exclude(uint tooth, Point position, Job? job = null)
        {
            Check(Native.ts_tooth_exclude(Handle, tooth, &position, Job.Of(job)), job);
        }

        /// <summary>Two teeth of one; returns the id of the new one.</summary>
        public uint Split(uint tooth, Point keep, Point part, Job? job = null)
        {
            uint second;
            Check(Native.ts_tooth_split(Handle, tooth, &keep, &part, Job.Of(job), &second), job);
            return second;
        }

        /// <summary>Moves a feature point of the tooth.</summary>
        public void MovePoint(uint tooth, Point from, Point to, Job? job = null)
        {
            Check(Native.ts_tooth_move_point(Handle, tooth, &from, &to, Job.Of(job)), job);
        }

        /// <summary>One tooth of two.</summary>
        public void Merge(uint tooth, uint other, Job? job = null)
        {
            Check(Native.ts_tooth_merge(Handle, tooth, other, Job.Of(job)), job);
        }

        /// <summary>As if the tooth had not been separated.</summary>
        public void Remove(uint tooth) { Check(Native.ts_tooth_remove(Handle, tooth)); }

        public void SetLocked(uint tooth, bool locked) { Check(Native.ts_tooth_set_locked(Handle, tooth, locked ? 1u : 0u)); }

        public bool IsLocked(uint tooth)
        {
            uint locked;
            ToothsegException.Check(Native.ts_tooth_get_locked(Handle, tooth, &locked));
            return locked != 0;
        }

        /// <summary>Takes a point of the cut to another place. Reach: half the length that follows, mm; 0: as long as the drag.</summary>
        public void DragCut(uint tooth, uint loop, uint point, Point to, double reach = 0, Job? job = null)
        {
            Check(Native.ts_cut_drag(Handle, tooth, loop, point, &to, reach, Job.Of(job)), job);
        }

        /// <summary>Draws a stretch of the cut anew.</summary>
        public void DrawCut(uint tooth, Point[] stroke, Job? job = null)
        {
            if (stroke == null) throw new ArgumentNullException("stroke");
            fixed (Point* first = stroke.Length == 0 ? new Point[1] : stroke)
                Check(Native.ts_cut_draw(Handle, tooth, (double*)first, (uint)stroke.Length, Job.Of(job)), job);
        }

        /// <summary>Moves the whole cut along the surface, outwards where positive.</summary>
        public void OffsetCut(uint tooth, double mm, Job? job = null)
        {
            Check(Native.ts_cut_offset(Handle, tooth, mm, Job.Of(job)), job);
        }

        /// <summary>Straightens what bends within less than `strength`, mm.</summary>
        public void SmoothCut(uint tooth, double strength, Job? job = null)
        {
            Check(Native.ts_cut_smooth(Handle, tooth, strength, Job.Of(job)), job);
        }

        /// <summary>The cut of the click again.</summary>
        public void ResetCut(uint tooth) { Check(Native.ts_cut_reset(Handle, tooth)); }

        public CutEdit[] GetCutEdits(uint tooth)
        {
            return Elements.All<CutEdit>((to, room, count) => Native.ts_get_cut_edits(Handle, tooth, (CutEdit*)to, room, count));
        }
    }
}
