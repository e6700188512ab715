using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Serialization;

namespace Fixtures
{
    public enum Flow { Off = 0, Drip = 3, Jet = 7 }

    [Serializable]
    public struct Nozzle
    {
        public float radius;
        public Vector3 offset;
        [SerializeField] string label;
        public string Label => label;
    }

    [Serializable]
    public class Ramp
    {
        public int steps = 5;
        public float slope = 0.25f;
        public Ramp inner;
    }

    [Serializable] public abstract class Shape { public float size = 1; }
    [Serializable] public class Ball : Shape { public float bounce; }
    [Serializable] public class Box : Shape { public Vector3 edges; }

    public class EverythingBase : MonoBehaviour
    {
        [SerializeField] float inherited = 1.5f;
        public float Inherited => inherited;
    }

    /// <summary>A field of each kind that a scene can hold.</summary>
    public class Everything : EverythingBase, ISerializationCallbackReceiver
    {
        public bool flag;
        public byte small;
        public sbyte signedSmall;
        public short twoBytes;
        public ushort unsignedTwoBytes;
        public int number;
        public uint unsignedNumber;
        public long large;
        public ulong unsignedLarge;
        public float real;
        public double precise;
        public char letter;
        public string text;
        public string lines;
        public Flow flow;
        public Vector2 v2;
        public Vector3 v3;
        public Vector4 v4;
        public Vector2Int v2i;
        public Vector3Int v3i;
        public Quaternion turn;
        public Color color;
        public Color32 color32;
        public Rect rect;
        public Bounds bounds;
        public LayerMask mask;
        public Matrix4x4 matrix;
        public AnimationCurve curve;
        public Gradient gradient;
        public Hash128 hash;
        public float3 mathematicsVector;
        public int2 mathematicsInts;
        public quaternion mathematicsTurn;
        public Nozzle nozzle;
        public Ramp ramp;
        public List<Nozzle> nozzles;
        public List<Ramp> ramps;
        public int[] packed;
        public Flow[] packedFlows;
        public byte[] bytes;
        public bool[] flags;
        public float[] reals;
        public string[] names;
        public List<Vector3> points = new List<Vector3> { Vector3.up };
        public Transform target;
        public GameObject other;
        public Everything self;
        public ComputeShader compute;
        public Recipe recipe;
        public List<Recipe> recipes;
        [FormerlySerializedAs("oldName")] public float renamed;
        [FormerlySerializedAs("first"), FormerlySerializedAs("second")] [SerializeField] int renamedTwice = 3;
        [SerializeReference] public Shape shape;
        [SerializeReference] public List<Shape> shapes;

        [field: SerializeField] public float Viscosity { get; private set; }

        // Not stored by Unity, so a file cannot change them, and they stay null.
        public ComputeBuffer buffer;
        public Coroutine routine;
        public MaterialPropertyBlock block;
        [NonSerialized] public float transient = 8;
        float secret = 9;
        public readonly float constant = 10;
        public static float shared = 11;
        public Dictionary<string, int> table;
        public float[,] grid;

        // Absent from the file.
        public float kept = 42;
        public string neverNull;
        public List<int> neverNullList;
        public Ramp neverNullRamp;

        [NonSerialized] public int afterDeserialize;
        [NonSerialized] public float realSeenByCallback;

        public float Secret => secret;
        public int RenamedTwice => renamedTwice;

        public void OnBeforeSerialize() { }

        public void OnAfterDeserialize()
        {
            afterDeserialize++;
            realSeenByCallback = real;
        }
    }
}
