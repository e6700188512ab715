// Written by UnityEditor/generate_gui.py; change that instead.
using System;
using UnityEngine.Headless;

namespace UnityEngine
{
    public partial class GUI
    {
        public static Color backgroundColor { get; set; } = Color.white;
        public static Color color { get; set; } = Color.white;
        public static Color contentColor { get; set; } = Color.white;
        public static GUISkin skin { get; set; }
        public static Matrix4x4 matrix { get; set; } = Matrix4x4.identity;
        public static Rect ModalWindow(int id, Rect clientRect, WindowFunction func, GUIContent content) => clientRect;
        public static Rect ModalWindow(int id, Rect clientRect, WindowFunction func, GUIContent content, GUIStyle style) => clientRect;
        public static Rect ModalWindow(int id, Rect clientRect, WindowFunction func, Texture image) => clientRect;
        public static Rect ModalWindow(int id, Rect clientRect, WindowFunction func, Texture image, GUIStyle style) => clientRect;
        public static Rect ModalWindow(int id, Rect clientRect, WindowFunction func, string text) => clientRect;
        public static Rect ModalWindow(int id, Rect clientRect, WindowFunction func, string text, GUIStyle style) => clientRect;
        public static Rect Window(int id, Rect clientRect, WindowFunction func, GUIContent content) => clientRect;
        public static Rect Window(int id, Rect clientRect, WindowFunction func, GUIContent title, GUIStyle style) => clientRect;
        public static Rect Window(int id, Rect clientRect, WindowFunction func, Texture image) => clientRect;
        public static Rect Window(int id, Rect clientRect, WindowFunction func, Texture image, GUIStyle style) => clientRect;
        public static Rect Window(int id, Rect clientRect, WindowFunction func, string text) => clientRect;
        public static Rect Window(int id, Rect clientRect, WindowFunction func, string text, GUIStyle style) => clientRect;
        public static Vector2 BeginScrollView(Rect position, Vector2 scrollPosition, Rect viewRect) { GuiGroups.Begin("ScrollView"); return scrollPosition; }
        public static Vector2 BeginScrollView(Rect position, Vector2 scrollPosition, Rect viewRect, GUIStyle horizontalScrollbar, GUIStyle verticalScrollbar) { GuiGroups.Begin("ScrollView"); return scrollPosition; }
        public static Vector2 BeginScrollView(Rect position, Vector2 scrollPosition, Rect viewRect, bool alwaysShowHorizontal, bool alwaysShowVertical) { GuiGroups.Begin("ScrollView"); return scrollPosition; }
        public static Vector2 BeginScrollView(Rect position, Vector2 scrollPosition, Rect viewRect, bool alwaysShowHorizontal, bool alwaysShowVertical, GUIStyle horizontalScrollbar, GUIStyle verticalScrollbar) { GuiGroups.Begin("ScrollView"); return scrollPosition; }
        public static bool Button(Rect position, GUIContent content) => default;
        public static bool Button(Rect position, GUIContent content, GUIStyle style) => default;
        public static bool Button(Rect position, Texture image) => default;
        public static bool Button(Rect position, Texture image, GUIStyle style) => default;
        public static bool Button(Rect position, string text) => default;
        public static bool Button(Rect position, string text, GUIStyle style) => default;
        public static bool RepeatButton(Rect position, GUIContent content) => default;
        public static bool RepeatButton(Rect position, GUIContent content, GUIStyle style) => default;
        public static bool RepeatButton(Rect position, Texture image) => default;
        public static bool RepeatButton(Rect position, Texture image, GUIStyle style) => default;
        public static bool RepeatButton(Rect position, string text) => default;
        public static bool RepeatButton(Rect position, string text, GUIStyle style) => default;
        public static bool ScrollTowards(Rect position, float maxDelta) => default;
        public static bool Toggle(Rect position, bool value, GUIContent content) => value;
        public static bool Toggle(Rect position, bool value, GUIContent content, GUIStyle style) => value;
        public static bool Toggle(Rect position, bool value, Texture image) => value;
        public static bool Toggle(Rect position, bool value, Texture image, GUIStyle style) => value;
        public static bool Toggle(Rect position, bool value, string text) => value;
        public static bool Toggle(Rect position, bool value, string text, GUIStyle style) => value;
        public static bool Toggle(Rect position, int id, bool value, GUIContent content, GUIStyle style) => value;
        public static bool changed { get; set; }
        public static bool enabled { get; set; } = true;
        public static float HorizontalScrollbar(Rect position, float value, float size, float leftValue, float rightValue) => value;
        public static float HorizontalScrollbar(Rect position, float value, float size, float leftValue, float rightValue, GUIStyle style) => value;
        public static float HorizontalSlider(Rect position, float value, float leftValue, float rightValue) => value;
        public static float HorizontalSlider(Rect position, float value, float leftValue, float rightValue, GUIStyle slider, GUIStyle thumb) => value;
        public static float HorizontalSlider(Rect position, float value, float leftValue, float rightValue, GUIStyle slider, GUIStyle thumb, GUIStyle thumbExtent) => value;
        public static float Slider(Rect position, float value, float size, float start, float end, GUIStyle slider, GUIStyle thumb, bool horiz, int id, GUIStyle thumbExtent = null) => value;
        public static float VerticalScrollbar(Rect position, float value, float size, float topValue, float bottomValue) => value;
        public static float VerticalScrollbar(Rect position, float value, float size, float topValue, float bottomValue, GUIStyle style) => value;
        public static float VerticalSlider(Rect position, float value, float topValue, float bottomValue) => value;
        public static float VerticalSlider(Rect position, float value, float topValue, float bottomValue, GUIStyle slider, GUIStyle thumb) => value;
        public static float VerticalSlider(Rect position, float value, float topValue, float bottomValue, GUIStyle slider, GUIStyle thumb, GUIStyle thumbExtent) => value;
        public static int SelectionGrid(Rect position, int selected, GUIContent[] content, int xCount) => selected;
        public static int SelectionGrid(Rect position, int selected, GUIContent[] contents, int xCount, GUIStyle style) => selected;
        public static int SelectionGrid(Rect position, int selected, Texture[] images, int xCount) => selected;
        public static int SelectionGrid(Rect position, int selected, Texture[] images, int xCount, GUIStyle style) => selected;
        public static int SelectionGrid(Rect position, int selected, string[] texts, int xCount) => selected;
        public static int SelectionGrid(Rect position, int selected, string[] texts, int xCount, GUIStyle style) => selected;
        public static int Toolbar(Rect position, int selected, GUIContent[] contents) => selected;
        public static int Toolbar(Rect position, int selected, GUIContent[] contents, GUIStyle style) => selected;
        public static int Toolbar(Rect position, int selected, GUIContent[] contents, GUIStyle style, ToolbarButtonSize buttonSize) => selected;
        public static int Toolbar(Rect position, int selected, Texture[] images) => selected;
        public static int Toolbar(Rect position, int selected, Texture[] images, GUIStyle style) => selected;
        public static int Toolbar(Rect position, int selected, string[] texts) => selected;
        public static int Toolbar(Rect position, int selected, string[] texts, GUIStyle style) => selected;
        public static int depth { get; set; }
        public static string GetNameOfFocusedControl() => default;
        public static string PasswordField(Rect position, string password, char maskChar) => password;
        public static string PasswordField(Rect position, string password, char maskChar, GUIStyle style) => password;
        public static string PasswordField(Rect position, string password, char maskChar, int maxLength) => password;
        public static string PasswordField(Rect position, string password, char maskChar, int maxLength, GUIStyle style) => password;
        public static string TextArea(Rect position, string text) => text;
        public static string TextArea(Rect position, string text, GUIStyle style) => text;
        public static string TextArea(Rect position, string text, int maxLength) => text;
        public static string TextArea(Rect position, string text, int maxLength, GUIStyle style) => text;
        public static string TextField(Rect position, string text) => text;
        public static string TextField(Rect position, string text, GUIStyle style) => text;
        public static string TextField(Rect position, string text, int maxLength) => text;
        public static string TextField(Rect position, string text, int maxLength, GUIStyle style) => text;
        public static string tooltip { get; set; }
        public static void BeginClip(Rect position) { GuiGroups.Begin("Clip"); }
        public static void BeginClip(Rect position, Vector2 scrollOffset, Vector2 renderOffset, bool resetOffset) { GuiGroups.Begin("Clip"); }
        public static void BeginGroup(Rect position) { GuiGroups.Begin("Group"); }
        public static void BeginGroup(Rect position, GUIContent content) { GuiGroups.Begin("Group"); }
        public static void BeginGroup(Rect position, GUIContent content, GUIStyle style) { GuiGroups.Begin("Group"); }
        public static void BeginGroup(Rect position, GUIStyle style) { GuiGroups.Begin("Group"); }
        public static void BeginGroup(Rect position, Texture image) { GuiGroups.Begin("Group"); }
        public static void BeginGroup(Rect position, Texture image, GUIStyle style) { GuiGroups.Begin("Group"); }
        public static void BeginGroup(Rect position, string text) { GuiGroups.Begin("Group"); }
        public static void BeginGroup(Rect position, string text, GUIStyle style) { GuiGroups.Begin("Group"); }
        public static void Box(Rect position, GUIContent content) { }
        public static void Box(Rect position, GUIContent content, GUIStyle style) { }
        public static void Box(Rect position, Texture image) { }
        public static void Box(Rect position, Texture image, GUIStyle style) { }
        public static void Box(Rect position, string text) { }
        public static void Box(Rect position, string text, GUIStyle style) { }
        public static void BringWindowToBack(int windowID) { }
        public static void BringWindowToFront(int windowID) { }
        public static void DragWindow() { }
        public static void DragWindow(Rect position) { }
        public static void DrawTexture(Rect position, Texture image) { }
        public static void DrawTextureWithTexCoords(Rect position, Texture image, Rect texCoords) { }
        public static void DrawTextureWithTexCoords(Rect position, Texture image, Rect texCoords, bool alphaBlend) { }
        public static void EndClip() { GuiGroups.End("Clip"); }
        public static void EndGroup() { GuiGroups.End("Group"); }
        public static void EndScrollView() { GuiGroups.End("ScrollView"); }
        public static void EndScrollView(bool handleScrollWheel) { GuiGroups.End("ScrollView"); }
        public static void FocusControl(string name) { }
        public static void FocusWindow(int windowID) { }
        public static void ScrollTo(Rect position) { }
        public static void SetNextControlName(string name) { }
        public static void UnfocusWindow() { }
    }

    public partial class GUILayout
    {
        public static GUILayoutOption ExpandHeight(bool expand) => new GUILayoutOption();
        public static GUILayoutOption ExpandWidth(bool expand) => new GUILayoutOption();
        public static GUILayoutOption MaxHeight(float maxHeight) => new GUILayoutOption();
        public static GUILayoutOption MaxWidth(float maxWidth) => new GUILayoutOption();
        public static GUILayoutOption MinHeight(float minHeight) => new GUILayoutOption();
        public static GUILayoutOption MinWidth(float minWidth) => new GUILayoutOption();
        public static Rect Window(int id, Rect screenRect, GUI.WindowFunction func, GUIContent content, GUIStyle style, params GUILayoutOption[] options) => screenRect;
        public static Rect Window(int id, Rect screenRect, GUI.WindowFunction func, GUIContent content, params GUILayoutOption[] options) => screenRect;
        public static Rect Window(int id, Rect screenRect, GUI.WindowFunction func, Texture image, GUIStyle style, params GUILayoutOption[] options) => screenRect;
        public static Rect Window(int id, Rect screenRect, GUI.WindowFunction func, Texture image, params GUILayoutOption[] options) => screenRect;
        public static Rect Window(int id, Rect screenRect, GUI.WindowFunction func, string text, GUIStyle style, params GUILayoutOption[] options) => screenRect;
        public static Rect Window(int id, Rect screenRect, GUI.WindowFunction func, string text, params GUILayoutOption[] options) => screenRect;
        public static Vector2 BeginScrollView(Vector2 scrollPosition, GUIStyle horizontalScrollbar, GUIStyle verticalScrollbar, params GUILayoutOption[] options) { GuiGroups.Begin("ScrollView"); return scrollPosition; }
        public static Vector2 BeginScrollView(Vector2 scrollPosition, GUIStyle style) { GuiGroups.Begin("ScrollView"); return scrollPosition; }
        public static Vector2 BeginScrollView(Vector2 scrollPosition, GUIStyle style, params GUILayoutOption[] options) { GuiGroups.Begin("ScrollView"); return scrollPosition; }
        public static Vector2 BeginScrollView(Vector2 scrollPosition, bool alwaysShowHorizontal, bool alwaysShowVertical, GUIStyle horizontalScrollbar, GUIStyle verticalScrollbar, GUIStyle background, params GUILayoutOption[] options) { GuiGroups.Begin("ScrollView"); return scrollPosition; }
        public static Vector2 BeginScrollView(Vector2 scrollPosition, bool alwaysShowHorizontal, bool alwaysShowVertical, GUIStyle horizontalScrollbar, GUIStyle verticalScrollbar, params GUILayoutOption[] options) { GuiGroups.Begin("ScrollView"); return scrollPosition; }
        public static Vector2 BeginScrollView(Vector2 scrollPosition, bool alwaysShowHorizontal, bool alwaysShowVertical, params GUILayoutOption[] options) { GuiGroups.Begin("ScrollView"); return scrollPosition; }
        public static Vector2 BeginScrollView(Vector2 scrollPosition, params GUILayoutOption[] options) { GuiGroups.Begin("ScrollView"); return scrollPosition; }
        public static bool RepeatButton(GUIContent content, GUIStyle style, params GUILayoutOption[] options) => default;
        public static bool RepeatButton(GUIContent content, params GUILayoutOption[] options) => default;
        public static bool RepeatButton(Texture image, GUIStyle style, params GUILayoutOption[] options) => default;
        public static bool RepeatButton(Texture image, params GUILayoutOption[] options) => default;
        public static bool RepeatButton(string text, GUIStyle style, params GUILayoutOption[] options) => default;
        public static bool RepeatButton(string text, params GUILayoutOption[] options) => default;
        public static bool Toggle(bool value, GUIContent content, GUIStyle style, params GUILayoutOption[] options) => value;
        public static bool Toggle(bool value, GUIContent content, params GUILayoutOption[] options) => value;
        public static bool Toggle(bool value, Texture image, GUIStyle style, params GUILayoutOption[] options) => value;
        public static bool Toggle(bool value, Texture image, params GUILayoutOption[] options) => value;
        public static bool Toggle(bool value, string text, GUIStyle style, params GUILayoutOption[] options) => value;
        public static bool Toggle(bool value, string text, params GUILayoutOption[] options) => value;
        public static float HorizontalScrollbar(float value, float size, float leftValue, float rightValue, GUIStyle style, params GUILayoutOption[] options) => value;
        public static float HorizontalScrollbar(float value, float size, float leftValue, float rightValue, params GUILayoutOption[] options) => value;
        public static float HorizontalSlider(float value, float leftValue, float rightValue, GUIStyle slider, GUIStyle thumb, params GUILayoutOption[] options) => value;
        public static float HorizontalSlider(float value, float leftValue, float rightValue, params GUILayoutOption[] options) => value;
        public static float VerticalScrollbar(float value, float size, float topValue, float bottomValue, GUIStyle style, params GUILayoutOption[] options) => value;
        public static float VerticalScrollbar(float value, float size, float topValue, float bottomValue, params GUILayoutOption[] options) => value;
        public static float VerticalSlider(float value, float leftValue, float rightValue, GUIStyle slider, GUIStyle thumb, params GUILayoutOption[] options) => value;
        public static float VerticalSlider(float value, float leftValue, float rightValue, params GUILayoutOption[] options) => value;
        public static int SelectionGrid(int selected, GUIContent[] content, int xCount, params GUILayoutOption[] options) => selected;
        public static int SelectionGrid(int selected, GUIContent[] contents, int xCount, GUIStyle style, params GUILayoutOption[] options) => selected;
        public static int SelectionGrid(int selected, Texture[] images, int xCount, GUIStyle style, params GUILayoutOption[] options) => selected;
        public static int SelectionGrid(int selected, Texture[] images, int xCount, params GUILayoutOption[] options) => selected;
        public static int SelectionGrid(int selected, string[] texts, int xCount, GUIStyle style, params GUILayoutOption[] options) => selected;
        public static int SelectionGrid(int selected, string[] texts, int xCount, params GUILayoutOption[] options) => selected;
        public static int Toolbar(int selected, GUIContent[] contents, GUIStyle style, GUI.ToolbarButtonSize buttonSize, params GUILayoutOption[] options) => selected;
        public static int Toolbar(int selected, GUIContent[] contents, GUIStyle style, params GUILayoutOption[] options) => selected;
        public static int Toolbar(int selected, GUIContent[] contents, bool[] enabled, GUIStyle style, GUI.ToolbarButtonSize buttonSize, params GUILayoutOption[] options) => selected;
        public static int Toolbar(int selected, GUIContent[] contents, bool[] enabled, GUIStyle style, params GUILayoutOption[] options) => selected;
        public static int Toolbar(int selected, GUIContent[] contents, params GUILayoutOption[] options) => selected;
        public static int Toolbar(int selected, Texture[] images, GUIStyle style, GUI.ToolbarButtonSize buttonSize, params GUILayoutOption[] options) => selected;
        public static int Toolbar(int selected, Texture[] images, GUIStyle style, params GUILayoutOption[] options) => selected;
        public static int Toolbar(int selected, Texture[] images, params GUILayoutOption[] options) => selected;
        public static int Toolbar(int selected, string[] texts, GUIStyle style, GUI.ToolbarButtonSize buttonSize, params GUILayoutOption[] options) => selected;
        public static int Toolbar(int selected, string[] texts, GUIStyle style, params GUILayoutOption[] options) => selected;
        public static int Toolbar(int selected, string[] texts, params GUILayoutOption[] options) => selected;
        public static string PasswordField(string password, char maskChar, GUIStyle style, params GUILayoutOption[] options) => password;
        public static string PasswordField(string password, char maskChar, int maxLength, GUIStyle style, params GUILayoutOption[] options) => password;
        public static string PasswordField(string password, char maskChar, int maxLength, params GUILayoutOption[] options) => password;
        public static string PasswordField(string password, char maskChar, params GUILayoutOption[] options) => password;
        public static string TextArea(string text, GUIStyle style, params GUILayoutOption[] options) => text;
        public static string TextArea(string text, int maxLength, GUIStyle style, params GUILayoutOption[] options) => text;
        public static string TextArea(string text, int maxLength, params GUILayoutOption[] options) => text;
        public static string TextArea(string text, params GUILayoutOption[] options) => text;
        public static string TextField(string text, GUIStyle style, params GUILayoutOption[] options) => text;
        public static string TextField(string text, int maxLength, GUIStyle style, params GUILayoutOption[] options) => text;
        public static string TextField(string text, int maxLength, params GUILayoutOption[] options) => text;
        public static string TextField(string text, params GUILayoutOption[] options) => text;
        public static void BeginArea(Rect screenRect) { GuiGroups.Begin("Area"); }
        public static void BeginArea(Rect screenRect, GUIContent content) { GuiGroups.Begin("Area"); }
        public static void BeginArea(Rect screenRect, GUIContent content, GUIStyle style) { GuiGroups.Begin("Area"); }
        public static void BeginArea(Rect screenRect, GUIStyle style) { GuiGroups.Begin("Area"); }
        public static void BeginArea(Rect screenRect, Texture image) { GuiGroups.Begin("Area"); }
        public static void BeginArea(Rect screenRect, Texture image, GUIStyle style) { GuiGroups.Begin("Area"); }
        public static void BeginArea(Rect screenRect, string text) { GuiGroups.Begin("Area"); }
        public static void BeginArea(Rect screenRect, string text, GUIStyle style) { GuiGroups.Begin("Area"); }
        public static void BeginHorizontal(GUIContent content, GUIStyle style, params GUILayoutOption[] options) { GuiGroups.Begin("Horizontal"); }
        public static void BeginHorizontal(GUIStyle style, params GUILayoutOption[] options) { GuiGroups.Begin("Horizontal"); }
        public static void BeginHorizontal(Texture image, GUIStyle style, params GUILayoutOption[] options) { GuiGroups.Begin("Horizontal"); }
        public static void BeginHorizontal(params GUILayoutOption[] options) { GuiGroups.Begin("Horizontal"); }
        public static void BeginHorizontal(string text, GUIStyle style, params GUILayoutOption[] options) { GuiGroups.Begin("Horizontal"); }
        public static void BeginVertical(GUIContent content, GUIStyle style, params GUILayoutOption[] options) { GuiGroups.Begin("Vertical"); }
        public static void BeginVertical(GUIStyle style, params GUILayoutOption[] options) { GuiGroups.Begin("Vertical"); }
        public static void BeginVertical(Texture image, GUIStyle style, params GUILayoutOption[] options) { GuiGroups.Begin("Vertical"); }
        public static void BeginVertical(params GUILayoutOption[] options) { GuiGroups.Begin("Vertical"); }
        public static void BeginVertical(string text, GUIStyle style, params GUILayoutOption[] options) { GuiGroups.Begin("Vertical"); }
        public static void Box(GUIContent content, GUIStyle style, params GUILayoutOption[] options) { }
        public static void Box(GUIContent content, params GUILayoutOption[] options) { }
        public static void Box(Texture image, GUIStyle style, params GUILayoutOption[] options) { }
        public static void Box(Texture image, params GUILayoutOption[] options) { }
        public static void Box(string text, GUIStyle style, params GUILayoutOption[] options) { }
        public static void Box(string text, params GUILayoutOption[] options) { }
        public static void EndArea() { GuiGroups.End("Area"); }
        public static void EndHorizontal() { GuiGroups.End("Horizontal"); }
        public static void EndScrollView() { GuiGroups.End("ScrollView"); }
        public static void EndVertical() { GuiGroups.End("Vertical"); }
        public static void FlexibleSpace() { }
        public static void Label(GUIContent content, GUIStyle style, params GUILayoutOption[] options) { }
        public static void Label(GUIContent content, params GUILayoutOption[] options) { }
        public static void Label(Texture image, GUIStyle style, params GUILayoutOption[] options) { }
        public static void Label(Texture image, params GUILayoutOption[] options) { }
        public static void Label(string text, GUIStyle style, params GUILayoutOption[] options) { }
        public static void Label(string text, params GUILayoutOption[] options) { }
        public static void Space(float pixels) { }
    }

    public partial class GUIUtility
    {
        public static Rect AlignRectToDevice(Rect rect) => default;
        public static Rect AlignRectToDevice(Rect rect, out int widthInPixels, out int heightInPixels) { widthInPixels = default; heightInPixels = default; return default; }
        public static Rect GUIToScreenRect(Rect guiRect) => default;
        public static Rect ScreenToGUIRect(Rect screenRect) => screenRect;
        public static Vector2 GUIToScreenPoint(Vector2 guiPoint) => default;
        public static Vector2 ScreenToGUIPoint(Vector2 screenPoint) => default;
        public static bool hasModalWindow { get; }
        public static int GetControlID(FocusType focus) => default;
        public static int GetControlID(FocusType focus, Rect position) => default;
        public static int GetControlID(GUIContent contents, FocusType focus) => default;
        public static int GetControlID(GUIContent contents, FocusType focus, Rect position) => default;
        public static int GetControlID(int hint, FocusType focus) => default;
        public static int GetControlID(int hint, FocusType focusType, Rect rect) => default;
        public static int hotControl { get; set; }
        public static int keyboardControl { get; set; }
        public static object GetStateObject(Type t, int controlID) => default;
        public static object QueryStateObject(Type t, int controlID) => default;
        public static string systemCopyBuffer { get; set; }
        public static void ExitGUI() { }
        public static void RotateAroundPivot(float angle, Vector2 pivotPoint) { }
        public static void ScaleAroundPivot(Vector2 scale, Vector2 pivotPoint) { }
    }

    public partial class GUILayoutUtility
    {
        public static Rect GetAspectRect(float aspect) => default;
        public static Rect GetAspectRect(float aspect, GUIStyle style) => default;
        public static Rect GetAspectRect(float aspect, GUIStyle style, params GUILayoutOption[] options) => default;
        public static Rect GetAspectRect(float aspect, params GUILayoutOption[] options) => default;
        public static Rect GetLastRect() => default;
        public static Rect GetRect(GUIContent content, GUIStyle style) => default;
        public static Rect GetRect(GUIContent content, GUIStyle style, params GUILayoutOption[] options) => default;
        public static Rect GetRect(float minWidth, float maxWidth, float minHeight, float maxHeight) => default;
        public static Rect GetRect(float minWidth, float maxWidth, float minHeight, float maxHeight, GUIStyle style) => default;
        public static Rect GetRect(float minWidth, float maxWidth, float minHeight, float maxHeight, GUIStyle style, params GUILayoutOption[] options) => default;
        public static Rect GetRect(float minWidth, float maxWidth, float minHeight, float maxHeight, params GUILayoutOption[] options) => default;
        public static Rect GetRect(float width, float height) => default;
        public static Rect GetRect(float width, float height, GUIStyle style) => default;
        public static Rect GetRect(float width, float height, GUIStyle style, params GUILayoutOption[] options) => default;
        public static Rect GetRect(float width, float height, params GUILayoutOption[] options) => default;
    }

    public partial class Gizmos
    {
        public static Color color { get; set; } = Color.white;
        public static Matrix4x4 matrix { get; set; } = Matrix4x4.identity;
        public static Texture exposure { get; set; }
        public static float probeSize { get; }
        public static void DrawCube(Vector3 center, Vector3 size) { }
        public static void DrawFrustum(Vector3 center, float fov, float maxRange, float minRange, float aspect) { }
        public static void DrawGUITexture(Rect screenRect, Texture texture) { }
        public static void DrawGUITexture(Rect screenRect, Texture texture, Material mat) { }
        public static void DrawGUITexture(Rect screenRect, Texture texture, int leftBorder, int rightBorder, int topBorder, int bottomBorder) { }
        public static void DrawGUITexture(Rect screenRect, Texture texture, int leftBorder, int rightBorder, int topBorder, int bottomBorder, Material mat) { }
        public static void DrawIcon(Vector3 center, string name) { }
        public static void DrawIcon(Vector3 center, string name, bool allowScaling) { }
        public static void DrawLine(Vector3 from, Vector3 to) { }
        public static void DrawMesh(Mesh mesh) { }
        public static void DrawMesh(Mesh mesh, Vector3 position, Quaternion rotation, Vector3 scale) { }
        public static void DrawMesh(Mesh mesh, Vector3 position, Quaternion rotation) { }
        public static void DrawMesh(Mesh mesh, Vector3 position) { }
        public static void DrawMesh(Mesh mesh, int submeshIndex) { }
        public static void DrawMesh(Mesh mesh, int submeshIndex, Vector3 position, Quaternion rotation) { }
        public static void DrawMesh(Mesh mesh, int submeshIndex, Vector3 position) { }
        public static void DrawMesh(Mesh mesh, int submeshIndex, Vector3 position, Quaternion rotation, Vector3 scale) { }
        public static void DrawRay(Ray r) { }
        public static void DrawRay(Vector3 from, Vector3 direction) { }
        public static void DrawSphere(Vector3 center, float radius) { }
        public static void DrawWireCube(Vector3 center, Vector3 size) { }
        public static void DrawWireMesh(Mesh mesh) { }
        public static void DrawWireMesh(Mesh mesh, Vector3 position, Quaternion rotation, Vector3 scale) { }
        public static void DrawWireMesh(Mesh mesh, Vector3 position, Quaternion rotation) { }
        public static void DrawWireMesh(Mesh mesh, Vector3 position) { }
        public static void DrawWireMesh(Mesh mesh, int submeshIndex) { }
        public static void DrawWireMesh(Mesh mesh, int submeshIndex, Vector3 position, Quaternion rotation) { }
        public static void DrawWireMesh(Mesh mesh, int submeshIndex, Vector3 position) { }
        public static void DrawWireMesh(Mesh mesh, int submeshIndex, Vector3 position, Quaternion rotation, Vector3 scale) { }
        public static void DrawWireSphere(Vector3 center, float radius) { }
    }
}
