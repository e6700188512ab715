using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using UnityEngine;

namespace Host.Assets
{
    /// <summary>Engine types whose text form is not simply the list of their fields.</summary>
    internal static class BuiltInValues
    {
        public static bool Has(Type type) => Readers.ContainsKey(type);

        /// <summary>False for a type that is read field by field.</summary>
        public static bool TryRead(Type type, YamlNode node, out object value)
        {
            if (Readers.TryGetValue(type, out var read))
            {
                value = read(node);
                return true;
            }
            value = null;
            return false;
        }

        static readonly Dictionary<Type, Func<YamlNode, object>> Readers = new Dictionary<Type, Func<YamlNode, object>>
        {
            [typeof(Vector2)] = n => new Vector2(n.Float("x"), n.Float("y")),
            [typeof(Vector3)] = n => Vector3(n),
            [typeof(Vector4)] = n => Vector4(n),
            [typeof(Vector2Int)] = n => new Vector2Int(n.Int("x"), n.Int("y")),
            [typeof(Vector3Int)] = n => new Vector3Int(n.Int("x"), n.Int("y"), n.Int("z")),
            [typeof(Quaternion)] = n => Quaternion(n),
            [typeof(Color)] = n => Color(n),
            [typeof(Color32)] = n => Color32(n),
            [typeof(Rect)] = n => new Rect(n.Float("x"), n.Float("y"), n.Float("width"), n.Float("height")),
            [typeof(RectInt)] = n => new RectInt(n.Int("x"), n.Int("y"), n.Int("width"), n.Int("height")),
            // The file holds the half size.
            [typeof(Bounds)] = n => new Bounds(Vector3(n["m_Center"]), 2 * Vector3(n["m_Extent"])),
            [typeof(LayerMask)] = n => new LayerMask { value = n.Int("m_Bits") },
            [typeof(Matrix4x4)] = n => Matrix(n),
            [typeof(AnimationCurve)] = n => Curve(n),
            [typeof(Gradient)] = n => Gradient(n),
            [typeof(Hash128)] = n => Hash128.Parse(n.Text("Hash")),
        };

        public static Vector3 Vector3(YamlNode n, Vector3 otherwise = default)
            => n == null ? otherwise : new Vector3(n.Float("x"), n.Float("y"), n.Float("z"));
        public static Vector4 Vector4(YamlNode n) => n == null ? default : new Vector4(n.Float("x"), n.Float("y"), n.Float("z"), n.Float("w"));
        public static Quaternion Quaternion(YamlNode n) => n == null ? UnityEngine.Quaternion.identity
            : new Quaternion(n.Float("x"), n.Float("y"), n.Float("z"), n.Float("w", 1));
        public static Color Color(YamlNode n, Color otherwise = default)
            => n == null ? otherwise : new Color(n.Float("r"), n.Float("g"), n.Float("b"), n.Float("a", 1));

        /// <summary>One number, red in its lowest byte; files of old editors have four floats.</summary>
        static Color32 Color32(YamlNode n)
        {
            if (n["rgba"] is YamlScalar packed)
            {
                var bits = unchecked((uint)packed.ToLong());
                return new Color32((byte)bits, (byte)(bits >> 8), (byte)(bits >> 16), (byte)(bits >> 24));
            }
            return new Color32((byte)n.Int("r"), (byte)n.Int("g"), (byte)n.Int("b"), (byte)n.Int("a"));
        }

        static Matrix4x4 Matrix(YamlNode n)
        {
            var matrix = new Matrix4x4();
            for (var row = 0; row < 4; row++)
                for (var column = 0; column < 4; column++)
                    matrix[row, column] = n.Float(string.Create(CultureInfo.InvariantCulture, $"e{row}{column}"));
            return matrix;
        }

        static AnimationCurve Curve(YamlNode n)
        {
            var keys = n.Items("m_Curve").Select(k =>
            {
                var key = new Keyframe(k.Float("time"), k.Float("value"), k.Float("inSlope"), k.Float("outSlope"), k.Float("inWeight"),
                    k.Float("outWeight"));
                key.weightedMode = (WeightedMode)k.Int("weightedMode");
                return key;
            });
            return new AnimationCurve(keys.ToArray()) { preWrapMode = Wrap(n.Int("m_PreInfinity", 2)),
                postWrapMode = Wrap(n.Int("m_PostInfinity", 2)) };
        }

        /// <summary>Files number the modes differently from the API: 0 ping-pong, 1 loop, 2 clamp.</summary>
        static WrapMode Wrap(int stored) => stored switch { 0 => WrapMode.PingPong, 1 => WrapMode.Loop, _ => WrapMode.ClampForever };

        /// <summary>Eight colors and sixteen times, of which the first so many count; times are 16-bit fractions, alpha lies in key's a.</summary>
        static Gradient Gradient(YamlNode n)
        {
            float Time(string key) => n.Int(key) / 65535f;
            var colors = Enumerable.Range(0, n.Int("m_NumColorKeys", 2)).Select(i => new GradientColorKey(Color(n["key" + i]), Time("ctime" + i)));
            var alphas = Enumerable.Range(0, n.Int("m_NumAlphaKeys", 2)).Select(i => new GradientAlphaKey(Color(n["key" + i]).a, Time("atime" + i)));
            var gradient = new Gradient { mode = (GradientMode)n.Int("m_Mode") };
            gradient.SetKeys(colors.ToArray(), alphas.ToArray());
            return gradient;
        }
    }
}
