using System;
using UnityEngine;

namespace UnityEditor.IMGUI.Controls
{
    /// <summary>Handles on the faces of a shape. Nobody drags them here, except through <see cref="Drag"/>.</summary>
    public abstract class PrimitiveBoundsHandle
    {
        [Flags] public enum Axes { None = 0, X = 1, Y = 2, Z = 4, All = X | Y | Z }
        protected enum HandleDirection { PositiveX, NegativeX, PositiveY, NegativeY, PositiveZ, NegativeZ }

        /// <summary>For tests: called where a handle is drawn; true says that it was dragged, after it was given other bounds.</summary>
        internal static Func<PrimitiveBoundsHandle, bool> Drag;

        Vector3 size;

        public PrimitiveBoundsHandle() { }

        public Vector3 center { get; set; }
        public Axes axes { get; set; } = Axes.All;
        public Color handleColor { get; set; } = Color.white;
        public Color wireframeColor { get; set; } = Color.white;

        public void SetColor(Color color)
        {
            handleColor = color;
            wireframeColor = color;
        }

        public void DrawHandle()
        {
            DrawWireframe();
            if (Drag != null && Drag(this))
                GUI.changed = true;
        }

        protected abstract void DrawWireframe();
        protected virtual Bounds OnHandleChanged(HandleDirection handle, Bounds boundsOnClick, Bounds newBounds) => newBounds;
        protected Vector3 GetSize() => size;
        protected void SetSize(Vector3 size) => this.size = new Vector3(Math.Abs(size.x), Math.Abs(size.y), Math.Abs(size.z));
        protected bool IsAxisEnabled(Axes axis) => (axes & axis) == axis;
        protected bool IsAxisEnabled(int vector3Axis) => IsAxisEnabled((Axes)(1 << vector3Axis));
    }

    public class BoxBoundsHandle : PrimitiveBoundsHandle
    {
        public BoxBoundsHandle() { }
        public Vector3 size { get => GetSize(); set => SetSize(value); }
        protected override void DrawWireframe() { }
    }

    public class SphereBoundsHandle : PrimitiveBoundsHandle
    {
        public SphereBoundsHandle() { }

        public float radius
        {
            get
            {
                Vector3 size = GetSize();
                float across = 0f;
                for (int axis = 0; axis < 3; axis++)
                    if (IsAxisEnabled(axis))
                        across = Math.Max(across, Math.Abs(size[axis]));
                return 0.5f * across;
            }
            set => SetSize(2f * value * Vector3.one);
        }

        protected override void DrawWireframe() { }
        protected override Bounds OnHandleChanged(HandleDirection handle, Bounds boundsOnClick, Bounds newBounds) => newBounds;
    }

    /// <summary>Along y unless told otherwise; never shorter than its two halves of a ball.</summary>
    public class CapsuleBoundsHandle : PrimitiveBoundsHandle
    {
        public enum HeightAxis { X, Y, Z }

        HeightAxis along = HeightAxis.Y;

        public CapsuleBoundsHandle()
        {
            radius = 0.5f;
            height = 1f;
        }

        public HeightAxis heightAxis { get => along; set => along = value; }

        public float height
        {
            get => GetSize()[(int)along];
            set
            {
                Vector3 size = GetSize();
                size[(int)along] = Math.Max(Math.Abs(value), 2f * radius);
                SetSize(size);
            }
        }

        public float radius
        {
            get => 0.5f * GetSize()[((int)along + 1) % 3];
            set
            {
                Vector3 size = GetSize();
                for (int axis = 0; axis < 3; axis++)
                    size[axis] = axis == (int)along ? Math.Max(size[axis], 2f * value) : 2f * value;
                SetSize(size);
            }
        }

        protected override void DrawWireframe() { }
        protected override Bounds OnHandleChanged(HandleDirection handle, Bounds boundsOnClick, Bounds newBounds) => newBounds;
    }
}
