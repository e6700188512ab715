using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>Pipelines made from compiled programs, one each for the life of the device.</summary>
    internal static class DeviceObjects
    {
        static readonly Dictionary<ShaderProgram, DeviceKernel> kernels = new Dictionary<ShaderProgram, DeviceKernel>();
        static readonly Dictionary<(ShaderProgram, ShaderProgram), DevicePass> passes = new Dictionary<(ShaderProgram, ShaderProgram), DevicePass>();

        /// <summary>How many have been made since the start: a frame that raises it has waited for a compiler.</summary>
        public static int Made;

        public static DeviceKernel Kernel(ShaderProgram program)
        {
            if (kernels.TryGetValue(program, out DeviceKernel kernel))
                return kernel;
            Made++;
            kernels.Add(program, kernel = Gpu.Device.CreateKernel(program));
            return kernel;
        }

        public static DevicePass Pass(ShaderProgram vertex, ShaderProgram fragment)
        {
            if (!passes.TryGetValue((vertex, fragment), out DevicePass pass))
                passes.Add((vertex, fragment), pass = Gpu.DrawDevice.CreatePass(vertex, fragment));
            return pass;
        }

        public static void Clear()
        {
            foreach (DeviceKernel kernel in kernels.Values)
                kernel.Dispose();
            foreach (DevicePass pass in passes.Values)
                pass.Dispose();
            kernels.Clear();
            passes.Clear();
        }
    }
}
