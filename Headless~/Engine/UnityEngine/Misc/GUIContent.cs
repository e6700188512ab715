using UnityEngine.Headless;

namespace UnityEngine
{
    public class GUIContent
    {
        public static GUIContent none = new GUIContent();

        public GUIContent() : this("") { }
        public GUIContent(string text) : this(text, null, "") { }
        public GUIContent(string text, string tooltip) : this(text, null, tooltip) { }
        public GUIContent(Texture image) : this("", image, "") { }
        public GUIContent(Texture image, string tooltip) : this("", image, tooltip) { }
        public GUIContent(string text, Texture image) : this(text, image, "") { }
        public GUIContent(GUIContent src) : this(src.text, src.image, src.tooltip) { }

        public GUIContent(string text, Texture image, string tooltip)
        {
            this.text = text;
            this.image = image;
            this.tooltip = tooltip;
        }

        public string text { get; set; }
        public string tooltip { get; set; }
        public Texture image { get; set; }
        public override string ToString() => text ?? tooltip ?? base.ToString();
    }

    public sealed partial class GUIStyle
    {
        public GUIStyle() { }

        public GUIStyle(GUIStyle other)
        {
            name = other.name;
            fontSize = other.fontSize;
            richText = other.richText;
            wordWrap = other.wordWrap;
            fixedWidth = other.fixedWidth;
            fixedHeight = other.fixedHeight;
            fontStyle = other.fontStyle;
            alignment = other.alignment;
            padding = other.padding;
            margin = other.margin;
            border = other.border;
            normal = other.normal;
        }

        public static GUIStyle none { get; } = new GUIStyle();
        public static implicit operator GUIStyle(string str) => new GUIStyle { name = str };

        public string name { get; set; } = "";
        public int fontSize { get; set; }
        public FontStyle fontStyle { get; set; }
        public TextAnchor alignment { get; set; }
        public bool richText { get; set; } = true;
        public bool wordWrap { get; set; }
        public bool stretchWidth { get; set; }
        public bool stretchHeight { get; set; }
        public float fixedWidth { get; set; }
        public float fixedHeight { get; set; }
        public float lineHeight => 13;
        public Vector2 contentOffset { get; set; }
        /// <summary>Takes every letter as equally wide: about what the editor's font takes, and enough to see what is clipped.</summary>
        public Vector2 CalcSize(GUIContent content) => new Vector2(GuiDrawing.LetterWidth * (content.text ?? "").Length, lineHeight);
        public float CalcHeight(GUIContent content, float width) => lineHeight * (wordWrap ? GuiDrawing.Lines(content.text ?? "", width) : 1);
        public void Draw(Rect position, GUIContent content, int controlID) { }
        public override string ToString() => $"GUIStyle '{name}'";
    }

    public sealed class GUILayoutOption
    {
        internal GUILayoutOption() { }
    }

    public sealed class GUISkin : ScriptableObject
    {
        public GUIStyle label { get; set; } = new GUIStyle();
        public GUIStyle box { get; set; } = new GUIStyle();
        public GUIStyle button { get; set; } = new GUIStyle();
        public GUIStyle toggle { get; set; } = new GUIStyle();
        public GUIStyle window { get; set; } = new GUIStyle();
        public GUIStyle textField { get; set; } = new GUIStyle();
        public GUIStyle textArea { get; set; } = new GUIStyle();
        public GUIStyle GetStyle(string styleName) => new GUIStyle { name = styleName };
        public GUIStyle FindStyle(string styleName) => null;
    }

    public partial class GUI
    {
        public delegate void WindowFunction(int id);
        public enum ToolbarButtonSize { Fixed = 0, FitToContents = 1 }
    }

    public partial class GUI
    {
        public static void Label(Rect position, string text) => GuiDrawing.Label(position, text, null);
        public static void Label(Rect position, string text, GUIStyle style) => GuiDrawing.Label(position, text, style);
        public static void Label(Rect position, GUIContent content) => GuiDrawing.Label(position, content.text, null);
        public static void Label(Rect position, GUIContent content, GUIStyle style) => GuiDrawing.Label(position, content.text, style);
        public static void Label(Rect position, Texture image) { }
        public static void Label(Rect position, Texture image, GUIStyle style) { }
    }

    public partial class GUILayout
    {
        public static bool Button(string text, params GUILayoutOption[] options) => GuiDrawing.Button(text);
        public static bool Button(string text, GUIStyle style, params GUILayoutOption[] options) => GuiDrawing.Button(text);
        public static bool Button(GUIContent content, params GUILayoutOption[] options) => GuiDrawing.Button(content.text);
        public static bool Button(GUIContent content, GUIStyle style, params GUILayoutOption[] options) => GuiDrawing.Button(content.text);
        public static bool Button(Texture image, params GUILayoutOption[] options) => GuiDrawing.Button(image != null ? image.name : "");
        public static bool Button(Texture image, GUIStyle style, params GUILayoutOption[] options)
            => GuiDrawing.Button(image != null ? image.name : "");
        public static GUILayoutOption Width(float width) => new GUILayoutOption();
        public static GUILayoutOption Height(float height) => new GUILayoutOption();

        public class HorizontalScope : GUI.Scope
        {
            public HorizontalScope(params GUILayoutOption[] options) => BeginHorizontal(options);
            public HorizontalScope(GUIStyle style, params GUILayoutOption[] options) => BeginHorizontal(style, options);
            protected override void CloseScope() => EndHorizontal();
        }

        public class VerticalScope : GUI.Scope
        {
            public VerticalScope(params GUILayoutOption[] options) => BeginVertical(options);
            public VerticalScope(GUIStyle style, params GUILayoutOption[] options) => BeginVertical(style, options);
            protected override void CloseScope() => EndVertical();
        }
    }

    public partial class GUI
    {
        public abstract class Scope : System.IDisposable
        {
            protected abstract void CloseScope();
            public void Dispose() => CloseScope();
        }
    }

    /// <summary>Nothing ever happens here: current stays null.</summary>
    public sealed partial class Event
    {
        public Event() { }
        public static Event current { get; set; }
        public EventType type { get; set; }
        public EventType rawType => type;
        public EventModifiers modifiers { get; set; }
        public Vector2 mousePosition { get; set; }
        public Vector2 delta { get; set; }
        public int button { get; set; }
        public int clickCount { get; set; }
        public char character { get; set; }
        public bool alt { get; set; }
        public bool shift { get; set; }
        public bool control { get; set; }
        public bool command { get; set; }
        public string commandName { get; set; } = "";
        public void Use() => type = EventType.Used;
    }

    public enum EventType
    {
        MouseDown = 0, MouseUp = 1, MouseMove = 2, MouseDrag = 3, KeyDown = 4, KeyUp = 5, ScrollWheel = 6, Repaint = 7, Layout = 8,
        DragUpdated = 9, DragPerform = 10, Ignore = 11, Used = 12, ValidateCommand = 13, ExecuteCommand = 14, DragExited = 15,
        ContextClick = 16, MouseEnterWindow = 20, MouseLeaveWindow = 21, TouchDown = 30, TouchUp = 31, TouchMove = 32, TouchEnter = 33,
        TouchLeave = 34, TouchStationary = 35,
    }

    [System.Flags]
    public enum EventModifiers { None = 0, Shift = 1, Control = 2, Alt = 4, Command = 8, Numeric = 16, CapsLock = 32, FunctionKey = 64 }
    public enum FocusType { Keyboard = 1, Passive = 2 }
    public enum FontStyle { Normal = 0, Bold = 1, Italic = 2, BoldAndItalic = 3 }
    public enum TextAnchor { UpperLeft = 0, UpperCenter, UpperRight, MiddleLeft, MiddleCenter, MiddleRight, LowerLeft, LowerCenter, LowerRight }
}
