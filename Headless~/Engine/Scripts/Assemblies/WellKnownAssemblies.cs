using System.Collections.Generic;

namespace Host.Scripts.Assemblies
{
    /// <summary>Assembly definitions of Unity's packages by GUID, as other assembly definitions refer to them.</summary>
    internal static class WellKnownAssemblies
    {
        static readonly Dictionary<string, string> Names = new Dictionary<string, string>
        {
            ["d8b63aba1907145bea998dd612889d6b"] = "Unity.Mathematics",
            ["2bafac87e7f4b9b418d9448d219b01ab"] = "UnityEngine.UI",
            ["6055be8ebefd69e48b49212b09b47b2f"] = "Unity.TextMeshPro",
            ["2665a8d13d1b3f18800f46e256720795"] = "Unity.Burst",
            ["e0cd26848372d4e5c891c569017e11f1"] = "Unity.Collections",
            ["75469ad4d38634e559750d17036d5f7c"] = "Unity.InputSystem",
            ["df380645f10b7bc4b97d4f5eb6303d95"] = "Unity.RenderPipelines.Core.Runtime",
            ["15fc0a57446b3144c949da3e2b9737a9"] = "Unity.RenderPipelines.Universal.Runtime",
            ["457756d89b35d2941b3e7b37b4ece6f1"] = "Unity.RenderPipelines.HighDefinition.Runtime",
            ["27619889b8ba8c24980f49ee34dbb44a"] = "UnityEngine.TestRunner",
            ["0acc523941302664db1f4e527237feb3"] = "UnityEditor.TestRunner",
        };

        public static string NameOf(string guid) => Names.TryGetValue(guid, out var name) ? name : null;
    }
}
