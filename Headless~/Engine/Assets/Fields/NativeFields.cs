using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;

namespace Host.Assets
{
    /// <summary>
    /// Fills an engine object (Camera, Light, RenderSettings ...) from its document: a key sets the property of its name,
    /// "m_FieldOfView" and "field of view" both fieldOfView. What the host's class lacks, it does not need.
    /// </summary>
    internal static class NativeFields
    {
        // Keys whose property is called differently; an empty name: not to be set.
        static readonly Dictionary<string, string> Renamed = new Dictionary<string, string>
        {
            ["Camera.m_NormalizedViewPortRect"] = "rect", ["Camera.m_HDR"] = "allowHDR",
            ["MeshFilter.m_Mesh"] = "sharedMesh", ["MeshCollider.m_Mesh"] = "sharedMesh", ["SkinnedMeshRenderer.m_Mesh"] = "sharedMesh",
            ["Renderer.m_Materials"] = "sharedMaterials", ["Renderer.m_CastShadows"] = "shadowCastingMode",
            ["RenderSettings.m_LinearFogStart"] = "fogStartDistance", ["RenderSettings.m_LinearFogEnd"] = "fogEndDistance",
            ["RenderSettings.m_SkyboxMaterial"] = "skybox", ["RenderSettings.m_CustomReflection"] = "customReflectionTexture",
                ["Collider.m_Material"] = "sharedMaterial",
            ["Rigidbody.m_LinearDamping"] = "drag", ["Rigidbody.m_AngularDamping"] = "angularDrag", ["Rigidbody.m_Interpolate"] = "interpolation",
            ["Rigidbody.m_CollisionDetection"] = "collisionDetectionMode", ["Rigidbody.m_InertiaRotation"] = "inertiaTensorRotation",
            // After the tensor and the center, which they take back.
            ["Rigidbody.m_ImplicitCom"] = "automaticCenterOfMass", ["Rigidbody.m_ImplicitTensor"] = "automaticInertiaTensor",
            // Set with the object itself; a tag or name is not a property of these.
            ["Object.m_Name"] = "", ["Object.m_ObjectHideFlags"] = "", ["Component.m_GameObject"] = "",
        };

        static readonly Dictionary<Type, Dictionary<string, PropertyInfo>> Known = new Dictionary<Type, Dictionary<string, PropertyInfo>>();

        /// <param name="target">Null for a class of static properties.</param>
        public static void Read(object target, Type type, YamlMapping fields, FieldReader reader, ReadScope scope)
            => Read(target, type, fields, reader, scope, _ => true);

        /// <summary>Reads those properties of a stub that merely hold a value; the others throw.</summary>
        public static void ReadStub(object target, YamlMapping fields, FieldReader reader, ReadScope scope) =>
            Read(target, target.GetType(), fields, reader, scope, p => p.GetMethod?.IsDefined(typeof(CompilerGeneratedAttribute)) == true
            || p.DeclaringType.Assembly == typeof(UnityEngine.Object).Assembly);

        static void Read(object target, Type type, YamlMapping fields, FieldReader reader, ReadScope scope, Func<PropertyInfo, bool> which)
        {
            foreach (var entry in fields.Entries)
            {
                var property = PropertyOf(type, entry.Key);
                if (property == null || !which(property)) continue;
                var node = Unwrap(property.PropertyType, entry.Value);
                scope.Enter(entry.Key);
                if (reader.TryRead(property.PropertyType, null, node, scope, out var value))
                    property.SetValue(target, value, BindingFlags.DoNotWrapExceptions, null, null, null);
                scope.Leave();
            }
        }

        /// <summary>Masks are groups around one number (m_Bits), a light's shadows a group with their type.</summary>
        static YamlNode Unwrap(Type type, YamlNode node) =>
            type == typeof(int) && node["m_Bits"] is YamlNode bits ? bits : type.IsEnum && node["m_Type"] is YamlNode kind ? kind : node;

        static PropertyInfo PropertyOf(Type type, string key)
        {
            if (!Known.TryGetValue(type, out var properties))
                Known[type] = properties = type.GetProperties(BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public)
                    .Where(p => p.GetSetMethod() != null && p.GetIndexParameters().Length == 0)
                    .GroupBy(p => p.Name.ToLowerInvariant()).ToDictionary(g => g.Key, g => g.First());

            for (var at = type; at != null; at = at.BaseType)
                if (Renamed.TryGetValue(at.Name + "." + key, out var renamed))
                    return properties.TryGetValue(renamed.ToLowerInvariant(), out var found) ? found : null;

            var name = (key.StartsWith("m_", StringComparison.Ordinal) ? key.Substring(2) : key).Replace(" ", "").ToLowerInvariant();
            return properties.TryGetValue(name, out var property) ? property : null;
        }
    }
}
