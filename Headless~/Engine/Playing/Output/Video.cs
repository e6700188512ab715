using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;

namespace Host.Output
{
    /// <summary>Output of ffmpeg for the frames: a film and a contact sheet.</summary>
    static class Video
    {
        public static void Encode(string framePattern, double framesPerSecond, string target) => Tool.Ffmpeg.Run(new[]
        {
            "-y", "-loglevel", "error", "-framerate", framesPerSecond.ToString(CultureInfo.InvariantCulture), "-i", framePattern,
            // H.264 in its usual layout halves the chroma, so both sides must be even.
            "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "20", "-movflags", "+faststart", target,
        });

        /// <summary>About twelve frames, first and last among them, with their times.</summary>
        public static void ContactSheet(IReadOnlyList<(string File, double Time)> frames, string target, int columns = 4, int rows = 3,
            int width = 480)
        {
            int[] chosen = Spread(frames.Count, columns * rows);
            rows = (chosen.Length + columns - 1) / columns;
            columns = System.Math.Min(columns, chosen.Length);

            var arguments = new List<string> { "-y", "-loglevel", "error" };
            var filter = new StringBuilder();
            for (int i = 0; i < chosen.Length; i++)
            {
                (string file, double time) = frames[chosen[i]];
                arguments.AddRange(new[] { "-i", file });
                string label = time.ToString("0.00", CultureInfo.InvariantCulture) + " s";
                filter.Append($"[{i}:v]scale={width}:-2,setsar=1,drawtext=font=DejaVu " +
                    $"Sans:text='{label}':x=8:y=h-26:fontsize=18:fontcolor=white:box=1:boxcolor=black@0.55:boxborderw=5[v{i}];");
            }
            filter.Append(string.Concat(Enumerable.Range(0, chosen.Length).Select(i => $"[v{i}]")));
            filter.Append($"concat=n={chosen.Length}:v=1:a=0,tile={columns}x{rows}:padding=4:color=0x202020");
            arguments.AddRange(new[] { "-filter_complex", filter.ToString(), "-frames:v", "1", target });
            Tool.Ffmpeg.Run(arguments);
        }

        /// <summary>At most 'wanted' of 'count' indices, evenly spread, ends included.</summary>
        public static int[] Spread(int count, int wanted)
        {
            if (count <= wanted)
                return Enumerable.Range(0, count).ToArray();
            return Enumerable.Range(0, wanted).Select(i => (int)((long)i * (count - 1) / (wanted - 1))).ToArray();
        }
    }
}
