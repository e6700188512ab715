using System;
using System.Reflection;
using System.Runtime.InteropServices;

namespace UnityEngine.Headless
{
    /// <summary>Source of the matrices of a draw's instances, which decides a keyword of the shader.</summary>
    internal enum Instancing { None, Matrices, Procedural }

    /// <summary>GPU instancing: as many instances a draw as the shader's arrays hold (UnityInstancing.cginc).</summary>
    internal static class Instances
    {
        public const int Modes = 3;
        const int ArraySize = 500;
        const string MatricesKeyword = "INSTANCING_ON", ProceduralKeyword = "PROCEDURAL_INSTANCING_ON";

        static readonly int toWorld = Shader.PropertyToID("unity_ObjectToWorldArray"), toObject = Shader.PropertyToID("unity_WorldToObjectArray");
        static readonly Matrix4x4[] matrices = new Matrix4x4[ArraySize], inverses = new Matrix4x4[ArraySize];

        public static string Keyword(Instancing instancing) =>
            instancing == Instancing.Matrices ? MatricesKeyword : instancing == Instancing.Procedural ? ProceduralKeyword : null;

        /// <summary>A call with matrices. A shader without instancing gets one draw a matrix: the same picture.</summary>
        public static void Draw(in DrawCall call, int pass)
        {
            DrawCall part = call;
            part.Matrices = null;
            if (Array.IndexOf(call.Material.shader.Keywords.Names, MatricesKeyword) < 0)
            {
                (part.Instancing, part.Instances) = (Instancing.None, 1);
                foreach (Matrix4x4 matrix in call.Matrices)
                {
                    part.Matrix = matrix;
                    Drawing.Draw(part, pass, 0);
                }
                return;
            }
            for (int first = 0; first < call.Matrices.Length; first += ArraySize)
            {
                int count = Math.Min(ArraySize, call.Matrices.Length - first);
                for (int i = 0; i < count; i++)
                {
                    matrices[i] = call.Matrices[first + i];
                    inverses[i] = matrices[i].inverse;
                }
                Shader.Globals.Set(toWorld, PropertyKind.Matrix, true, MemoryMarshal.AsBytes<Matrix4x4>(matrices.AsSpan(0, count)));
                Shader.Globals.Set(toObject, PropertyKind.Matrix, true, MemoryMarshal.AsBytes<Matrix4x4>(inverses.AsSpan(0, count)));
                (part.Instancing, part.Instances, part.Matrix) = (Instancing.Matrices, count, matrices[0]);
                Drawing.Draw(part, pass, first);
            }
        }

        /// <summary>Matrices of RenderMeshInstanced: Matrix4x4, or a struct with a field objectToWorld.</summary>
        public static Matrix4x4[] MatricesOf<T>(T[] data, int start, int count) where T : unmanaged
        {
            var result = new Matrix4x4[count];
            if (data is Matrix4x4[] plain)
            {
                Array.Copy(plain, start, result, 0, count);
                return result;
            }
            FieldInfo field = typeof(T).GetField("objectToWorld", BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic);
            if (field == null || field.FieldType != typeof(Matrix4x4))
                throw new ArgumentException($"RenderMeshInstanced<{typeof(T).Name}>: the instance data must be Matrix4x4 or have a " +
                    $"member 'objectToWorld' of that type.");
            for (int i = 0; i < count; i++)
                result[i] = (Matrix4x4)field.GetValue(data[start + i]);
            return result;
        }
    }
}
