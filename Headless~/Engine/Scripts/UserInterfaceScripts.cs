using System.Collections.Generic;

namespace Host.Scripts
{
    /// <summary>The scripts of com.unity.ugui that scenes refer to by GUID.</summary>
    internal static class UserInterfaceScripts
    {
        static readonly Dictionary<string, string> Names = new Dictionary<string, string>
        {
            ["76c392e42b5098c458856cdf6ecaf363"] = "UnityEngine.EventSystems.EventSystem",
            ["4f231c4fb786f3946a6b90b886c48677"] = "UnityEngine.EventSystems.StandaloneInputModule",
            ["dc42784cf147c0c48a680349fa168899"] = "UnityEngine.UI.GraphicRaycaster",
            ["0cd44c1031e13a943bb63640046fad76"] = "UnityEngine.UI.CanvasScaler",
            ["5f7201a12d95ffc409449d95f23cf332"] = "UnityEngine.UI.Text",
            ["fe87c0e1cc204ed48ad3b37840f39efc"] = "UnityEngine.UI.Image",
            ["1344c3c82d62a2a41a3576d8abb8e3ea"] = "UnityEngine.UI.RawImage",
            ["4e29b1a8efbd4b44bb3f3716e73f07ff"] = "UnityEngine.UI.Button",
            ["9085046f02f69544eb97fd06b6048fe2"] = "UnityEngine.UI.Toggle",
            ["67db9e8f0e2ae9c40bc1e2b64352a6b4"] = "UnityEngine.UI.Slider",
            ["2a4db7a114972834c8e4117be1d82ba3"] = "UnityEngine.UI.Scrollbar",
            ["1aa08ab6e0800fa44ae55d278d1423e3"] = "UnityEngine.UI.ScrollRect",
            ["d199490a83bb2b844b9695cbf13b01ef"] = "UnityEngine.UI.InputField",
            ["0d0b652f32a2cc243917e4028fa0f046"] = "UnityEngine.UI.Dropdown",
            ["31a19414c41e5ae4aae2af33fee712f6"] = "UnityEngine.UI.Mask",
            ["e19747de3f5aca642ab2be37e372fb86"] = "UnityEngine.UI.Outline",
            ["cfabb0440166ab443bba8876756fdfa9"] = "UnityEngine.UI.Shadow",
            ["59f8146938fff824cb5fd77236b75775"] = "UnityEngine.UI.VerticalLayoutGroup",
            ["30649d3a9faa99c48a7b1166b86bf2a0"] = "UnityEngine.UI.HorizontalLayoutGroup",
            ["8a8695521f0d02e499659fee002a26c2"] = "UnityEngine.UI.GridLayoutGroup",
            ["3245ec927659c4140ac4f8d17403cc18"] = "UnityEngine.UI.ContentSizeFitter",
            ["306cc8c2b49d7114eaa3623786fc2126"] = "UnityEngine.UI.LayoutElement",
        };

        public static string NameOf(string guid) => Names.TryGetValue(guid, out var name) ? name : null;
    }
}
