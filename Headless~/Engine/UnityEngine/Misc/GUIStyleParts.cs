namespace UnityEngine
{
    public sealed class GUIStyleState
    {
        public GUIStyleState() { }
        public Texture2D background { get; set; }
        public Texture2D[] scaledBackgrounds { get; set; } = new Texture2D[0];
        public Color textColor { get; set; }
    }

    public class RectOffset
    {
        public RectOffset() { }

        public RectOffset(int left, int right, int top, int bottom)
        {
            this.left = left;
            this.right = right;
            this.top = top;
            this.bottom = bottom;
        }

        public int left { get; set; }
        public int right { get; set; }
        public int top { get; set; }
        public int bottom { get; set; }
        public int horizontal => left + right;
        public int vertical => top + bottom;
        public Rect Add(Rect rect) => new Rect(rect.x - left, rect.y - top, rect.width + horizontal, rect.height + vertical);
        public Rect Remove(Rect rect) => new Rect(rect.x + left, rect.y + top, rect.width - horizontal, rect.height - vertical);
        public override string ToString() => $"RectOffset (l:{left} r:{right} t:{top} b:{bottom})";
    }

    public enum ImagePosition { ImageLeft = 0, ImageAbove = 1, ImageOnly = 2, TextOnly = 3 }

    public sealed partial class GUIStyle
    {
        public GUIStyleState normal { get; set; } = new GUIStyleState();
        public GUIStyleState hover { get; set; } = new GUIStyleState();
        public GUIStyleState active { get; set; } = new GUIStyleState();
        public GUIStyleState focused { get; set; } = new GUIStyleState();
        public GUIStyleState onNormal { get; set; } = new GUIStyleState();
        public GUIStyleState onHover { get; set; } = new GUIStyleState();
        public GUIStyleState onActive { get; set; } = new GUIStyleState();
        public GUIStyleState onFocused { get; set; } = new GUIStyleState();
        public RectOffset border { get; set; } = new RectOffset();
        public RectOffset margin { get; set; } = new RectOffset();
        public RectOffset padding { get; set; } = new RectOffset();
        public RectOffset overflow { get; set; } = new RectOffset();
        public ImagePosition imagePosition { get; set; }
    }

    public sealed partial class Event
    {
        public KeyCode keyCode { get; set; }
        public bool capsLock { get; set; }
        public bool numeric { get; set; }
        public bool functionKey => (modifiers & EventModifiers.FunctionKey) != 0;
        public bool isKey => type == EventType.KeyDown || type == EventType.KeyUp;
        public bool isMouse => type == EventType.MouseDown || type == EventType.MouseUp || type == EventType.MouseMove || type == EventType.MouseDrag;
        public bool isScrollWheel => type == EventType.ScrollWheel;
        public EventType GetTypeForControl(int controlID) => type;
        public static int GetEventCount() => 0;
        public static bool PopEvent(Event outEvent) => false;
    }
}
