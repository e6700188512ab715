using System;

namespace UnityEngine
{
    public struct LayerMask
    {
        // The rest is the project's, filled from its TagManager.
        internal static readonly string[] Names = Defaults();

        int m_Mask;

        public int value { get => m_Mask; set => m_Mask = value; }
        public static implicit operator int(LayerMask mask) => mask.m_Mask;
        public static implicit operator LayerMask(int intVal) => new LayerMask { m_Mask = intVal };

        public static string LayerToName(int layer) => layer >= 0 && layer < 32 ? Names[layer] : "";
        public static int NameToLayer(string layerName) => string.IsNullOrEmpty(layerName) ? -1 : Array.IndexOf(Names, layerName);

        public static int GetMask(params string[] layerNames)
        {
            if (layerNames == null)
                throw new ArgumentNullException(nameof(layerNames));
            int mask = 0;
            foreach (string name in layerNames)
            {
                int layer = NameToLayer(name);
                if (layer >= 0)
                    mask |= 1 << layer;
            }
            return mask;
        }

        static string[] Defaults()
        {
            var names = new string[32];
            Array.Fill(names, "");
            names[0] = "Default";
            names[1] = "TransparentFX";
            names[2] = "Ignore Raycast";
            names[4] = "Water";
            names[5] = "UI";
            return names;
        }
    }
}
