using System;
using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>The views of the cameras that draw a fluid, and those that were replaced while their draws wait in Unity's queue.</summary>
    sealed class CameraViews<T> : IDisposable where T : CameraView
    {
        readonly Func<Camera, T> make;
        readonly CameraParts<T> views = new CameraParts<T>();
        readonly List<T> replaced = new List<T>();

        public CameraViews(Func<Camera, T> make) => this.make = make;

        public int Count => views.Count;
        public T this[int index] => views[index];

        /// <summary>The view of a camera; null where it has none.</summary>
        public T Find(Camera camera) => views.Find(camera);

        /// <summary>The view of a camera; made when it first asks. Those of cameras that draw no more are given back.</summary>
        public T ViewOf(Camera camera)
        {
            T found = views.Find(camera);
            if (found == null)
                views.Add(found = make(camera));
            found.LastFrame = Time.frameCount;
            return found;
        }

        /// <summary>Hides the draws of this camera that are left from this frame, until they are recorded again.</summary>
        public void TurnOff(Camera camera) => views.Find(camera)?.TurnOff();

        /// <summary>Whether the picture that the camera draws now was prepared.</summary>
        public bool IsPreparedFor(Camera camera) => views.Find(camera) is T view && view.IsPrepared;

        /// <summary>Another view for the same camera. The draw that waits goes on holding what it has, and shows nothing.</summary>
        public T Replace(T view)
        {
            views.Remove(view);
            replaced.Add(view);
            return ViewOf(view.Camera);
        }

        /// <summary>Gives back those that were replaced and whose draws wait no more.</summary>
        public void DisposeReplaced()
        {
            for (int i = replaced.Count - 1; i >= 0; i--)
            {
                if (replaced[i].IsSubmitted)
                    continue;
                replaced[i].Dispose();
                replaced.RemoveAt(i);
            }
        }

        /// <summary>Once a frame: gives back what belongs to cameras that have not seen the fluid lately.</summary>
        public void ReleaseUnused()
        {
            views.RemoveGone();
            DisposeReplaced();
        }

        public void Dispose()
        {
            views.Clear();
            foreach (T view in replaced)
                view.Dispose();
            replaced.Clear();
        }
    }
}
