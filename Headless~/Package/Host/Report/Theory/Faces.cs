using System;

namespace Host.Report
{
    /// <summary>One component of a velocity on faces of cells: averages what particles bring, changes it, gives it back in between.</summary>
    sealed class Faces
    {
        public readonly double[] Values, Changes;
        /// <summary>Set where particles brought something.</summary>
        public readonly bool[] Known;
        readonly double[] weights, before;
        readonly bool[] solved;
        readonly int width, height;
        readonly double offsetX, offsetY;

        /// <param name="offsetX">Of the first face, cells.</param>
        public Faces(int width, int height, double offsetX, double offsetY)
        {
            (this.width, this.height, this.offsetX, this.offsetY) = (width, height, offsetX, offsetY);
            Values = new double[width * height];
            Changes = new double[width * height];
            Known = new bool[width * height];
            weights = new double[width * height];
            before = new double[width * height];
            solved = new bool[width * height];
        }

        public void Clear()
        {
            Array.Clear(Values);
            Array.Clear(weights);
        }

        /// <param name="x">Cells.</param>
        public void Add(double x, double y, double value)
        {
            (int first, double u, double v) = FaceAt(x, y);
            for (int corner = 0; corner < 4; corner++)
            {
                double weight = Weight(corner, u, v);
                Values[Corner(first, corner)] += weight * value;
                weights[Corner(first, corner)] += weight;
            }
        }

        public void Average()
        {
            for (int k = 0; k < Values.Length; k++)
                if (Known[k] = weights[k] > 1e-9)
                    Values[k] /= weights[k];
            Array.Copy(Values, before, Values.Length);
        }

        /// <param name="gradient">Of a face, given this width; null where there is none.</param>
        public void Subtract(double factor, Func<int, int, double?> gradient)
        {
            for (int k = 0; k < Values.Length; k++)
            {
                double? difference = gradient(k, width);
                solved[k] = difference.HasValue;
                Values[k] -= factor * difference.GetValueOrDefault();
            }
        }

        /// <summary>Carries values and changes into the air around, a layer of faces at a time.</summary>
        public void Extend(int layers)
        {
            Spread(Values, solved, layers);
            for (int k = 0; k < Values.Length; k++)
                Changes[k] = Known[k] ? Values[k] - before[k] : 0;
            Spread(Changes, Known, layers);
        }

        public double At(double[] of, double x, double y)
        {
            (int first, double u, double v) = FaceAt(x, y);
            double sum = 0;
            for (int corner = 0; corner < 4; corner++)
                sum += Weight(corner, u, v) * of[Corner(first, corner)];
            return sum;
        }

        (int first, double u, double v) FaceAt(double x, double y)
        {
            double u = Math.Clamp(x - offsetX, 0, width - 1.001), v = Math.Clamp(y - offsetY, 0, height - 1.001);
            return ((int)v * width + (int)u, u - (int)u, v - (int)v);
        }

        int Corner(int first, int corner) => first + (corner & 1) + (corner >> 1) * width;

        static double Weight(int corner, double u, double v) => ((corner & 1) != 0 ? u : 1 - u) * ((corner >> 1) != 0 ? v : 1 - v);

        void Spread(double[] values, bool[] known, int layers)
        {
            var now = (bool[])known.Clone();
            for (int layer = 0; layer < layers; layer++)
            {
                var last = (bool[])now.Clone();
                for (int k = 0; k < values.Length; k++)
                {
                    if (last[k])
                        continue;
                    double sum = 0;
                    int count = 0;
                    void Take(bool inside, int other)
                    {
                        if (!inside || !last[other])
                            return;
                        sum += values[other];
                        count++;
                    }
                    int i = k % width, j = k / width;
                    Take(i > 0, k - 1);
                    Take(i < width - 1, k + 1);
                    Take(j > 0, k - width);
                    Take(j < height - 1, k + width);
                    if (count == 0)
                        continue;
                    values[k] = sum / count;
                    now[k] = true;
                }
            }
        }
    }
}
