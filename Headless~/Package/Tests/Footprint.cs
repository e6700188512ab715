using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using Rill;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>Trace of a piece of work: each kernel, with its variant, that the device was given, each pass drawn with, and the
    /// buffers alive.</summary>
    sealed class Footprint
    {
        /// <summary>"File.compute Kernel", "File.compute Kernel VARIANT", "File.shader", once for each dispatch or draw; sorted.</summary>
        public readonly List<string> Work;
        /// <summary>Names and bytes.</summary>
        public readonly List<string> Buffers;

        Footprint(IEnumerable<string> work)
        {
            Work = work.Select(Short).OrderBy(entry => entry, StringComparer.Ordinal).ToList();
            Buffers = BufferStorage.Live.Select(buffer => $"{buffer.Name} {buffer.Bytes}").OrderBy(entry => entry, StringComparer.Ordinal).ToList();
        }

        public static Footprint Of(Action work)
        {
            GpuWork.Log = new List<string>();
            try
            {
                work();
                return new Footprint(GpuWork.Log);
            }
            finally
            {
                GpuWork.Log = null;
            }
        }

        /// <summary>Footprint by the stages' own description.</summary>
        public static List<string> Explained(IEnumerable<StageDescription> stages) => stages.SelectMany(stage => stage.Kernels)
            .SelectMany(kernel => Enumerable.Repeat(Short(kernel.kernel), kernel.perStep)).OrderBy(entry => entry, StringComparer.Ordinal).ToList();

        /// <summary>"+2 File.compute Kernel", "-1 Rill.Buffer 64": from before to this.</summary>
        public List<string> Since(Footprint before) => Difference(before.Work, Work).Concat(Difference(before.Buffers, Buffers)).ToList();

        static IEnumerable<string> Difference(List<string> before, List<string> after) => before.Union(after)
            .Select(entry => (entry, change: after.Count(e => e == entry) - before.Count(e => e == entry)))
            .Where(pair => pair.change != 0).Select(pair => $"{pair.change:+0;-0} {pair.entry}").OrderBy(text => text, StringComparer.Ordinal);

        /// <summary>Short form of ".../PrefixSum.compute (SumTiles, VARIANT)" as the device has it and of "PrefixSum.compute: SumTiles [VARIANT]" as
        /// a stage says it; of a draw, its file.</summary>
        public static string Short(string entry)
        {
            Match match = Regex.Match(entry, @"(\w+\.compute)\W+(\w+)(?:\W+(\w+))?(?:\W+(\w+))?|(\w+\.shader)");
            return string.Join(" ", match.Groups.Cast<Group>().Skip(1).Where(group => group.Success).Select(group => group.Value));
        }
    }
}
