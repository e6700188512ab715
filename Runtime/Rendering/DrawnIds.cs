using UnityEngine;

namespace Rill
{
    /// <summary>Properties that several shaders of drawn water share; see DrawnDomain.hlsl, MeshVertex.hlsl and FoamShading.hlsl.</summary>
    static class DrawnIds
    {
        public static readonly int DomainToWorld = Shader.PropertyToID("_DomainToWorld");
        public static readonly int LastDomainToWorld = Shader.PropertyToID("_LastDomainToWorld");
        public static readonly int WorldToDomain = Shader.PropertyToID("_WorldToDomain");
        public static readonly int DrawnDomainSize = Shader.PropertyToID("_DrawnDomainSize");
        public static readonly int FrameLag = Shader.PropertyToID("_FrameLag");
        public static readonly int MeshVertices = Shader.PropertyToID("_MeshVertices");
        public static readonly int MeshCounters = Shader.PropertyToID("_MeshCounters");
        public static readonly int FoamParticles = Shader.PropertyToID("_FoamParticles");
        public static readonly int FoamLook = Shader.PropertyToID("_FoamLook");
        public static readonly int AmbientColor = Shader.PropertyToID("_AmbientColor");
    }
}
