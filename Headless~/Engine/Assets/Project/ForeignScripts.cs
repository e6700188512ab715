using System.Collections.Generic;

namespace Host.Assets
{
    /// <summary>
    /// Scripts of Unity's own packages that its menus put into almost every scene. They configure what the host does not
    /// have, so they are left out of a scene with a note instead of counting as broken references.
    /// </summary>
    internal static class ForeignScripts
    {
        static readonly Dictionary<string, string> Names = new Dictionary<string, string>
        {
            ["a79441f348de89743a2939f4d699eac1"] = "Universal Render Pipeline, camera data",
            ["474bcb49853aa07438625e644c072ee6"] = "Universal Render Pipeline, light data",
            ["23c1ce4fb46143f46bc5cb5224c934f6"] = "High Definition Render Pipeline, camera data",
            ["7a68c43fe1f2a47cfa234b5eeaa98012"] = "High Definition Render Pipeline, light data",
            ["76c392e42b5098c458856cdf6ecaf363"] = "Unity UI, EventSystem",
            ["4f231c4fb786f3946a6b90b886c48677"] = "Unity UI, StandaloneInputModule",
            ["dc42784cf147c0c48a680349fa168899"] = "Unity UI, GraphicRaycaster",
            ["0cd44c1031e13a943bb63640046fad76"] = "Unity UI, CanvasScaler",
        };

        public static string NameOf(string guid) => guid != null && Names.TryGetValue(guid, out var name) ? name : null;
    }
}
