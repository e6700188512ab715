#!/usr/bin/env python3
"""Writes the drawing classes that do nothing here: GUI, Gizmos, EditorGUILayout, Handles and kin.

    generate_gui.py API_LIST [API_LIST ...]

Each API list has lines "Namespace.Type | signature". Only members that all lists agree on are written, and of those the
ones whose types this host knows. A field's value comes back as it went in, a button is never pressed. What begins a group
or ends one says so to GuiGroups, which throws where they do not match.
Rewrites ../UnityEngine/Misc/GUI.Generated.cs and GUI.Generated.cs beside this script.
"""
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
KNOWN = set("""void bool int uint long ulong float double string object char byte
Vector2 Vector3 Vector4 Vector2Int Vector3Int Color Color32 Quaternion Matrix4x4 Rect Bounds Ray Plane AnimationCurve Gradient LayerMask
Texture Texture2D Mesh Material Camera Object UnityEngine.Object UnityObject GameObject Component Transform Type System.Type Enum Action Scene
GUIContent GUIStyle GUISkin GUILayoutOption FocusType Event SerializedProperty SerializedObject Editor MessageType WindowFunction
GUI.WindowFunction GUI.ToolbarButtonSize ToolbarButtonSize HideFlags""".split())
ECHOED = ["value", "foldout", "selected", "selectedIndex", "selectedValue", "toggle", "text", "password", "obj", "enumValue",
          "scrollPosition", "tag", "layer", "mask", "clientRect", "screenRect", "position", "rotation", "scale", "radius", "size", "handlePos"]
TARGETS = [
    ("../UnityEngine/Misc/GUI.Generated.cs", "UnityEngine", ["GUI", "GUILayout", "GUIUtility", "GUILayoutUtility", "Gizmos"]),
    ("GUI.Generated.cs", "UnityEditor", ["EditorGUI", "EditorGUILayout", "EditorGUIUtility", "EditorStyles", "Handles", "Undo"]),
]
BASES = {"EditorGUIUtility": "GUIUtility", "Handles": None}
HIDES = {("EditorGUIUtility", "systemCopyBuffer")}
# Written by hand beside this file.
BY_HAND = {("Undo", "AddComponent"), ("Undo", "DestroyObjectImmediate"), ("Undo", "SetTransformParent"), ("Undo", "SetSiblingIndex"),
           ("Undo", "MoveGameObjectToScene"), ("Undo", "RecordObject"), ("Undo", "RecordObjects"), ("Undo", "RegisterCompleteObjectUndo"),
           ("Undo", "RegisterCreatedObjectUndo"), ("Undo", "IncrementCurrentGroup"), ("Undo", "GetCurrentGroup"), ("Undo", "GetCurrentGroupName"),
           ("Undo", "SetCurrentGroupName"), ("Undo", "CollapseUndoOperations"), ("Undo", "PerformUndo"), ("Undo", "PerformRedo"), ("Undo", "ClearAll"),
           ("GUILayout", "Button"), ("GUI", "Label"), ("EditorGUI", "PropertyField"), ("EditorGUI", "GetPropertyHeight"), ("EditorGUI", "BeginProperty"),
           ("EditorGUILayout", "GetControlRect"), ("EditorGUILayout", "LabelField"), ("EditorGUIUtility", "currentViewWidth"), ("EditorGUIUtility", "labelWidth"),
           ("GUILayout", "Width"), ("GUILayout", "Height"), ("EditorGUI", "BeginChangeCheck"), ("EditorGUI", "EndChangeCheck"),
           ("EditorGUILayout", "PropertyField"), ("EditorGUILayout", "HelpBox")}


def members(lists, full_name):
    found = None
    for lines in lists:
        own = [l.split(" | ", 1)[1] for l in lines if l.startswith(full_name + " | ")]
        found = own if found is None else [m for m in found if m in own]
    return list(dict.fromkeys(found))


def known(type_name):
    return re.sub(r"(\[\])+$", "", type_name) in KNOWN


def parameter(text):
    """(modifier, type, name, default) or None when a type is unknown."""
    match = re.fullmatch(r"(params |ref |out |in )?([\w.]+(?:\[\])*) (\w+)\s*(?:= (.+))?", text.strip())
    if not match or not known(match.group(2)):
        return None
    return (match.group(1) or "").strip(), match.group(2), match.group(3), match.group(4)


def split(parameters):
    return [p for p in re.split(r",\s*(?![^<(\[]*[>)\]])", parameters) if p.strip()]


def nothing(t):
    if t in ("GUIStyle", "GUIContent", "GUILayoutOption", "GUISkin"):
        return f"new {t}()" if t != "GUISkin" else "null"
    return "default"


def method(owner, line):
    match = re.fullmatch(r"static ([\w.]+(?:\[\])*) (\w+)\((.*)\)", line)
    if not match or not known(match.group(1)) or (owner, match.group(2)) in BY_HAND:
        return None
    result, name = match.group(1), match.group(2)
    parsed = [parameter(p) for p in split(match.group(3))]
    if None in parsed:
        return None
    shown = ", ".join((m + " " if m else "") + f"{t} {n}" + (f" = {d}" if d else "") for m, t, n, d in parsed)
    head = f"public static {result} {name}({shown})"
    outs = "".join(f"{n} = default; " for m, t, n, d in parsed if m == "out")
    echo = next((n for wanted in ECHOED for m, t, n, d in parsed if n == wanted and t == result), None)
    answer = echo or nothing(result)
    group = re.fullmatch(r"(Begin|End)(\w+)", name)
    if group:
        call = f'GuiGroups.{group.group(1)}("{group.group(2)}");'
        return f"{head} {{ {outs}{call}{'' if result == 'void' else f' return {answer};'} }}"
    if result == "void":
        return f"{head} {{ {outs}}}"
    return f"{head} {{ {outs}return {answer}; }}" if outs else f"{head} => {answer};"


def member(owner, line):
    named = re.match(r"static [\w.]+ (\w+) \{", line)
    if named and (owner, named.group(1)) in BY_HAND:
        return None
    match = re.fullmatch(r"static ([\w.]+(?:\[\])*) (\w+) \{ get( set)? \}", line)
    if match:
        t, name, settable = match.groups()
        if not known(t):
            return None
        start = {"Color": "Color.white", "Matrix4x4": "Matrix4x4.identity", "float": "0", "bool": "false"}.get(t, nothing(t))
        if name.startswith("wordWrapped"):
            start = "new GUIStyle { wordWrap = true }"
        if name == "enabled":
            start = "true"
        if name == "singleLineHeight":
            start = "18"
        if name in ("pixelsPerPoint", "standardVerticalSpacing"):
            start = "1"
        new = "new " if (owner, name) in HIDES else ""
        return f"public {new}static {t} {name} {{ get;{' set;' if settable else ''} }}" + ("" if start in ("default", "0", "false", "null") else f" = {start};")
    return method(owner, line)


def write(path, namespace, types, lists):
    out = ["// Written by UnityEditor/generate_gui.py; change that instead.", "using System;"]
    out += ["using UnityEngine;", "using UnityEngine.Headless;", "using UnityEngine.SceneManagement;", "using Object = UnityEngine.Object;", "using UnityObject = UnityEngine.Object;"] if namespace == "UnityEditor" else ["using UnityEngine.Headless;"]
    out += ["", f"namespace {namespace}", "{"]
    for i, name in enumerate(types):
        base = BASES.get(name)
        out.append(f"    public partial class {name}{' : ' + base if base else ''}\n    {{")
        for line in members(lists, f"{namespace}.{name}"):
            if "[Obsolete]" in line:
                continue
            code = member(name, line)
            if code:
                out.append("        " + code)
        out.append("    }" + ("\n" if i + 1 < len(types) else ""))
    out.append("}")
    with open(os.path.join(HERE, path), "w", newline="\n") as f:
        f.write("\n".join(out) + "\n")


lists = [open(p).read().splitlines() for p in sys.argv[1:]]
if not lists:
    sys.exit(__doc__)
for target in TARGETS:
    write(*target, lists)
