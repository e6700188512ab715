using System;
using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>Part that each camera has of its own.</summary>
    interface ICameraPart : IDisposable
    {
        Camera Camera { get; }

        /// <summary>Whether it is needed no more: as a rule because the camera is destroyed.</summary>
        bool IsGone { get; }
    }

    /// <summary>A part for each camera that has one.</summary>
    sealed class CameraParts<T> where T : class, ICameraPart
    {
        readonly List<T> parts = new List<T>();

        public int Count => parts.Count;
        public T this[int index] => parts[index];

        public void Add(T part) => parts.Add(part);

        /// <summary>Hands it over: it is not disposed.</summary>
        public void Remove(T part) => parts.Remove(part);

        /// <summary>Disposes those of other cameras that are gone.</summary>
        /// <returns>The camera's part; null where it has none.</returns>
        public T Find(Camera camera)
        {
            RemoveGone(camera);
            for (int i = 0; i < parts.Count; i++)
                if (ReferenceEquals(parts[i].Camera, camera))
                    return parts[i];
            return null;
        }

        /// <summary>Disposes those that are gone.</summary>
        /// <param name="kept">A camera whose part stays; null for none.</param>
        public void RemoveGone(Camera kept = null)
        {
            for (int i = parts.Count - 1; i >= 0; i--)
                if (!ReferenceEquals(parts[i].Camera, kept) && parts[i].IsGone)
                {
                    parts[i].Dispose();
                    parts.RemoveAt(i);
                }
        }

        /// <summary>Disposes all.</summary>
        public void Clear()
        {
            foreach (T part in parts)
                part.Dispose();
            parts.Clear();
        }
    }
}
