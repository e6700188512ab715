using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>Center and inertia of solid shapes of one density.</summary>
    internal sealed class MassParts
    {
        struct Part
        {
            public float Volume;
            public Vector3 Center, Tensor;      // the tensor of a mass of 1 about its own axes, m²
            public Quaternion Rotation;
        }

        readonly List<Part> parts = new List<Part>();

        public float Volume { get; private set; }       // m³

        public Vector3 Center
        {
            get
            {
                Vector3 sum = Vector3.zero;
                foreach (Part part in parts)
                    sum += part.Center * part.Volume;
                return Volume > 0f ? sum / Volume : Vector3.zero;
            }
        }

        /// <summary>A hull counts as the box around it; triangles have no volume.</summary>
        public void Add(in ShapeDescription shape, BodyPose pose)
        {
            var part = new Part { Center = pose.Position, Rotation = pose.Rotation };
            switch (shape.Kind)
            {
                case ShapeKind.Box:
                    part.Volume = 8f * shape.Size.x * shape.Size.y * shape.Size.z;
                    part.Tensor = BoxTensor(2f * shape.Size);
                    break;
                case ShapeKind.Sphere:
                    part.Volume = 4f / 3f * Mathf.PI * shape.Size.x * shape.Size.x * shape.Size.x;
                    part.Tensor = Vector3.one * (0.4f * shape.Size.x * shape.Size.x);
                    break;
                case ShapeKind.Capsule:
                    part.Volume = Mathf.PI * shape.Size.x * shape.Size.x * (2f * shape.Size.y + 4f / 3f * shape.Size.x);
                    part.Tensor = CapsuleTensor(shape.Size.x, 2f * shape.Size.y, shape.Axis);
                    break;
                case ShapeKind.Hull:
                    Bounds bounds = shape.LocalBounds();
                    part.Volume = bounds.size.x * bounds.size.y * bounds.size.z;
                    part.Tensor = BoxTensor(bounds.size);
                    part.Center += pose.Rotation * bounds.center;
                    break;
            }
            if (part.Volume <= 0f)
                return;
            parts.Add(part);
            Volume += part.Volume;
        }

        /// <summary>Tensor of a mass of 1, m².</summary>
        public static Vector3 BoxTensor(Vector3 size)
        {
            Vector3 squares = Vector3.Scale(size, size) * (1f / 12f);
            return new Vector3(squares.y + squares.z, squares.z + squares.x, squares.x + squares.y);
        }

        // A cylinder with two halves of a ball, moved out by 3/8 of their radius.
        static Vector3 CapsuleTensor(float radius, float length, int axis)
        {
            float cylinder = length / (length + 4f / 3f * radius), ball = 1f - cylinder, square = radius * radius;
            float along = cylinder * square / 2f + ball * 0.4f * square;
            float across = cylinder * (square / 4f + length * length / 12f)
                + ball * (0.4f * square + length * length / 4f + 3f / 8f * length * radius);
            Vector3 tensor = Vector3.one * across;
            tensor[axis] = along;
            return tensor;
        }

        /// <summary>Principal moments about a center, kg m², and the axes that they are about.</summary>
        public void FindTensor(float mass, Vector3 center, out Vector3 tensor, out Quaternion axes)
        {
            var sum = new float[3, 3];
            foreach (Part part in parts)
                AddTensor(sum, part, mass * part.Volume / Volume, part.Center - center);
            PrincipalAxes.Find(sum, out tensor, out axes);
        }

        static void AddTensor(float[,] sum, Part part, float mass, Vector3 arm)
        {
            Vector3 x = part.Rotation * Vector3.right, y = part.Rotation * Vector3.up, z = part.Rotation * Vector3.forward;
            for (int i = 0; i < 3; i++)
                for (int j = 0; j < 3; j++)
                    sum[i, j] += mass * (x[i] * x[j] * part.Tensor.x + y[i] * y[j] * part.Tensor.y + z[i] * z[j] * part.Tensor.z
                        + (i == j ? arm.sqrMagnitude : 0f) - arm[i] * arm[j]);
        }
    }
}
