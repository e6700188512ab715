using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Rendering;

namespace Host.Assets
{
    /// <summary>A .mat file's values into a Material.</summary>
    internal static class MaterialReader
    {
        /// <summary>Null when its shader is none; that was reported.</summary>
        public static Material Make(YamlMapping fields, ReferenceResolver resolve, ReadScope scope)
        {
            scope.Enter("m_Shader");
            var shader = (Shader)resolve(fields.Reference("m_Shader"), typeof(Shader), scope);
            scope.Leave();
            return shader == null ? null : new Material(shader);
        }

        public static void Read(Material material, YamlMapping fields, ReferenceResolver resolve, ReadScope scope)
        {
            T Find<T>(YamlNode node, string key) where T : UnityEngine.Object
            {
                // A slot that was never filled stands in the file all the same.
                if (FileReference.Of(node).IsNone) return null;
                scope.Enter(key);
                var found = (T)resolve(FileReference.Of(node), typeof(T), scope);
                scope.Leave();
                return found;
            }

            // A material variant holds only what differs from its parent.
            if (!fields.Reference("m_Parent").IsNone && Find<Material>(fields["m_Parent"], "m_Parent") is Material parent)
                material.CopyPropertiesFromMaterial(parent);

            var saved = fields["m_SavedProperties"];
            foreach (var (name, value) in Properties(saved, "m_TexEnvs"))
            {
                if (Find<Texture>(value["m_Texture"], name) is Texture texture) material.SetTexture(name, texture);
                material.SetTextureScale(name, new Vector2(value["m_Scale"].Float("x", 1), value["m_Scale"].Float("y", 1)));
                material.SetTextureOffset(name, new Vector2(value["m_Offset"].Float("x"), value["m_Offset"].Float("y")));
            }
            foreach (var (name, value) in Properties(saved, "m_Ints")) material.SetInteger(name, ((YamlScalar)value).ToInt());
            foreach (var (name, value) in Properties(saved, "m_Floats")) material.SetFloat(name, ((YamlScalar)value).ToFloat());
            foreach (var (name, value) in Properties(saved, "m_Colors"))
            {
                // Colors and vectors are in one list; only colors are converted to linear space, so the shader decides.
                var color = BuiltInValues.Color(value);
                if (IsVector(material.shader, name)) material.SetVector(name, color);
                else material.SetColor(name, color);
            }

            foreach (var keyword in Keywords(fields)) material.EnableKeyword(keyword);
            foreach (var pass in fields.Items("disabledShaderPasses").OfType<YamlScalar>()) material.SetShaderPassEnabled(pass.Value, false);
            material.enableInstancing = fields.Bool("m_EnableInstancingVariants");
            var queue = fields.Int("m_CustomRenderQueue", -1);
            if (queue >= 0) material.renderQueue = queue;
        }

        static bool IsVector(Shader shader, string name)
        {
            var index = shader.FindPropertyIndex(name);
            return index >= 0 && shader.GetPropertyType(index) == ShaderPropertyType.Vector;
        }

        /// <summary>Editors since 2021.2 keep a list, earlier ones a line of words.</summary>
        static IEnumerable<string> Keywords(YamlMapping fields) =>
            fields.Items("m_ValidKeywords").OfType<YamlScalar>().Select(k => k.Value)
                .Concat(fields.Text("m_ShaderKeywords").Split(' ', StringSplitOptions.RemoveEmptyEntries));

        /// <summary>"- _Color: value" each; editors before 5.5 wrote "data: { first: { name: _Color }, second: value }".</summary>
        static IEnumerable<(string name, YamlNode value)> Properties(YamlNode saved, string list)
        {
            var groups = saved?[list] is YamlMapping old ? old.Entries.Select(e => e.Value) : saved?.Items(list) ?? Enumerable.Empty<YamlNode>();
            foreach (var group in groups.OfType<YamlMapping>())
                if (group["second"] != null) yield return (group["first"].Text("name"), group["second"]);
                else
                    foreach (var entry in group.Entries) yield return (entry.Key, entry.Value);
        }
    }
}
