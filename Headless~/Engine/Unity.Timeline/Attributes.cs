using System;

namespace UnityEngine.Timeline
{
    [AttributeUsage(AttributeTargets.Class, AllowMultiple = true)]
    public class TrackClipTypeAttribute : Attribute
    {
        public readonly Type inspectedType;

        public TrackClipTypeAttribute(Type clipClass) => inspectedType = clipClass;
    }

    [AttributeUsage(AttributeTargets.Class)]
    public class TrackBindingTypeAttribute : Attribute
    {
        public readonly Type type;

        public TrackBindingTypeAttribute(Type type) => this.type = type;
    }

    [AttributeUsage(AttributeTargets.Class)]
    public class TrackColorAttribute : Attribute
    {
        public TrackColorAttribute(float r, float g, float b) => color = new Color(r, g, b);

        public Color color { get; }
    }
}
