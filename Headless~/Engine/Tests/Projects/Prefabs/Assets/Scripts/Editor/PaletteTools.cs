using UnityEditor;
using UnityEngine;

public static class PaletteTools
{
    [MenuItem("Towers/Select Palettes")]
    static void Select()
    {
        Selection.objects = Resources.FindObjectsOfTypeAll<Palette>();
    }
}
