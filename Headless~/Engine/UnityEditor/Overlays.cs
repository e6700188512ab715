using System;

namespace UnityEditor.Overlays
{
    /// <summary>A panel over a window. The host has no window: a test draws it.</summary>
    public abstract class Overlay
    {
        public string displayName { get; set; }
        public string id { get; internal set; }
        public virtual void OnCreated() { }
        public virtual void OnWillBeDestroyed() { }
    }

    public abstract class IMGUIOverlay : Overlay
    {
        public abstract void OnGUI();
    }

    /// <summary>One that decides itself when it is shown.</summary>
    public interface ITransientOverlay
    {
        bool visible { get; }
    }

    [AttributeUsage(AttributeTargets.Class)]
    public sealed class OverlayAttribute : Attribute
    {
        public OverlayAttribute() { }
        public OverlayAttribute(Type editorWindowType, string id, string displayName, bool defaultDisplay = false)
            => (this.editorWindowType, this.id, this.displayName, this.defaultDisplay)
                = (editorWindowType, id, displayName, defaultDisplay);

        public Type editorWindowType { get; set; }
        public string id { get; set; }
        public string displayName { get; set; }
        public bool defaultDisplay { get; set; }
    }
}
