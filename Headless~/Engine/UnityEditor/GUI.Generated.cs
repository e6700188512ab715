// Written by UnityEditor/generate_gui.py; change that instead.
using System;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;
using UnityObject = UnityEngine.Object;

namespace UnityEditor
{
    public partial class EditorGUI
    {
        public static AnimationCurve CurveField(Rect position, AnimationCurve value) => value;
        public static AnimationCurve CurveField(Rect position, AnimationCurve value, Color color, Rect ranges) => value;
        public static AnimationCurve CurveField(Rect position, GUIContent label, AnimationCurve value) => value;
        public static AnimationCurve CurveField(Rect position, GUIContent label, AnimationCurve value, Color color, Rect ranges) => value;
        public static AnimationCurve CurveField(Rect position, string label, AnimationCurve value) => value;
        public static AnimationCurve CurveField(Rect position, string label, AnimationCurve value, Color color, Rect ranges) => value;
        public static Bounds BoundsField(Rect position, Bounds value) => value;
        public static Bounds BoundsField(Rect position, GUIContent label, Bounds value) => value;
        public static Bounds BoundsField(Rect position, string label, Bounds value) => value;
        public static Color ColorField(Rect position, Color value) => value;
        public static Color ColorField(Rect position, GUIContent label, Color value) => value;
        public static Color ColorField(Rect position, GUIContent label, Color value, bool showEyedropper, bool showAlpha, bool hdr) => value;
        public static Color ColorField(Rect position, string label, Color value) => value;
        public static Enum EnumFlagsField(Rect position, Enum enumValue) => enumValue;
        public static Enum EnumFlagsField(Rect position, Enum enumValue, GUIStyle style) => enumValue;
        public static Enum EnumFlagsField(Rect position, GUIContent label, Enum enumValue) => enumValue;
        public static Enum EnumFlagsField(Rect position, GUIContent label, Enum enumValue, GUIStyle style) => enumValue;
        public static Enum EnumFlagsField(Rect position, GUIContent label, Enum enumValue, bool includeObsolete, GUIStyle style = null) => enumValue;
        public static Enum EnumFlagsField(Rect position, string label, Enum enumValue) => enumValue;
        public static Enum EnumFlagsField(Rect position, string label, Enum enumValue, GUIStyle style) => enumValue;
        public static Enum EnumPopup(Rect position, Enum selected) => selected;
        public static Enum EnumPopup(Rect position, Enum selected, GUIStyle style) => selected;
        public static Enum EnumPopup(Rect position, GUIContent label, Enum selected) => selected;
        public static Enum EnumPopup(Rect position, GUIContent label, Enum selected, GUIStyle style) => selected;
        public static Enum EnumPopup(Rect position, string label, Enum selected) => selected;
        public static Enum EnumPopup(Rect position, string label, Enum selected, GUIStyle style) => selected;
        public static Gradient GradientField(Rect position, GUIContent label, Gradient gradient) => default;
        public static Gradient GradientField(Rect position, GUIContent label, Gradient gradient, bool hdr) => default;
        public static Gradient GradientField(Rect position, Gradient gradient) => default;
        public static Gradient GradientField(Rect position, string label, Gradient gradient) => default;
        public static Object ObjectField(Rect position, GUIContent label, Object obj, Type objType, Object targetBeingEdited) => obj;
        public static Object ObjectField(Rect position, GUIContent label, Object obj, Type objType, bool allowSceneObjects) => obj;
        public static Object ObjectField(Rect position, Object obj, Type objType, Object targetBeingEdited) => obj;
        public static Object ObjectField(Rect position, Object obj, Type objType, bool allowSceneObjects) => obj;
        public static Object ObjectField(Rect position, string label, Object obj, Type objType, Object targetBeingEdited) => obj;
        public static Object ObjectField(Rect position, string label, Object obj, Type objType, bool allowSceneObjects) => obj;
        public static Rect IndentedRect(Rect source) => default;
        public static Rect PrefixLabel(Rect totalPosition, GUIContent label) => default;
        public static Rect PrefixLabel(Rect totalPosition, GUIContent label, GUIStyle style) => default;
        public static Rect PrefixLabel(Rect totalPosition, int id, GUIContent label) => default;
        public static Rect PrefixLabel(Rect totalPosition, int id, GUIContent label, GUIStyle style) => default;
        public static Rect RectField(Rect position, GUIContent label, Rect value) => value;
        public static Rect RectField(Rect position, Rect value) => value;
        public static Rect RectField(Rect position, string label, Rect value) => value;
        public static Vector2 Vector2Field(Rect position, GUIContent label, Vector2 value) => value;
        public static Vector2 Vector2Field(Rect position, string label, Vector2 value) => value;
        public static Vector2Int Vector2IntField(Rect position, GUIContent label, Vector2Int value) => value;
        public static Vector2Int Vector2IntField(Rect position, string label, Vector2Int value) => value;
        public static Vector3 Vector3Field(Rect position, GUIContent label, Vector3 value) => value;
        public static Vector3 Vector3Field(Rect position, string label, Vector3 value) => value;
        public static Vector3Int Vector3IntField(Rect position, GUIContent label, Vector3Int value) => value;
        public static Vector3Int Vector3IntField(Rect position, string label, Vector3Int value) => value;
        public static Vector4 Vector4Field(Rect position, GUIContent label, Vector4 value) => value;
        public static Vector4 Vector4Field(Rect position, string label, Vector4 value) => value;
        public static bool DropdownButton(Rect position, GUIContent content, FocusType focusType) => default;
        public static bool DropdownButton(Rect position, GUIContent content, FocusType focusType, GUIStyle style) => default;
        public static bool Foldout(Rect position, bool foldout, GUIContent content) => foldout;
        public static bool Foldout(Rect position, bool foldout, GUIContent content, GUIStyle style) => foldout;
        public static bool Foldout(Rect position, bool foldout, GUIContent content, bool toggleOnLabelClick) => foldout;
        public static bool Foldout(Rect position, bool foldout, GUIContent content, bool toggleOnLabelClick, GUIStyle style) => foldout;
        public static bool Foldout(Rect position, bool foldout, string content) => foldout;
        public static bool Foldout(Rect position, bool foldout, string content, GUIStyle style) => foldout;
        public static bool Foldout(Rect position, bool foldout, string content, bool toggleOnLabelClick) => foldout;
        public static bool Foldout(Rect position, bool foldout, string content, bool toggleOnLabelClick, GUIStyle style) => foldout;
        public static bool InspectorTitlebar(Rect position, bool foldout, Editor editor) => foldout;
        public static bool InspectorTitlebar(Rect position, bool foldout, Object targetObj, bool expandable) => foldout;
        public static bool InspectorTitlebar(Rect position, bool foldout, Object[] targetObjs, bool expandable) => foldout;
        public static bool LinkButton(Rect position, GUIContent label) => default;
        public static bool LinkButton(Rect position, string label) => default;
        public static bool Toggle(Rect position, GUIContent label, bool value) => value;
        public static bool Toggle(Rect position, GUIContent label, bool value, GUIStyle style) => value;
        public static bool Toggle(Rect position, bool value) => value;
        public static bool Toggle(Rect position, bool value, GUIStyle style) => value;
        public static bool Toggle(Rect position, string label, bool value) => value;
        public static bool Toggle(Rect position, string label, bool value, GUIStyle style) => value;
        public static bool ToggleLeft(Rect position, GUIContent label, bool value) => value;
        public static bool ToggleLeft(Rect position, GUIContent label, bool value, GUIStyle labelStyle) => value;
        public static bool ToggleLeft(Rect position, string label, bool value) => value;
        public static bool ToggleLeft(Rect position, string label, bool value, GUIStyle labelStyle) => value;
        public static bool actionKey { get; }
        public static bool showMixedValue { get; set; }
        public static double DelayedDoubleField(Rect position, GUIContent label, double value) => value;
        public static double DelayedDoubleField(Rect position, GUIContent label, double value, GUIStyle style) => value;
        public static double DelayedDoubleField(Rect position, double value) => value;
        public static double DelayedDoubleField(Rect position, double value, GUIStyle style) => value;
        public static double DelayedDoubleField(Rect position, string label, double value) => value;
        public static double DelayedDoubleField(Rect position, string label, double value, GUIStyle style) => value;
        public static double DoubleField(Rect position, GUIContent label, double value) => value;
        public static double DoubleField(Rect position, GUIContent label, double value, GUIStyle style) => value;
        public static double DoubleField(Rect position, double value) => value;
        public static double DoubleField(Rect position, double value, GUIStyle style) => value;
        public static double DoubleField(Rect position, string label, double value) => value;
        public static double DoubleField(Rect position, string label, double value, GUIStyle style) => value;
        public static float DelayedFloatField(Rect position, GUIContent label, float value) => value;
        public static float DelayedFloatField(Rect position, GUIContent label, float value, GUIStyle style) => value;
        public static float DelayedFloatField(Rect position, float value) => value;
        public static float DelayedFloatField(Rect position, float value, GUIStyle style) => value;
        public static float DelayedFloatField(Rect position, string label, float value) => value;
        public static float DelayedFloatField(Rect position, string label, float value, GUIStyle style) => value;
        public static float FloatField(Rect position, GUIContent label, float value) => value;
        public static float FloatField(Rect position, GUIContent label, float value, GUIStyle style) => value;
        public static float FloatField(Rect position, float value) => value;
        public static float FloatField(Rect position, float value, GUIStyle style) => value;
        public static float FloatField(Rect position, string label, float value) => value;
        public static float FloatField(Rect position, string label, float value, GUIStyle style) => value;
        public static float Slider(Rect position, GUIContent label, float value, float leftValue, float rightValue) => value;
        public static float Slider(Rect position, float value, float leftValue, float rightValue) => value;
        public static float Slider(Rect position, string label, float value, float leftValue, float rightValue) => value;
        public static int DelayedIntField(Rect position, GUIContent label, int value) => value;
        public static int DelayedIntField(Rect position, GUIContent label, int value, GUIStyle style) => value;
        public static int DelayedIntField(Rect position, int value) => value;
        public static int DelayedIntField(Rect position, int value, GUIStyle style) => value;
        public static int DelayedIntField(Rect position, string label, int value) => value;
        public static int DelayedIntField(Rect position, string label, int value, GUIStyle style) => value;
        public static int IntField(Rect position, GUIContent label, int value) => value;
        public static int IntField(Rect position, GUIContent label, int value, GUIStyle style) => value;
        public static int IntField(Rect position, int value) => value;
        public static int IntField(Rect position, int value, GUIStyle style) => value;
        public static int IntField(Rect position, string label, int value) => value;
        public static int IntField(Rect position, string label, int value, GUIStyle style) => value;
        public static int IntPopup(Rect position, GUIContent label, int selectedValue, GUIContent[] displayedOptions, int[] optionValues) => selectedValue;
        public static int IntPopup(Rect position, GUIContent label, int selectedValue, GUIContent[] displayedOptions, int[] optionValues, GUIStyle style) => selectedValue;
        public static int IntPopup(Rect position, int selectedValue, GUIContent[] displayedOptions, int[] optionValues) => selectedValue;
        public static int IntPopup(Rect position, int selectedValue, GUIContent[] displayedOptions, int[] optionValues, GUIStyle style) => selectedValue;
        public static int IntPopup(Rect position, int selectedValue, string[] displayedOptions, int[] optionValues) => selectedValue;
        public static int IntPopup(Rect position, int selectedValue, string[] displayedOptions, int[] optionValues, GUIStyle style) => selectedValue;
        public static int IntPopup(Rect position, string label, int selectedValue, string[] displayedOptions, int[] optionValues) => selectedValue;
        public static int IntPopup(Rect position, string label, int selectedValue, string[] displayedOptions, int[] optionValues, GUIStyle style) => selectedValue;
        public static int IntSlider(Rect position, GUIContent label, int value, int leftValue, int rightValue) => value;
        public static int IntSlider(Rect position, int value, int leftValue, int rightValue) => value;
        public static int IntSlider(Rect position, string label, int value, int leftValue, int rightValue) => value;
        public static int LayerField(Rect position, GUIContent label, int layer) => layer;
        public static int LayerField(Rect position, GUIContent label, int layer, GUIStyle style) => layer;
        public static int LayerField(Rect position, int layer) => layer;
        public static int LayerField(Rect position, int layer, GUIStyle style) => layer;
        public static int LayerField(Rect position, string label, int layer) => layer;
        public static int LayerField(Rect position, string label, int layer, GUIStyle style) => layer;
        public static int MaskField(Rect position, GUIContent label, int mask, string[] displayedOptions) => mask;
        public static int MaskField(Rect position, GUIContent label, int mask, string[] displayedOptions, GUIStyle style) => mask;
        public static int MaskField(Rect position, int mask, string[] displayedOptions) => mask;
        public static int MaskField(Rect position, int mask, string[] displayedOptions, GUIStyle style) => mask;
        public static int MaskField(Rect position, string label, int mask, string[] displayedOptions) => mask;
        public static int MaskField(Rect position, string label, int mask, string[] displayedOptions, GUIStyle style) => mask;
        public static int Popup(Rect position, GUIContent label, int selectedIndex, GUIContent[] displayedOptions) => selectedIndex;
        public static int Popup(Rect position, GUIContent label, int selectedIndex, GUIContent[] displayedOptions, GUIStyle style) => selectedIndex;
        public static int Popup(Rect position, int selectedIndex, GUIContent[] displayedOptions) => selectedIndex;
        public static int Popup(Rect position, int selectedIndex, GUIContent[] displayedOptions, GUIStyle style) => selectedIndex;
        public static int Popup(Rect position, int selectedIndex, string[] displayedOptions) => selectedIndex;
        public static int Popup(Rect position, int selectedIndex, string[] displayedOptions, GUIStyle style) => selectedIndex;
        public static int Popup(Rect position, string label, int selectedIndex, string[] displayedOptions) => selectedIndex;
        public static int Popup(Rect position, string label, int selectedIndex, string[] displayedOptions, GUIStyle style) => selectedIndex;
        public static int indentLevel { get; set; }
        public static long LongField(Rect position, GUIContent label, long value) => value;
        public static long LongField(Rect position, GUIContent label, long value, GUIStyle style) => value;
        public static long LongField(Rect position, long value) => value;
        public static long LongField(Rect position, long value, GUIStyle style) => value;
        public static long LongField(Rect position, string label, long value) => value;
        public static long LongField(Rect position, string label, long value, GUIStyle style) => value;
        public static string DelayedTextField(Rect position, GUIContent label, int controlId, string text) => text;
        public static string DelayedTextField(Rect position, GUIContent label, int controlId, string text, GUIStyle style) => text;
        public static string DelayedTextField(Rect position, GUIContent label, string text) => text;
        public static string DelayedTextField(Rect position, GUIContent label, string text, GUIStyle style) => text;
        public static string DelayedTextField(Rect position, string label, string text) => text;
        public static string DelayedTextField(Rect position, string label, string text, GUIStyle style) => text;
        public static string DelayedTextField(Rect position, string text) => text;
        public static string DelayedTextField(Rect position, string text, GUIStyle style) => text;
        public static string PasswordField(Rect position, GUIContent label, string password) => password;
        public static string PasswordField(Rect position, GUIContent label, string password, GUIStyle style) => password;
        public static string PasswordField(Rect position, string label, string password) => password;
        public static string PasswordField(Rect position, string label, string password, GUIStyle style) => password;
        public static string PasswordField(Rect position, string password) => password;
        public static string PasswordField(Rect position, string password, GUIStyle style) => password;
        public static string TagField(Rect position, GUIContent label, string tag) => tag;
        public static string TagField(Rect position, GUIContent label, string tag, GUIStyle style) => tag;
        public static string TagField(Rect position, string label, string tag) => tag;
        public static string TagField(Rect position, string label, string tag, GUIStyle style) => tag;
        public static string TagField(Rect position, string tag) => tag;
        public static string TagField(Rect position, string tag, GUIStyle style) => tag;
        public static string TextArea(Rect position, string text) => text;
        public static string TextArea(Rect position, string text, GUIStyle style) => text;
        public static string TextField(Rect position, GUIContent label, string text) => text;
        public static string TextField(Rect position, GUIContent label, string text, GUIStyle style) => text;
        public static string TextField(Rect position, string label, string text) => text;
        public static string TextField(Rect position, string label, string text, GUIStyle style) => text;
        public static string TextField(Rect position, string text) => text;
        public static string TextField(Rect position, string text, GUIStyle style) => text;
        public static void BeginDisabledGroup(bool disabled) { GuiGroups.Begin("DisabledGroup"); }
        public static void CurveField(Rect position, SerializedProperty property, Color color, Rect ranges) { }
        public static void CurveField(Rect position, SerializedProperty property, Color color, Rect ranges, GUIContent label) { }
        public static void DelayedFloatField(Rect position, SerializedProperty property) { }
        public static void DelayedFloatField(Rect position, SerializedProperty property, GUIContent label) { }
        public static void DelayedIntField(Rect position, SerializedProperty property) { }
        public static void DelayedIntField(Rect position, SerializedProperty property, GUIContent label) { }
        public static void DelayedTextField(Rect position, SerializedProperty property) { }
        public static void DelayedTextField(Rect position, SerializedProperty property, GUIContent label) { }
        public static void DrawPreviewTexture(Rect position, Texture image) { }
        public static void DrawPreviewTexture(Rect position, Texture image, Material mat) { }
        public static void DrawRect(Rect rect, Color color) { }
        public static void DrawTextureAlpha(Rect position, Texture image) { }
        public static void DrawTextureTransparent(Rect position, Texture image) { }
        public static void DropShadowLabel(Rect position, GUIContent content) { }
        public static void DropShadowLabel(Rect position, GUIContent content, GUIStyle style) { }
        public static void DropShadowLabel(Rect position, string text) { }
        public static void DropShadowLabel(Rect position, string text, GUIStyle style) { }
        public static void EndDisabledGroup() { GuiGroups.End("DisabledGroup"); }
        public static void EndFoldoutHeaderGroup() { GuiGroups.End("FoldoutHeaderGroup"); }
        public static void EndProperty() { GuiGroups.End("Property"); }
        public static void FocusTextInControl(string name) { }
        public static void HandlePrefixLabel(Rect totalPosition, Rect labelPosition, GUIContent label) { }
        public static void HandlePrefixLabel(Rect totalPosition, Rect labelPosition, GUIContent label, int id) { }
        public static void HandlePrefixLabel(Rect totalPosition, Rect labelPosition, GUIContent label, int id, GUIStyle style) { }
        public static void HelpBox(Rect position, string message, MessageType type) { }
        public static void InspectorTitlebar(Rect position, Object[] targetObjs) { }
        public static void IntPopup(Rect position, SerializedProperty property, GUIContent[] displayedOptions, int[] optionValues) { }
        public static void IntPopup(Rect position, SerializedProperty property, GUIContent[] displayedOptions, int[] optionValues, GUIContent label) { }
        public static void IntSlider(Rect position, SerializedProperty property, int leftValue, int rightValue) { }
        public static void IntSlider(Rect position, SerializedProperty property, int leftValue, int rightValue, GUIContent label) { }
        public static void IntSlider(Rect position, SerializedProperty property, int leftValue, int rightValue, string label) { }
        public static void LabelField(Rect position, GUIContent label) { }
        public static void LabelField(Rect position, GUIContent label, GUIContent label2) { }
        public static void LabelField(Rect position, GUIContent label, GUIContent label2, GUIStyle style) { }
        public static void LabelField(Rect position, GUIContent label, GUIStyle style) { }
        public static void LabelField(Rect position, string label) { }
        public static void LabelField(Rect position, string label, GUIStyle style) { }
        public static void LabelField(Rect position, string label, string label2) { }
        public static void LabelField(Rect position, string label, string label2, GUIStyle style) { }
        public static void MinMaxSlider(Rect position, GUIContent label, ref float minValue, ref float maxValue, float minLimit, float maxLimit) { }
        public static void MinMaxSlider(Rect position, ref float minValue, ref float maxValue, float minLimit, float maxLimit) { }
        public static void MinMaxSlider(Rect position, string label, ref float minValue, ref float maxValue, float minLimit, float maxLimit) { }
        public static void MultiFloatField(Rect position, GUIContent label, GUIContent[] subLabels, float[] values) { }
        public static void MultiFloatField(Rect position, GUIContent[] subLabels, float[] values) { }
        public static void MultiIntField(Rect position, GUIContent[] subLabels, int[] values) { }
        public static void MultiPropertyField(Rect position, GUIContent[] subLabels, SerializedProperty valuesIterator) { }
        public static void MultiPropertyField(Rect position, GUIContent[] subLabels, SerializedProperty valuesIterator, GUIContent label) { }
        public static void ObjectField(Rect position, SerializedProperty property) { }
        public static void ObjectField(Rect position, SerializedProperty property, GUIContent label) { }
        public static void ObjectField(Rect position, SerializedProperty property, Type objType) { }
        public static void ObjectField(Rect position, SerializedProperty property, Type objType, GUIContent label) { }
        public static void ProgressBar(Rect position, float value, string text) { }
        public static void SelectableLabel(Rect position, string text) { }
        public static void SelectableLabel(Rect position, string text, GUIStyle style) { }
        public static void Slider(Rect position, SerializedProperty property, float leftValue, float rightValue) { }
        public static void Slider(Rect position, SerializedProperty property, float leftValue, float rightValue, GUIContent label) { }
        public static void Slider(Rect position, SerializedProperty property, float leftValue, float rightValue, string label) { }
    }

    public partial class EditorGUILayout
    {
        public static AnimationCurve CurveField(AnimationCurve value, Color color, Rect ranges, params GUILayoutOption[] options) => value;
        public static AnimationCurve CurveField(AnimationCurve value, params GUILayoutOption[] options) => value;
        public static AnimationCurve CurveField(GUIContent label, AnimationCurve value, Color color, Rect ranges, params GUILayoutOption[] options) => value;
        public static AnimationCurve CurveField(GUIContent label, AnimationCurve value, params GUILayoutOption[] options) => value;
        public static AnimationCurve CurveField(string label, AnimationCurve value, Color color, Rect ranges, params GUILayoutOption[] options) => value;
        public static AnimationCurve CurveField(string label, AnimationCurve value, params GUILayoutOption[] options) => value;
        public static Bounds BoundsField(Bounds value, params GUILayoutOption[] options) => value;
        public static Bounds BoundsField(GUIContent label, Bounds value, params GUILayoutOption[] options) => value;
        public static Bounds BoundsField(string label, Bounds value, params GUILayoutOption[] options) => value;
        public static Color ColorField(Color value, params GUILayoutOption[] options) => value;
        public static Color ColorField(GUIContent label, Color value, bool showEyedropper, bool showAlpha, bool hdr, params GUILayoutOption[] options) => value;
        public static Color ColorField(GUIContent label, Color value, params GUILayoutOption[] options) => value;
        public static Color ColorField(string label, Color value, params GUILayoutOption[] options) => value;
        public static Enum EnumFlagsField(Enum enumValue, GUIStyle style, params GUILayoutOption[] options) => enumValue;
        public static Enum EnumFlagsField(Enum enumValue, params GUILayoutOption[] options) => enumValue;
        public static Enum EnumFlagsField(GUIContent label, Enum enumValue, GUIStyle style, params GUILayoutOption[] options) => enumValue;
        public static Enum EnumFlagsField(GUIContent label, Enum enumValue, bool includeObsolete, GUIStyle style, params GUILayoutOption[] options) => enumValue;
        public static Enum EnumFlagsField(GUIContent label, Enum enumValue, bool includeObsolete, params GUILayoutOption[] options) => enumValue;
        public static Enum EnumFlagsField(GUIContent label, Enum enumValue, params GUILayoutOption[] options) => enumValue;
        public static Enum EnumFlagsField(string label, Enum enumValue, GUIStyle style, params GUILayoutOption[] options) => enumValue;
        public static Enum EnumFlagsField(string label, Enum enumValue, params GUILayoutOption[] options) => enumValue;
        public static Enum EnumPopup(Enum selected, GUIStyle style, params GUILayoutOption[] options) => selected;
        public static Enum EnumPopup(Enum selected, params GUILayoutOption[] options) => selected;
        public static Enum EnumPopup(GUIContent label, Enum selected, GUIStyle style, params GUILayoutOption[] options) => selected;
        public static Enum EnumPopup(GUIContent label, Enum selected, params GUILayoutOption[] options) => selected;
        public static Enum EnumPopup(string label, Enum selected, GUIStyle style, params GUILayoutOption[] options) => selected;
        public static Enum EnumPopup(string label, Enum selected, params GUILayoutOption[] options) => selected;
        public static Gradient GradientField(GUIContent label, Gradient value, bool hdr, params GUILayoutOption[] options) => value;
        public static Gradient GradientField(GUIContent label, Gradient value, params GUILayoutOption[] options) => value;
        public static Gradient GradientField(Gradient value, params GUILayoutOption[] options) => value;
        public static Gradient GradientField(string label, Gradient value, params GUILayoutOption[] options) => value;
        public static Object ObjectField(GUIContent label, Object obj, Type objType, Object targetBeingEdited, params GUILayoutOption[] options) => obj;
        public static Object ObjectField(GUIContent label, Object obj, Type objType, bool allowSceneObjects, params GUILayoutOption[] options) => obj;
        public static Object ObjectField(Object obj, Type objType, Object targetBeingEdited, params GUILayoutOption[] options) => obj;
        public static Object ObjectField(Object obj, Type objType, bool allowSceneObjects, params GUILayoutOption[] options) => obj;
        public static Object ObjectField(string label, Object obj, Type objType, Object targetBeingEdited, params GUILayoutOption[] options) => obj;
        public static Object ObjectField(string label, Object obj, Type objType, bool allowSceneObjects, params GUILayoutOption[] options) => obj;
        public static Rect BeginHorizontal(GUIStyle style, params GUILayoutOption[] options) { GuiGroups.Begin("Horizontal"); return default; }
        public static Rect BeginHorizontal(params GUILayoutOption[] options) { GuiGroups.Begin("Horizontal"); return default; }
        public static Rect BeginVertical(GUIStyle style, params GUILayoutOption[] options) { GuiGroups.Begin("Vertical"); return default; }
        public static Rect BeginVertical(params GUILayoutOption[] options) { GuiGroups.Begin("Vertical"); return default; }
        public static Rect RectField(GUIContent label, Rect value, params GUILayoutOption[] options) => value;
        public static Rect RectField(Rect value, params GUILayoutOption[] options) => value;
        public static Rect RectField(string label, Rect value, params GUILayoutOption[] options) => value;
        public static Vector2 BeginScrollView(Vector2 scrollPosition, GUIStyle horizontalScrollbar, GUIStyle verticalScrollbar, params GUILayoutOption[] options) { GuiGroups.Begin("ScrollView"); return scrollPosition; }
        public static Vector2 BeginScrollView(Vector2 scrollPosition, GUIStyle style, params GUILayoutOption[] options) { GuiGroups.Begin("ScrollView"); return scrollPosition; }
        public static Vector2 BeginScrollView(Vector2 scrollPosition, bool alwaysShowHorizontal, bool alwaysShowVertical, GUIStyle horizontalScrollbar, GUIStyle verticalScrollbar, GUIStyle background, params GUILayoutOption[] options) { GuiGroups.Begin("ScrollView"); return scrollPosition; }
        public static Vector2 BeginScrollView(Vector2 scrollPosition, bool alwaysShowHorizontal, bool alwaysShowVertical, params GUILayoutOption[] options) { GuiGroups.Begin("ScrollView"); return scrollPosition; }
        public static Vector2 BeginScrollView(Vector2 scrollPosition, params GUILayoutOption[] options) { GuiGroups.Begin("ScrollView"); return scrollPosition; }
        public static Vector2 Vector2Field(GUIContent label, Vector2 value, params GUILayoutOption[] options) => value;
        public static Vector2 Vector2Field(string label, Vector2 value, params GUILayoutOption[] options) => value;
        public static Vector2Int Vector2IntField(GUIContent label, Vector2Int value, params GUILayoutOption[] options) => value;
        public static Vector2Int Vector2IntField(string label, Vector2Int value, params GUILayoutOption[] options) => value;
        public static Vector3 Vector3Field(GUIContent label, Vector3 value, params GUILayoutOption[] options) => value;
        public static Vector3 Vector3Field(string label, Vector3 value, params GUILayoutOption[] options) => value;
        public static Vector3Int Vector3IntField(GUIContent label, Vector3Int value, params GUILayoutOption[] options) => value;
        public static Vector3Int Vector3IntField(string label, Vector3Int value, params GUILayoutOption[] options) => value;
        public static Vector4 Vector4Field(GUIContent label, Vector4 value, params GUILayoutOption[] options) => value;
        public static Vector4 Vector4Field(string label, Vector4 value, params GUILayoutOption[] options) => value;
        public static bool BeginFadeGroup(float value) { GuiGroups.Begin("FadeGroup"); return default; }
        public static bool BeginToggleGroup(GUIContent label, bool toggle) { GuiGroups.Begin("ToggleGroup"); return toggle; }
        public static bool BeginToggleGroup(string label, bool toggle) { GuiGroups.Begin("ToggleGroup"); return toggle; }
        public static bool DropdownButton(GUIContent content, FocusType focusType, GUIStyle style, params GUILayoutOption[] options) => default;
        public static bool DropdownButton(GUIContent content, FocusType focusType, params GUILayoutOption[] options) => default;
        public static bool Foldout(bool foldout, GUIContent content) => foldout;
        public static bool Foldout(bool foldout, GUIContent content, GUIStyle style) => foldout;
        public static bool Foldout(bool foldout, GUIContent content, bool toggleOnLabelClick) => foldout;
        public static bool Foldout(bool foldout, GUIContent content, bool toggleOnLabelClick, GUIStyle style) => foldout;
        public static bool Foldout(bool foldout, string content) => foldout;
        public static bool Foldout(bool foldout, string content, GUIStyle style) => foldout;
        public static bool Foldout(bool foldout, string content, bool toggleOnLabelClick) => foldout;
        public static bool Foldout(bool foldout, string content, bool toggleOnLabelClick, GUIStyle style) => foldout;
        public static bool InspectorTitlebar(bool foldout, Editor editor) => foldout;
        public static bool InspectorTitlebar(bool foldout, Object targetObj) => foldout;
        public static bool InspectorTitlebar(bool foldout, Object targetObj, bool expandable) => foldout;
        public static bool InspectorTitlebar(bool foldout, Object[] targetObjs) => foldout;
        public static bool InspectorTitlebar(bool foldout, Object[] targetObjs, bool expandable) => foldout;
        public static bool LinkButton(GUIContent label, params GUILayoutOption[] options) => default;
        public static bool LinkButton(string label, params GUILayoutOption[] options) => default;
        public static bool Toggle(GUIContent label, bool value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static bool Toggle(GUIContent label, bool value, params GUILayoutOption[] options) => value;
        public static bool Toggle(bool value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static bool Toggle(bool value, params GUILayoutOption[] options) => value;
        public static bool Toggle(string label, bool value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static bool Toggle(string label, bool value, params GUILayoutOption[] options) => value;
        public static bool ToggleLeft(GUIContent label, bool value, GUIStyle labelStyle, params GUILayoutOption[] options) => value;
        public static bool ToggleLeft(GUIContent label, bool value, params GUILayoutOption[] options) => value;
        public static bool ToggleLeft(string label, bool value, GUIStyle labelStyle, params GUILayoutOption[] options) => value;
        public static bool ToggleLeft(string label, bool value, params GUILayoutOption[] options) => value;
        public static double DelayedDoubleField(GUIContent label, double value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static double DelayedDoubleField(GUIContent label, double value, params GUILayoutOption[] options) => value;
        public static double DelayedDoubleField(double value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static double DelayedDoubleField(double value, params GUILayoutOption[] options) => value;
        public static double DelayedDoubleField(string label, double value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static double DelayedDoubleField(string label, double value, params GUILayoutOption[] options) => value;
        public static double DoubleField(GUIContent label, double value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static double DoubleField(GUIContent label, double value, params GUILayoutOption[] options) => value;
        public static double DoubleField(double value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static double DoubleField(double value, params GUILayoutOption[] options) => value;
        public static double DoubleField(string label, double value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static double DoubleField(string label, double value, params GUILayoutOption[] options) => value;
        public static float DelayedFloatField(GUIContent label, float value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static float DelayedFloatField(GUIContent label, float value, params GUILayoutOption[] options) => value;
        public static float DelayedFloatField(float value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static float DelayedFloatField(float value, params GUILayoutOption[] options) => value;
        public static float DelayedFloatField(string label, float value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static float DelayedFloatField(string label, float value, params GUILayoutOption[] options) => value;
        public static float FloatField(GUIContent label, float value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static float FloatField(GUIContent label, float value, params GUILayoutOption[] options) => value;
        public static float FloatField(float value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static float FloatField(float value, params GUILayoutOption[] options) => value;
        public static float FloatField(string label, float value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static float FloatField(string label, float value, params GUILayoutOption[] options) => value;
        public static float Knob(Vector2 knobSize, float value, float minValue, float maxValue, string unit, Color backgroundColor, Color activeColor, bool showValue, params GUILayoutOption[] options) => value;
        public static float Slider(GUIContent label, float value, float leftValue, float rightValue, params GUILayoutOption[] options) => value;
        public static float Slider(float value, float leftValue, float rightValue, params GUILayoutOption[] options) => value;
        public static float Slider(string label, float value, float leftValue, float rightValue, params GUILayoutOption[] options) => value;
        public static int DelayedIntField(GUIContent label, int value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static int DelayedIntField(GUIContent label, int value, params GUILayoutOption[] options) => value;
        public static int DelayedIntField(int value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static int DelayedIntField(int value, params GUILayoutOption[] options) => value;
        public static int DelayedIntField(string label, int value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static int DelayedIntField(string label, int value, params GUILayoutOption[] options) => value;
        public static int IntField(GUIContent label, int value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static int IntField(GUIContent label, int value, params GUILayoutOption[] options) => value;
        public static int IntField(int value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static int IntField(int value, params GUILayoutOption[] options) => value;
        public static int IntField(string label, int value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static int IntField(string label, int value, params GUILayoutOption[] options) => value;
        public static int IntPopup(GUIContent label, int selectedValue, GUIContent[] displayedOptions, int[] optionValues, GUIStyle style, params GUILayoutOption[] options) => selectedValue;
        public static int IntPopup(GUIContent label, int selectedValue, GUIContent[] displayedOptions, int[] optionValues, params GUILayoutOption[] options) => selectedValue;
        public static int IntPopup(int selectedValue, GUIContent[] displayedOptions, int[] optionValues, GUIStyle style, params GUILayoutOption[] options) => selectedValue;
        public static int IntPopup(int selectedValue, GUIContent[] displayedOptions, int[] optionValues, params GUILayoutOption[] options) => selectedValue;
        public static int IntPopup(int selectedValue, string[] displayedOptions, int[] optionValues, GUIStyle style, params GUILayoutOption[] options) => selectedValue;
        public static int IntPopup(int selectedValue, string[] displayedOptions, int[] optionValues, params GUILayoutOption[] options) => selectedValue;
        public static int IntPopup(string label, int selectedValue, string[] displayedOptions, int[] optionValues, GUIStyle style, params GUILayoutOption[] options) => selectedValue;
        public static int IntPopup(string label, int selectedValue, string[] displayedOptions, int[] optionValues, params GUILayoutOption[] options) => selectedValue;
        public static int IntSlider(GUIContent label, int value, int leftValue, int rightValue, params GUILayoutOption[] options) => value;
        public static int IntSlider(int value, int leftValue, int rightValue, params GUILayoutOption[] options) => value;
        public static int IntSlider(string label, int value, int leftValue, int rightValue, params GUILayoutOption[] options) => value;
        public static int LayerField(GUIContent label, int layer, GUIStyle style, params GUILayoutOption[] options) => layer;
        public static int LayerField(GUIContent label, int layer, params GUILayoutOption[] options) => layer;
        public static int LayerField(int layer, GUIStyle style, params GUILayoutOption[] options) => layer;
        public static int LayerField(int layer, params GUILayoutOption[] options) => layer;
        public static int LayerField(string label, int layer, GUIStyle style, params GUILayoutOption[] options) => layer;
        public static int LayerField(string label, int layer, params GUILayoutOption[] options) => layer;
        public static int MaskField(GUIContent label, int mask, string[] displayedOptions, GUIStyle style, params GUILayoutOption[] options) => mask;
        public static int MaskField(GUIContent label, int mask, string[] displayedOptions, params GUILayoutOption[] options) => mask;
        public static int MaskField(int mask, string[] displayedOptions, GUIStyle style, params GUILayoutOption[] options) => mask;
        public static int MaskField(int mask, string[] displayedOptions, params GUILayoutOption[] options) => mask;
        public static int MaskField(string label, int mask, string[] displayedOptions, GUIStyle style, params GUILayoutOption[] options) => mask;
        public static int MaskField(string label, int mask, string[] displayedOptions, params GUILayoutOption[] options) => mask;
        public static int Popup(GUIContent label, int selectedIndex, GUIContent[] displayedOptions, GUIStyle style, params GUILayoutOption[] options) => selectedIndex;
        public static int Popup(GUIContent label, int selectedIndex, GUIContent[] displayedOptions, params GUILayoutOption[] options) => selectedIndex;
        public static int Popup(GUIContent label, int selectedIndex, string[] displayedOptions, params GUILayoutOption[] options) => selectedIndex;
        public static int Popup(int selectedIndex, GUIContent[] displayedOptions, GUIStyle style, params GUILayoutOption[] options) => selectedIndex;
        public static int Popup(int selectedIndex, GUIContent[] displayedOptions, params GUILayoutOption[] options) => selectedIndex;
        public static int Popup(int selectedIndex, string[] displayedOptions, GUIStyle style, params GUILayoutOption[] options) => selectedIndex;
        public static int Popup(int selectedIndex, string[] displayedOptions, params GUILayoutOption[] options) => selectedIndex;
        public static int Popup(string label, int selectedIndex, string[] displayedOptions, GUIStyle style, params GUILayoutOption[] options) => selectedIndex;
        public static int Popup(string label, int selectedIndex, string[] displayedOptions, params GUILayoutOption[] options) => selectedIndex;
        public static long LongField(GUIContent label, long value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static long LongField(GUIContent label, long value, params GUILayoutOption[] options) => value;
        public static long LongField(long value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static long LongField(long value, params GUILayoutOption[] options) => value;
        public static long LongField(string label, long value, GUIStyle style, params GUILayoutOption[] options) => value;
        public static long LongField(string label, long value, params GUILayoutOption[] options) => value;
        public static string DelayedTextField(GUIContent label, string text, GUIStyle style, params GUILayoutOption[] options) => text;
        public static string DelayedTextField(GUIContent label, string text, params GUILayoutOption[] options) => text;
        public static string DelayedTextField(string label, string text, GUIStyle style, params GUILayoutOption[] options) => text;
        public static string DelayedTextField(string label, string text, params GUILayoutOption[] options) => text;
        public static string DelayedTextField(string text, GUIStyle style, params GUILayoutOption[] options) => text;
        public static string DelayedTextField(string text, params GUILayoutOption[] options) => text;
        public static string PasswordField(GUIContent label, string password, GUIStyle style, params GUILayoutOption[] options) => password;
        public static string PasswordField(GUIContent label, string password, params GUILayoutOption[] options) => password;
        public static string PasswordField(string label, string password, GUIStyle style, params GUILayoutOption[] options) => password;
        public static string PasswordField(string label, string password, params GUILayoutOption[] options) => password;
        public static string PasswordField(string password, GUIStyle style, params GUILayoutOption[] options) => password;
        public static string PasswordField(string password, params GUILayoutOption[] options) => password;
        public static string TagField(GUIContent label, string tag, GUIStyle style, params GUILayoutOption[] options) => tag;
        public static string TagField(GUIContent label, string tag, params GUILayoutOption[] options) => tag;
        public static string TagField(string label, string tag, GUIStyle style, params GUILayoutOption[] options) => tag;
        public static string TagField(string label, string tag, params GUILayoutOption[] options) => tag;
        public static string TagField(string tag, GUIStyle style, params GUILayoutOption[] options) => tag;
        public static string TagField(string tag, params GUILayoutOption[] options) => tag;
        public static string TextArea(string text, GUIStyle style, params GUILayoutOption[] options) => text;
        public static string TextArea(string text, params GUILayoutOption[] options) => text;
        public static string TextField(GUIContent label, string text, GUIStyle style, params GUILayoutOption[] options) => text;
        public static string TextField(GUIContent label, string text, params GUILayoutOption[] options) => text;
        public static string TextField(string label, string text, GUIStyle style, params GUILayoutOption[] options) => text;
        public static string TextField(string label, string text, params GUILayoutOption[] options) => text;
        public static string TextField(string text, GUIStyle style, params GUILayoutOption[] options) => text;
        public static string TextField(string text, params GUILayoutOption[] options) => text;
        public static void CurveField(SerializedProperty property, Color color, Rect ranges, GUIContent label, params GUILayoutOption[] options) { }
        public static void CurveField(SerializedProperty property, Color color, Rect ranges, params GUILayoutOption[] options) { }
        public static void DelayedFloatField(SerializedProperty property, GUIContent label, params GUILayoutOption[] options) { }
        public static void DelayedFloatField(SerializedProperty property, params GUILayoutOption[] options) { }
        public static void DelayedIntField(SerializedProperty property, GUIContent label, params GUILayoutOption[] options) { }
        public static void DelayedIntField(SerializedProperty property, params GUILayoutOption[] options) { }
        public static void DelayedTextField(SerializedProperty property, GUIContent label, params GUILayoutOption[] options) { }
        public static void DelayedTextField(SerializedProperty property, params GUILayoutOption[] options) { }
        public static void EndBuildTargetSelectionGrouping() { GuiGroups.End("BuildTargetSelectionGrouping"); }
        public static void EndFadeGroup() { GuiGroups.End("FadeGroup"); }
        public static void EndFoldoutHeaderGroup() { GuiGroups.End("FoldoutHeaderGroup"); }
        public static void EndHorizontal() { GuiGroups.End("Horizontal"); }
        public static void EndScrollView() { GuiGroups.End("ScrollView"); }
        public static void EndToggleGroup() { GuiGroups.End("ToggleGroup"); }
        public static void EndVertical() { GuiGroups.End("Vertical"); }
        public static void InspectorTitlebar(Object[] targetObjs) { }
        public static void IntPopup(SerializedProperty property, GUIContent[] displayedOptions, int[] optionValues, GUIContent label, params GUILayoutOption[] options) { }
        public static void IntPopup(SerializedProperty property, GUIContent[] displayedOptions, int[] optionValues, params GUILayoutOption[] options) { }
        public static void IntSlider(SerializedProperty property, int leftValue, int rightValue, GUIContent label, params GUILayoutOption[] options) { }
        public static void IntSlider(SerializedProperty property, int leftValue, int rightValue, params GUILayoutOption[] options) { }
        public static void IntSlider(SerializedProperty property, int leftValue, int rightValue, string label, params GUILayoutOption[] options) { }
        public static void MinMaxSlider(GUIContent label, ref float minValue, ref float maxValue, float minLimit, float maxLimit, params GUILayoutOption[] options) { }
        public static void MinMaxSlider(ref float minValue, ref float maxValue, float minLimit, float maxLimit, params GUILayoutOption[] options) { }
        public static void MinMaxSlider(string label, ref float minValue, ref float maxValue, float minLimit, float maxLimit, params GUILayoutOption[] options) { }
        public static void ObjectField(SerializedProperty property, GUIContent label, params GUILayoutOption[] options) { }
        public static void ObjectField(SerializedProperty property, Type objType, GUIContent label, params GUILayoutOption[] options) { }
        public static void ObjectField(SerializedProperty property, Type objType, params GUILayoutOption[] options) { }
        public static void ObjectField(SerializedProperty property, params GUILayoutOption[] options) { }
        public static void PrefixLabel(GUIContent label) { }
        public static void PrefixLabel(GUIContent label, GUIStyle followingStyle) { }
        public static void PrefixLabel(GUIContent label, GUIStyle followingStyle, GUIStyle labelStyle) { }
        public static void PrefixLabel(string label) { }
        public static void PrefixLabel(string label, GUIStyle followingStyle) { }
        public static void PrefixLabel(string label, GUIStyle followingStyle, GUIStyle labelStyle) { }
        public static void SelectableLabel(string text, GUIStyle style, params GUILayoutOption[] options) { }
        public static void SelectableLabel(string text, params GUILayoutOption[] options) { }
        public static void Separator() { }
        public static void Slider(SerializedProperty property, float leftValue, float rightValue, GUIContent label, params GUILayoutOption[] options) { }
        public static void Slider(SerializedProperty property, float leftValue, float rightValue, params GUILayoutOption[] options) { }
        public static void Slider(SerializedProperty property, float leftValue, float rightValue, string label, params GUILayoutOption[] options) { }
        public static void Space() { }
        public static void Space(float width) { }
        public static void Space(float width, bool expand) { }
    }

    public partial class EditorGUIUtility : GUIUtility
    {
        public static Event CommandEvent(string commandName) => default;
        public static GUIContent IconContent(string name) => new GUIContent();
        public static GUIContent IconContent(string name, string text) => new GUIContent();
        public static GUIContent ObjectContent(UnityObject obj, Type type) => new GUIContent();
        public static GUIContent TrIconContent(Texture icon, string tooltip = null) => new GUIContent();
        public static GUIContent TrIconContent(string iconName, string tooltip = null) => new GUIContent();
        public static GUIContent TrTempContent(string t) => new GUIContent();
        public static GUIContent TrTextContent(string key, string text, string tooltip, Texture icon) => new GUIContent();
        public static GUIContent TrTextContent(string text, Texture icon) => new GUIContent();
        public static GUIContent TrTextContent(string text, string tooltip = null, Texture icon = null) => new GUIContent();
        public static GUIContent TrTextContent(string text, string tooltip, string iconName) => new GUIContent();
        public static GUIContent TrTextContentWithIcon(string text, MessageType messageType) => new GUIContent();
        public static GUIContent TrTextContentWithIcon(string text, Texture icon) => new GUIContent();
        public static GUIContent TrTextContentWithIcon(string text, string iconName) => new GUIContent();
        public static GUIContent TrTextContentWithIcon(string text, string tooltip, MessageType messageType) => new GUIContent();
        public static GUIContent TrTextContentWithIcon(string text, string tooltip, Texture icon) => new GUIContent();
        public static GUIContent TrTextContentWithIcon(string text, string tooltip, string iconName) => new GUIContent();
        public static GUIContent[] TrTempContent(string[] texts) => default;
        public static GUIContent[] TrTempContent(string[] texts, string[] tooltips) => default;
        public static Rect GetMainWindowPosition() => default;
        public static Rect PixelsToPoints(Rect rect) => default;
        public static Rect PointsToPixels(Rect rect) => default;
        public static Texture2D FindTexture(string name) => default;
        public static Texture2D GetIconForObject(Object obj) => default;
        public static Texture2D whiteTexture { get; }
        public static UnityObject GetObjectPickerObject() => default;
        public static UnityObject Load(string path) => default;
        public static UnityObject LoadRequired(string path) => default;
        public static Vector2 GetIconSize() => default;
        public static Vector2 PixelsToPoints(Vector2 position) => position;
        public static Vector2 PointsToPixels(Vector2 position) => position;
        public static bool HasObjectThumbnail(Type objType) => default;
        public static bool IsDisplayReferencedByCameras(int displayIndex) => default;
        public static bool editingTextField { get; set; }
        public static bool hierarchyMode { get; set; }
        public static bool isProSkin { get; }
        public static bool textFieldHasSelection { get; }
        public static bool wideMode { get; set; }
        public static float fieldWidth { get; set; }
        public static float pixelsPerPoint { get; } = 1;
        public static float singleLineHeight { get; } = 18;
        public static float standardVerticalSpacing { get; } = 1;
        public static int GetObjectPickerControlID() => default;
        public static string SerializeMainMenuToString() => default;
        public new static string systemCopyBuffer { get; set; }
        public static void DrawColorSwatch(Rect position, Color color) { }
        public static void DrawCurveSwatch(Rect position, AnimationCurve curve, SerializedProperty property, Color color, Color bgColor) { }
        public static void DrawCurveSwatch(Rect position, AnimationCurve curve, SerializedProperty property, Color color, Color bgColor, Color topFillColor, Color bottomFillColor) { }
        public static void DrawCurveSwatch(Rect position, AnimationCurve curve, SerializedProperty property, Color color, Color bgColor, Color topFillColor, Color bottomFillColor, Rect curveRanges) { }
        public static void DrawCurveSwatch(Rect position, AnimationCurve curve, SerializedProperty property, Color color, Color bgColor, Rect curveRanges) { }
        public static void DrawRegionSwatch(Rect position, AnimationCurve curve, AnimationCurve curve2, Color color, Color bgColor, Rect curveRanges) { }
        public static void DrawRegionSwatch(Rect position, SerializedProperty property, SerializedProperty property2, Color color, Color bgColor, Rect curveRanges) { }
        public static void PingObject(UnityObject obj) { }
        public static void PingObject(int targetInstanceID) { }
        public static void QueueGameViewInputEvent(Event evt) { }
        public static void SetIconForObject(Object obj, Texture2D icon) { }
        public static void SetIconSize(Vector2 size) { }
        public static void SetMainWindowPosition(Rect position) { }
        public static void SetMenuLocalizationTestMode(bool onoff) { }
        public static void SetWantsMouseJumping(int wantz) { }
    }

    public partial class EditorStyles
    {
        public static GUIStyle ApplyUSS(GUIStyle style, string ussStyleRuleName, string ussInPlaceStyleOverride = null) => new GUIStyle();
        public static GUIStyle FromUSS(GUIStyle baseStyle, string ussStyleRuleName, string ussInPlaceStyleOverride = null) => new GUIStyle();
        public static GUIStyle FromUSS(string ussStyleRuleName, string ussInPlaceStyleOverride = null) => new GUIStyle();
        public static GUIStyle boldLabel { get; } = new GUIStyle();
        public static GUIStyle centeredGreyMiniLabel { get; } = new GUIStyle();
        public static GUIStyle colorField { get; } = new GUIStyle();
        public static GUIStyle foldout { get; } = new GUIStyle();
        public static GUIStyle foldoutHeader { get; } = new GUIStyle();
        public static GUIStyle foldoutHeaderIcon { get; } = new GUIStyle();
        public static GUIStyle foldoutPreDrop { get; } = new GUIStyle();
        public static GUIStyle helpBox { get; } = new GUIStyle();
        public static GUIStyle iconButton { get; } = new GUIStyle();
        public static GUIStyle inspectorDefaultMargins { get; } = new GUIStyle();
        public static GUIStyle inspectorFullWidthMargins { get; } = new GUIStyle();
        public static GUIStyle label { get; } = new GUIStyle();
        public static GUIStyle largeLabel { get; } = new GUIStyle();
        public static GUIStyle layerMaskField { get; } = new GUIStyle();
        public static GUIStyle linkLabel { get; } = new GUIStyle();
        public static GUIStyle miniBoldLabel { get; } = new GUIStyle();
        public static GUIStyle miniButton { get; } = new GUIStyle();
        public static GUIStyle miniButtonLeft { get; } = new GUIStyle();
        public static GUIStyle miniButtonMid { get; } = new GUIStyle();
        public static GUIStyle miniButtonRight { get; } = new GUIStyle();
        public static GUIStyle miniLabel { get; } = new GUIStyle();
        public static GUIStyle miniPullDown { get; } = new GUIStyle();
        public static GUIStyle miniTextField { get; } = new GUIStyle();
        public static GUIStyle numberField { get; } = new GUIStyle();
        public static GUIStyle objectField { get; } = new GUIStyle();
        public static GUIStyle objectFieldMiniThumb { get; } = new GUIStyle();
        public static GUIStyle objectFieldThumb { get; } = new GUIStyle();
        public static GUIStyle popup { get; } = new GUIStyle();
        public static GUIStyle radioButton { get; } = new GUIStyle();
        public static GUIStyle selectionRect { get; } = new GUIStyle();
        public static GUIStyle textArea { get; } = new GUIStyle();
        public static GUIStyle textField { get; } = new GUIStyle();
        public static GUIStyle toggle { get; } = new GUIStyle();
        public static GUIStyle toggleGroup { get; } = new GUIStyle();
        public static GUIStyle toolbar { get; } = new GUIStyle();
        public static GUIStyle toolbarButton { get; } = new GUIStyle();
        public static GUIStyle toolbarDropDown { get; } = new GUIStyle();
        public static GUIStyle toolbarPopup { get; } = new GUIStyle();
        public static GUIStyle toolbarSearchField { get; } = new GUIStyle();
        public static GUIStyle toolbarTextField { get; } = new GUIStyle();
        public static GUIStyle whiteBoldLabel { get; } = new GUIStyle();
        public static GUIStyle whiteLabel { get; } = new GUIStyle();
        public static GUIStyle whiteLargeLabel { get; } = new GUIStyle();
        public static GUIStyle whiteMiniLabel { get; } = new GUIStyle();
        public static GUIStyle wordWrappedLabel { get; } = new GUIStyle { wordWrap = true };
        public static GUIStyle wordWrappedMiniLabel { get; } = new GUIStyle { wordWrap = true };
    }

    public partial class Handles
    {
        public static Color UIColliderHandleColor { get; } = Color.white;
        public static Color centerColor { get; } = Color.white;
        public static Color color { get; set; } = Color.white;
        public static Color elementColor { get; } = Color.white;
        public static Color elementPreselectionColor { get; } = Color.white;
        public static Color elementSelectionColor { get; } = Color.white;
        public static Color preselectionColor { get; } = Color.white;
        public static Color secondaryColor { get; } = Color.white;
        public static Color selectedColor { get; } = Color.white;
        public static Color xAxisColor { get; } = Color.white;
        public static Color yAxisColor { get; } = Color.white;
        public static Color zAxisColor { get; } = Color.white;
        public static Matrix4x4 inverseMatrix { get; } = Matrix4x4.identity;
        public static Matrix4x4 matrix { get; set; } = Matrix4x4.identity;
        public static Quaternion Disc(Quaternion rotation, Vector3 position, Vector3 axis, float size, bool cutoffPlane, float snap) => rotation;
        public static Quaternion Disc(int id, Quaternion rotation, Vector3 position, Vector3 axis, float size, bool cutoffPlane, float snap) => rotation;
        public static Quaternion DoRotationHandle(Quaternion rotation, Vector3 position) => rotation;
        public static Quaternion FreeRotateHandle(Quaternion rotation, Vector3 position, float size) => rotation;
        public static Quaternion FreeRotateHandle(int id, Quaternion rotation, Vector3 position, float size) => rotation;
        public static Quaternion RotationHandle(Quaternion rotation, Vector3 position) => rotation;
        public static Vector2 GetMainGameViewSize() => default;
        public static Vector2 SnapValue(Vector2 value, Vector2 snap) => value;
        public static Vector3 DoPositionHandle(Vector3 position, Quaternion rotation) => position;
        public static Vector3 DoScaleHandle(Vector3 scale, Vector3 position, Quaternion rotation, float size) => position;
        public static Vector3 PositionHandle(Vector3 position, Quaternion rotation) => position;
        public static Vector3 ScaleHandle(Vector3 scale, Vector3 position, Quaternion rotation) => position;
        public static Vector3 ScaleHandle(Vector3 scale, Vector3 position, Quaternion rotation, float size) => position;
        public static Vector3 Slider(Vector3 position, Vector3 direction) => position;
        public static Vector3 SnapValue(Vector3 value, Vector3 snap) => value;
        public static Vector3[] MakeBezierPoints(Vector3 startPosition, Vector3 endPosition, Vector3 startTangent, Vector3 endTangent, int division) => default;
        public static bool ShouldRenderGizmos() => default;
        public static bool lighting { get; set; }
        public static float RadiusHandle(Quaternion rotation, Vector3 position, float radius) => radius;
        public static float RadiusHandle(Quaternion rotation, Vector3 position, float radius, bool handlesOnly) => radius;
        public static float ScaleSlider(float scale, Vector3 position, Vector3 direction, Quaternion rotation, float size, float snap) => scale;
        public static float ScaleSlider(int id, float scale, Vector3 position, Vector3 direction, Quaternion rotation, float size, float snap) => scale;
        public static float SnapValue(float value, float snap) => value;
        public static float lineThickness { get; }
        public static void BeginGUI() { GuiGroups.Begin("GUI"); }
        public static void ClearCamera(Rect position, Camera camera) { }
        public static void DrawAAConvexPolygon(params Vector3[] points) { }
        public static void DrawAAPolyLine(Color[] colors, Vector3[] points) { }
        public static void DrawAAPolyLine(Texture2D lineTex, float width, params Vector3[] points) { }
        public static void DrawAAPolyLine(Texture2D lineTex, params Vector3[] points) { }
        public static void DrawAAPolyLine(float width, Color[] colors, Vector3[] points) { }
        public static void DrawAAPolyLine(float width, int actualNumberOfPoints, params Vector3[] points) { }
        public static void DrawAAPolyLine(float width, params Vector3[] points) { }
        public static void DrawAAPolyLine(params Vector3[] points) { }
        public static void DrawBezier(Vector3 startPosition, Vector3 endPosition, Vector3 startTangent, Vector3 endTangent, Color color, Texture2D texture, float width) { }
        public static void DrawCamera(Rect position, Camera camera) { }
        public static void DrawDottedLine(Vector3 p1, Vector3 p2, float screenSpaceSize) { }
        public static void DrawDottedLines(Vector3[] lineSegments, float screenSpaceSize) { }
        public static void DrawDottedLines(Vector3[] points, int[] segmentIndices, float screenSpaceSize) { }
        public static void DrawGizmos(Camera camera) { }
        public static void DrawLine(Vector3 p1, Vector3 p2) { }
        public static void DrawLine(Vector3 p1, Vector3 p2, float thickness) { }
        public static void DrawLines(Vector3[] lineSegments) { }
        public static void DrawLines(Vector3[] points, int[] segmentIndices) { }
        public static void DrawOutline(GameObject[] objects, Color color, float fillOpacity = 0) { }
        public static void DrawOutline(GameObject[] objects, Color parentNodeColor, Color childNodeColor, float fillOpacity = 0) { }
        public static void DrawOutline(int[] parentRenderers, int[] childRenderers, Color parentNodeColor, Color childNodeColor, float fillOpacity = 0) { }
        public static void DrawOutline(int[] renderers, Color color, float fillOpacity = 0) { }
        public static void DrawPolyLine(params Vector3[] points) { }
        public static void DrawSolidArc(Vector3 center, Vector3 normal, Vector3 from, float angle, float radius) { }
        public static void DrawSolidDisc(Vector3 center, Vector3 normal, float radius) { }
        public static void DrawSolidRectangleWithOutline(Rect rectangle, Color faceColor, Color outlineColor) { }
        public static void DrawSolidRectangleWithOutline(Vector3[] verts, Color faceColor, Color outlineColor) { }
        public static void DrawTexture3DSDF(Texture texture, float stepScale = 1.0f, float surfaceOffset = 0.0f, Gradient customColorRamp = null) { }
        public static void DrawWireArc(Vector3 center, Vector3 normal, Vector3 from, float angle, float radius) { }
        public static void DrawWireArc(Vector3 center, Vector3 normal, Vector3 from, float angle, float radius, float thickness) { }
        public static void DrawWireCube(Vector3 center, Vector3 size) { }
        public static void DrawWireDisc(Vector3 center, Vector3 normal, float radius) { }
        public static void DrawWireDisc(Vector3 center, Vector3 normal, float radius, float thickness) { }
        public static void EndGUI() { GuiGroups.End("GUI"); }
        public static void Label(Vector3 position, GUIContent content) { }
        public static void Label(Vector3 position, GUIContent content, GUIStyle style) { }
        public static void Label(Vector3 position, Texture image) { }
        public static void Label(Vector3 position, string text) { }
        public static void Label(Vector3 position, string text, GUIStyle style) { }
        public static void SelectionFrame(int controlID, Vector3 position, Quaternion rotation, float size) { }
        public static void SetCamera(Camera camera) { }
        public static void SetCamera(Rect position, Camera camera) { }
        public static void TransformHandle(Vector3 position, ref Quaternion rotation, ref Vector3 scale) { }
        public static void TransformHandle(Vector3 position, ref Quaternion rotation, ref float uniformScale) { }
        public static void TransformHandle(ref Vector3 position, Quaternion rotation, ref Vector3 scale) { }
        public static void TransformHandle(ref Vector3 position, Quaternion rotation, ref float uniformScale) { }
        public static void TransformHandle(ref Vector3 position, ref Quaternion rotation) { }
        public static void TransformHandle(ref Vector3 position, ref Quaternion rotation, ref Vector3 scale) { }
        public static void TransformHandle(ref Vector3 position, ref Quaternion rotation, ref float uniformScale) { }
    }

    public partial class Undo
    {
        public static bool isProcessing { get; }
        public static void ClearUndo(Object identifier) { }
        public static void FlushUndoRecordObjects() { }
        public static void RegisterChildrenOrderUndo(Object objectToUndo, string name) { }
        public static void RegisterFullObjectHierarchyUndo(Object objectToUndo, string name) { }
        public static void RegisterImporterUndo(string path, string name) { }
        public static void RevertAllDownToGroup(int group) { }
        public static void RevertAllInCurrentGroup() { }
    }
}
