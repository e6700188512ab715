using System.CommandLine;
using System.Linq;
using UnityEngine.Headless;

namespace Host.Commands
{
    /// <summary><c>--limits</c>: what the graphics API that is pretended grants programs.</summary>
    static class LimitsOption
    {
        public static Option<string> Create() => new Option<string>("--limits")
        {
            Description = $"What the graphics device grants: {string.Join(", ", ApiLimits.All.Select(limits => limits.Name))}. " +
                $"SystemInfo reports them, and what is beyond fails.", DefaultValueFactory = _ => ApiLimits.Direct3D11.Name,
        };

        /// <summary>To be called before a device is there.</summary>
        public static void Use(string name) => Player.Limits = ApiLimits.All.FirstOrDefault(limits => limits.Name == name)
            ?? throw new HostException($"--limits {name}: there are {string.Join(", ", ApiLimits.All.Select(limits => limits.Name))}.");
    }
}
